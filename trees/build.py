"""From a task to the tree that does it; what has no entry here is no skill of the robot yet."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import MappingProxyType

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from trees.beliefs.openings.fridge_inside import is_behind_door
from trees.extensions import extensions
from trees.nodes.best_effort import BestEffort
from trees.skills.doors.close import close
from trees.skills.doors.leave_handle import leave_handle
from trees.skills.doors.open import open_or_close
from trees.skills.gestures.tree import look_at, point_at, wave
from trees.skills.hand_over.tree import hand_over
from trees.skills.home.hand_about import objects_in_open_grasp
from trees.skills.home.leave_object import leave_object
from trees.skills.home.lift_clear import LiftClear, held_near_support
from trees.skills.home.tree import go_home
from trees.skills.moving.tree import move
from trees.skills.pick.tree import pick
from trees.skills.place.tree import place
from trees.skills.put_in.put_behind_door import put_behind_door
from trees.skills.put_in.tree import put_in
from trees.skills.talking.tree import say, wait
from trees.skills.telling.tree import count, describe, find, find_several
from trees.skills.walk_to.tree import walk_to
from trees.task_tree import TaskTree
from trees.tasks import (
    CloseTask,
    CountTask,
    DescribeTask,
    FindTask,
    GoHomeTask,
    HandOverTask,
    LookAtTask,
    MoveTask,
    OpenTask,
    PickTask,
    PlaceTask,
    PointAtTask,
    PutInTask,
    SayTask,
    Task,
    WaitTask,
    WalkToTask,
    WaveTask,
)
from trees.toolbox import Toolbox

__all__ = ["SKILLS", "NoSkillError", "TaskTree", "build_tree", "has_skill"]

SKILLS: Mapping[type[Task], Callable[[Toolbox], Behaviour]] = MappingProxyType(
    {
        PickTask: pick,
        PlaceTask: place,
        PutInTask: put_in,
        HandOverTask: hand_over,
        FindTask: find,
        CountTask: count,
        DescribeTask: describe,
        GoHomeTask: go_home,
        OpenTask: open_or_close,
        CloseTask: close,
        WaveTask: wave,
        PointAtTask: point_at,
        LookAtTask: look_at,
        SayTask: say,
        WaitTask: wait,
        MoveTask: move,
        WalkToTask: walk_to,
    }
)
"""What makes the root of each task's tree."""


class NoSkillError(ValueError):
    """A task is understood, but nothing here can carry it out."""

    def __init__(self, task: Task) -> None:
        known = ", ".join(sorted(kind.action for kind in SKILLS))
        super().__init__(f"{task.action!r} is no skill of this robot yet; it has {known}")


def has_skill(task: Task) -> bool:
    """Tell whether there is a tree for such a task."""
    return type(task) in SKILLS or extensions().for_task(task) is not None


def build_tree(task: Task, toolbox: Toolbox) -> TaskTree:
    """Build the tree of a task; nothing moves before its first tick.

    Raises:
        NoSkillError: There is no tree for such a task.
    """
    if not has_skill(task):
        raise NoSkillError(task)
    outside = extensions().for_task(task)
    tree = _skill(task) if outside is None else outside.tree
    root = tree(toolbox)
    if not isinstance(task, _HANDS_STAY):
        first = [leave_object(toolbox, about) for about in objects_in_open_grasp(toolbox)]
        if toolbox.world.at_handle is not None:
            first.append(leave_handle(toolbox))
        if held_near_support(toolbox) is not None:
            first.append(BestEffort(LiftClear("lift it clear", toolbox)))
        if first:
            root = Sequence(root.name, memory=True, children=[*first, root])
    return TaskTree(task, root, toolbox)


def _skill(task: Task) -> Callable[[Toolbox], Behaviour]:
    """What makes the root of a task's tree; another one for what is behind a door, and for several."""
    if isinstance(task, PutInTask) and is_behind_door(task.to):
        return put_behind_door
    if isinstance(task, FindTask) and task.count != 1 and not isinstance(task.person, str):
        return find_several
    return SKILLS[type(task)]


_HANDS_STAY = (SayTask, WaitTask, CountTask, DescribeTask)
"""What a robot does without taking its hand from where a cancelled task left it."""
