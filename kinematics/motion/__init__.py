"""Trajectories and the verdict on them: path, time, samples, findings."""

from typing import TYPE_CHECKING

from kinematics.handed_on import handed_on

if TYPE_CHECKING:
    from kinematics.motion.sampler import TrajectorySampler
    from kinematics.motion.trajectory import Trajectory
    from kinematics.motion.verdict import CheckedTrajectory, Finding, FindingKind, Unsafe
else:
    __getattr__ = handed_on(
        __name__,
        {
            "CheckedTrajectory": "verdict",
            "Finding": "verdict",
            "FindingKind": "verdict",
            "Trajectory": "trajectory",
            "TrajectorySampler": "sampler",
            "Unsafe": "verdict",
        },
    )

__all__ = [
    "CheckedTrajectory",
    "Finding",
    "FindingKind",
    "Trajectory",
    "TrajectorySampler",
    "Unsafe",
]
