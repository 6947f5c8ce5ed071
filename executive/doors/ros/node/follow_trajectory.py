"""The goal of ``control_msgs/FollowJointTrajectory`` as an order to the robot, and its ending as the result.

The robot's checker judges the whole motion before anything moves. Points without velocities are passed at
rest, joints that are not named stay, and a first point later than 0 s is gone to from where the robot is.
Tolerances are the robot's own: a goal that brings some is refused, and so is one for a time of its own.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from progress import account_of

SUCCESSFUL, INVALID_GOAL, INVALID_JOINTS = 0, -1, -2
PATH_TOLERANCE_VIOLATED, GOAL_TOLERANCE_VIOLATED = -4, -5
_UNSAFE = 5
"""The exit code of what a safety check has refused."""
_TOLERANCES = ("path_tolerance", "component_path_tolerance", "goal_tolerance", "component_goal_tolerance")


class InvalidGoalError(ValueError):
    """A goal that no robot is asked about; ``code`` is the action's error code."""

    def __init__(self, reason: str, code: int = INVALID_GOAL) -> None:
        super().__init__(reason)
        self.code = code


def joint_motion(goal: Any) -> dict[str, Any]:
    """The motion of a goal, as the robot reads it.

    Raises:
        InvalidGoalError: It asks for what this robot does not do, or its points do not fit its joints.
    """
    trajectory = goal.trajectory
    if any(getattr(goal, name, ()) for name in _TOLERANCES):
        raise InvalidGoalError("tolerances are the robot's own: leave them empty")
    if getattr(getattr(goal, "multi_dof_trajectory", None), "points", ()):
        raise InvalidGoalError("joints of several degrees of freedom are not followed")
    if _seconds(trajectory.header.stamp) != 0.0:
        raise InvalidGoalError("a motion begins at once: leave header.stamp at zero")
    if not trajectory.joint_names:
        raise InvalidGoalError("no joint is named", INVALID_JOINTS)
    if not trajectory.points:
        raise InvalidGoalError("it has no points")
    return {
        "joints": list(trajectory.joint_names),
        "points": [_point(i, one, len(trajectory.joint_names)) for i, one in enumerate(trajectory.points)],
    }


def _point(index: int, point: Any, joints: int) -> dict[str, Any]:
    told = {"t_s": _seconds(point.time_from_start), "positions": [float(one) for one in point.positions]}
    if len(point.velocities):
        told["velocities"] = [float(one) for one in point.velocities]
    for name in ("positions", "velocities"):
        if len(told.get(name, [0.0] * joints)) != joints:  # type: ignore[arg-type]
            raise InvalidGoalError(f"points[{index}].{name} are not one for each of {joints} joints")
    return told


def _seconds(time: Any) -> float:
    return float(time.sec) + 1e-9 * float(time.nanosec)


class GivenFile:
    """A motion in a file of the served robot's folder, which is its user's alone; it goes with the context.

    Args:
        folder: Where the robot is served.
        name: Of the goal, unlike any other's.
        motion: What ``joint_motion`` made.
    """

    def __init__(self, folder: Path, name: str, motion: Mapping[str, Any]) -> None:
        self.path = folder / f"given-{name}.json"
        self._motion = motion

    def __enter__(self) -> GivenFile:
        """Write it."""
        self.path.write_text(json.dumps(self._motion), "utf-8")
        return self

    def __exit__(self, *_raised: object) -> None:
        """Remove it."""
        self.path.unlink(missing_ok=True)

    @property
    def order(self) -> dict[str, Any]:
        """The message to the robot."""
        return {"kind": "follow_trajectory", "path": str(self.path)}


def result_of(ending: Mapping[str, Any]) -> tuple[int, str]:
    """Error code and error string for how the robot ended the order.

    A motion that the checker refuses is an invalid goal, with the checker's finding; one that was not
    followed or did not arrive violates a tolerance.
    """
    account = account_of(ending)
    told = account.message
    if account.outcome == "done":
        return SUCCESSFUL, ""
    kinds = [one.kind for one in account.failures]
    if account.outcome in ("refused", "cancelled") or int(ending["exit_code"]) == _UNSAFE:
        return INVALID_GOAL, told
    return (GOAL_TOLERANCE_VIOLATED if "POSTCONDITION" in kinds else PATH_TOLERANCE_VIOLATED), told
