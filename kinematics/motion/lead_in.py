"""The short piece that closes the gap between where a robot is and where its trajectory begins."""

from __future__ import annotations

import numpy as np

from kinematics.arrays import Array
from kinematics.motion.trajectory import Trajectory

_EXACT = 1e-9
"""A start nearer than this needs no lead-in."""
_GENTLE = 0.1
"""Share of the acceleration limits that the lead-in uses."""
_LEAST_S = 0.05
"""A cubic over a gap of micrometres that only kept the acceleration would be too short for the jerk."""


def lead_in(trajectory: Trajectory, q_start: Array, acceleration: Array) -> Trajectory:
    """Begin a trajectory exactly at a configuration at rest.

    Planned motions begin with the legs where base and soles put them; after a stop, each joint rests
    where it could, some milliradians beside that. Streamed as it is, such a gap would be a step. It
    is closed by one slow cubic segment before the trajectory's own first sample.

    Args:
        trajectory: Begins near ``q_start``, at rest.
        q_start: Where the robot is, shape (nq,).
        acceleration: Limits of the joints, rad/s^2, shape (n,).
    """
    start = q_start.copy()
    if start[3:7] @ trajectory.q[0, 3:7] < 0.0:  # the same orientation, written the other way
        start[3:7] *= -1.0
    gap = np.abs(trajectory.q[0] - start)
    if gap.max() <= _EXACT:
        return trajectory
    # A cubic between two rests accelerates with at most 6 * gap / duration^2.
    duration_s = max(_LEAST_S, float(np.sqrt(6.0 * gap.max() / (_GENTLE * acceleration.min()))))
    return Trajectory(
        joints=trajectory.joints,
        stance=trajectory.stance,
        t_s=np.concatenate([[0.0], trajectory.t_s + duration_s]),
        q=np.vstack([start, trajectory.q]),
        v=np.vstack([np.zeros(trajectory.v.shape[1]), trajectory.v]),
    )
