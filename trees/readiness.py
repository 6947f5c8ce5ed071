"""Whether a skill can begin: what the robot lacks for it, and what its hands have to do first."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import MappingProxyType

from py_trees.behaviour import Behaviour

from trees.nodes.best_effort import BestEffort
from trees.skill import Need, Skill
from trees.skills.doors.handle.step_back import leave_handle
from trees.skills.home.hand_about import objects_in_open_grasp
from trees.skills.home.leave_object import leave_object
from trees.skills.home.lift_clear import LiftClear, held_near_support
from trees.toolbox import Toolbox

_HAS: Mapping[Need, Callable[[Toolbox], bool]] = MappingProxyType(
    {
        Need.HAND: lambda toolbox: bool(toolbox.grippers),
        Need.ARM: lambda toolbox: bool(toolbox.model.description.tcp_frames),
        Need.LEGS: lambda toolbox: toolbox.can_walk,
    }
)


def lacking(skill: Skill, toolbox: Toolbox) -> Need | None:
    """The first thing that a skill needs and the robot does not have here; None where it has all.

    Args:
        skill: Its record.
        toolbox: Knows the robot.
    """
    return next((need for need in Need if need in skill.needs and not _HAS[need](toolbox)), None)


def clear_hands(toolbox: Toolbox) -> list[Behaviour]:
    """What takes the hands from where a cancelled task left them; nothing where they are clear."""
    first: list[Behaviour] = [leave_object(toolbox, about) for about in objects_in_open_grasp(toolbox)]
    if toolbox.world.at_handle is not None:
        first.append(leave_handle(toolbox))
    if held_near_support(toolbox) is not None:
        first.append(BestEffort(LiftClear("lift it clear", toolbox)))
    return first
