"""A peer that sends velocities at 50 Hz, unsteadily, until it is killed; prints control time at each sample.

Arguments: folder of the served robot, domain, "twist" or "stamped", forward speed in m/s, turning speed in
rad/s, share of samples that are left out, seed.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np

from executive.doors.ros.graph import RosNode, best_effort
from executive.doors.ros.messages import Twist, TwistStamped, Vector3
from executive.doors.ros.settings import RosSettings
from robots.clock import WallClock
from robots.live.wire.runtime_folder import RuntimeFolder
from robots.live.wire.state_slot import StateSlotReader

_PERIOD_S = 0.02
_JITTER = 0.8
_LOOK_S = 0.01


def main(folder: str, domain: str, kind: str, forward: str, turning: str, left_out: str, seed: str) -> None:
    """Send until killed."""
    rng, wall = np.random.default_rng(int(seed)), WallClock()
    slot = StateSlotReader(RuntimeFolder(Path(folder)).state_slot)
    node = RosNode(RosSettings(int(domain), node="velocity_peer"))
    writer = node.writer("/cmd_vel", TwistStamped if kind == "stamped" else Twist, best_effort(1))
    twist = Twist(Vector3(float(forward)), Vector3(z=float(turning)))
    sample = TwistStamped(twist=twist) if kind == "stamped" else twist
    while not writer.get_matched_subscriptions():
        wall.sleep(_LOOK_S)
    now_s = 0.0
    while True:
        wall.sleep(_PERIOD_S * (1.0 + _JITTER * float(rng.uniform(-1.0, 1.0))))
        if rng.random() < float(left_out):
            continue
        row = slot.newest()
        now_s = now_s if row is None else float(row[0])
        print(now_s, flush=True)  # before it is sent: who is killed in between is judged more strictly
        writer.write(sample)


if __name__ == "__main__":
    main(*sys.argv[1:])
