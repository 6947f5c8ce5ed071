"""Whether a motion begins and ends at rest, as whatever streams it has to hold its first and last sample.

The checker and the streamer ask by the same bound: a motion that is safe for the one is not refused as
moving by the other.
"""

from __future__ import annotations

import numpy as np

from kinematics.motion.trajectory import Trajectory
from kinematics.motion.verdict import Finding, FindingKind

AT_REST = 1e-3
"""Speed, rad/s and m/s, that counts as rest at both ends."""

_BASE = ("base velocity", "base angular velocity")


def rest_findings(trajectory: Trajectory) -> list[Finding]:
    """What moves at either end of a motion: one finding for each joint, and for the base's path and turn.

    Every trajectory is judged as one that is played alone, from rest to rest: nothing streams the parts of
    a longer motion one after another.
    """
    ends = np.abs(trajectory.v[[0, -1]])
    if ends.max() <= AT_REST:
        return []
    speeds = np.column_stack([ends[:, :3].max(axis=1), ends[:, 3:6].max(axis=1), ends[:, 6:]])
    subjects = (*_BASE, *trajectory.joints)
    at_s = (0.0, trajectory.duration_s)
    return [
        Finding(
            FindingKind.BOUNDARY_VELOCITY,
            at_s[int(np.argmax(speeds[:, k] > AT_REST))],
            (subjects[k],),
            float(speeds[:, k].max()),
            AT_REST,
        )
        for k in np.flatnonzero(speeds.max(axis=0) > AT_REST)
    ]
