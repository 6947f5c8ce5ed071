"""Whether a skill can begin: what the robot lacks for it, and what its hands have to do first."""

from __future__ import annotations

from dataclasses import dataclass

from py_trees.behaviour import Behaviour

from trees.needs import why_lacking
from trees.nodes.best_effort import BestEffort
from trees.skill import Need, Skill
from trees.skills.doors.handle.step_back import leave_handle
from trees.skills.home.hand_about import objects_in_open_grasp
from trees.skills.home.leave_object import leave_object
from trees.skills.home.lift_clear import LiftClear, held_near_support
from trees.toolbox import Toolbox


@dataclass(frozen=True, slots=True)
class Lack:
    """Something that a skill needs and a robot does not have.

    Attributes:
        need: What is needed.
        why: Why the robot has it not, as a user reads it.
    """

    need: Need
    why: str


def lacking(skill: Skill, toolbox: Toolbox) -> Lack | None:
    """The first thing that a skill needs and the robot does not have here; None where it has all.

    Args:
        skill: Its record.
        toolbox: Knows the robot, and what of it is reached.
    """
    robot = toolbox.model.description
    for need in Need:
        if (
            need in skill.needs
            and (why := why_lacking(need, robot) or _out_of_use(need, toolbox)) is not None
        ):
            return Lack(need, why)
    return None


def _out_of_use(need: Need, toolbox: Toolbox) -> str | None:
    """Why a part that the robot has cannot be used here."""
    name = toolbox.model.description.name
    if need is Need.HAND and not toolbox.grippers:
        return f"{name} has no gripper here"
    return f"{name} cannot walk here" if need is Need.LEGS and not toolbox.can_walk else None


def clear_hands(toolbox: Toolbox) -> list[Behaviour]:
    """What takes the hands from where a cancelled task left them; nothing where they are clear."""
    first: list[Behaviour] = [leave_object(toolbox, about) for about in objects_in_open_grasp(toolbox)]
    if toolbox.world.at_handle is not None:
        first.append(leave_handle(toolbox))
    if held_near_support(toolbox) is not None:
        first.append(BestEffort(LiftClear("lift it clear", toolbox)))
    return first
