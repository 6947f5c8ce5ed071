"""The bare side of suite ``ros``: joint states of a robot's size, at the state slot's rate, until killed.

Arguments: domain, topic, number of joints.
"""

from __future__ import annotations

import sys

from executive.doors.ros.graph import RosNode, reliable
from executive.doors.ros.messages import Header, JointState, Time
from executive.doors.ros.settings import RosSettings
from robots.clock import WallClock, utc_ns

_PERIOD_S = 0.01


def main(domain: str, topic: str, joints: str) -> None:
    """Write until killed."""
    node = RosNode(RosSettings(int(domain), node="bare"))  # its writers live as long as it does
    writer = node.writer(topic, JointState, reliable())
    names, values, wall = (
        [f"joint_{i}_of_a_robot" for i in range(int(joints))],
        [0.1] * int(joints),
        WallClock(),
    )
    while True:
        wall.sleep(_PERIOD_S)
        stamp = Time(*divmod(utc_ns(), 1_000_000_000))
        writer.write(JointState(Header(stamp, ""), names, values, values, values))


if __name__ == "__main__":
    main(*sys.argv[1:])
