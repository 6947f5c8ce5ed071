"""The judge of planned motions. It shares model, scene, motion and distance with the planner alone."""

from typing import TYPE_CHECKING

from kinematics.handed_on import handed_on

if TYPE_CHECKING:
    from kinematics.checking.settings import CheckSettings
    from kinematics.checking.trajectory_checker import TrajectoryChecker
else:
    __getattr__ = handed_on(
        __name__,
        {
            "CheckSettings": "settings",
            "TrajectoryChecker": "trajectory_checker",
        },
    )

__all__ = [
    "CheckSettings",
    "TrajectoryChecker",
]
