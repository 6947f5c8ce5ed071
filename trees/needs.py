"""Which of the parts that skills need a robot has, by its data alone, and why it lacks the others."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from trees.skill import Need, Skill

if TYPE_CHECKING:
    from kinematics.model.robot_description import RobotDescription


def why_lacking(need: Need, robot: RobotDescription) -> str | None:
    """Why a robot lacks something, as a user reads it; None where it has it.

    Args:
        need: What a skill needs.
        robot: Its data.
    """
    match need:
        case Need.HAND if not robot.grippers:
            return robot.cannot_grasp or f"{robot.name} has no gripper"
        case Need.BARS if all(hand.cannot_grip_bars for hand in robot.grippers.values()):
            # a robot without any gripper has been told of that
            return next((hand.cannot_grip_bars for hand in robot.grippers.values()), None)
        case Need.TIPS if robot.grippers and all(hand.motors for hand in robot.grippers.values()):
            return f"the fingers of {robot.name} close on a palm"
        case Need.ARM if not robot.tcp_frames:
            return f"{robot.name} has none"
        case Need.LEGS if robot.welded:
            return f"{robot.name} stands on a welded base"
        case Need.LEGS if robot.walking is None:
            return f"{robot.name} is not known to walk"
        case Need.EYES if robot.head_camera is None:
            return f"{robot.name} has no camera"
        case Need.EYES if robot.head_camera is not None and not robot.head_camera.aims:
            return f"the camera of {robot.name} stays as it is"
    return None


def lacks(skill: Skill, robot: RobotDescription) -> Iterator[str]:
    """What a robot lacks for a skill, each with the reason: "feet; panda stands on a welded base"."""
    for need in Need:
        if need in skill.needs and (reason := why_lacking(need, robot)) is not None:
            yield f"{need.value}; {reason}"
