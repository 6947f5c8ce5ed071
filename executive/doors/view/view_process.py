"""The process of the page: started by ``executive serve --view``, ended with it."""

from __future__ import annotations

import sys
from pathlib import Path

from executive.doors.companion import LeftBehind
from executive.doors.view.access import HERE, Access, new_token
from executive.doors.view.page_server import PageServer
from executive.doors.view.viewer import Viewer
from executive.ending_signals import taken_by
from executive.errors import UserError
from robots.live.wire.errors import LiveError


def main(folder: str, port: str) -> int:
    """Show the robot that is served in a folder until a signal ends it."""
    signals: list[int] = []
    token = new_token()
    access = Access(token)
    try:
        with taken_by(signals.append):
            server = PageServer(int(port), access, "robot")
            viewer = Viewer(Path(folder), server, access, LeftBehind(Path(folder), signals))
            sys.stderr.write(f"the page is at http://{HERE[0]}:{server.port}/?token={token}\n")
            sys.stderr.flush()
            viewer.run()
            server.close()
    except (LiveError, UserError) as wrong:
        sys.stderr.write(f"executive: the page ended: {wrong}\n")
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
