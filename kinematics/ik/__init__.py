"""Inverse kinematics of the standing body, of the gaze and of pointing."""

from typing import TYPE_CHECKING

from kinematics.handed_on import handed_on

if TYPE_CHECKING:
    from kinematics.ik.result import IkResult, IkTolerance
    from kinematics.ik.solver import inverse_kinematics
else:
    __getattr__ = handed_on(
        __name__,
        {
            "IkResult": "result",
            "IkTolerance": "result",
            "inverse_kinematics": "solver",
        },
    )

__all__ = [
    "IkResult",
    "IkTolerance",
    "inverse_kinematics",
]
