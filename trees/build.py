"""From a task to the tree that does it; what has no entry here is no skill of the robot yet."""

from __future__ import annotations

from py_trees.composites import Sequence

from trees.given_motion import FollowTrajectoryTask, follow_trajectory
from trees.readiness import clear_hands
from trees.registry import skill_of, skills
from trees.task_tree import TaskTree
from trees.tasks import Task
from trees.toolbox import Toolbox

__all__ = ["NoSkillError", "TaskTree", "build_tree", "has_skill"]


class NoSkillError(ValueError):
    """A task is understood, but nothing here can carry it out."""

    def __init__(self, task: Task) -> None:
        known = ", ".join(skills())
        super().__init__(f"{task.action!r} is no skill of this robot yet; it has {known}")


def has_skill(task: Task) -> bool:
    """Tell whether there is a tree for such a task."""
    return skill_of(task) is not None


def build_tree(task: Task, toolbox: Toolbox) -> TaskTree:
    """Build the tree of a task; nothing moves before its first tick.

    Raises:
        NoSkillError: There is no tree for such a task.
    """
    if isinstance(task, FollowTrajectoryTask):
        return TaskTree(task, follow_trajectory(toolbox), toolbox)
    skill = skill_of(task)
    if skill is None:
        raise NoSkillError(task)
    root = skill.tree(task, toolbox)
    first = [] if skill.hands_stay else clear_hands(toolbox)
    if first:
        root = Sequence(root.name, memory=True, children=[*first, root])
    return TaskTree(task, root, toolbox)
