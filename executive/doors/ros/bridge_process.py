"""The process of the ROS bridge: started by ``executive serve --ros``, ended with it."""

from __future__ import annotations

import sys
from pathlib import Path

from executive.doors.companion import LeftBehind
from executive.doors.ros.bridge import bridge
from executive.doors.ros.settings import RosSettings
from executive.ending_signals import taken_by
from executive.errors import UserError
from robots.live.wire.errors import LiveError


def main(folder: str, domain: str, namespace: str, interface: str) -> int:
    """Bridge the robot that is served in a folder until a signal ends it."""
    signals: list[int] = []
    settings = RosSettings(int(domain), namespace, interface)
    try:
        with taken_by(signals.append):
            bridge(Path(folder), settings, LeftBehind(Path(folder), signals))
    except (LiveError, UserError) as wrong:
        sys.stderr.write(f"executive: the ROS bridge ended: {wrong}\n")
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
