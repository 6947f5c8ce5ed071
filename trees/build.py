"""From a task to the tree that does it."""

from __future__ import annotations

from py_trees.behaviour import Behaviour

from trees.subtrees.go_home import go_home
from trees.subtrees.pick import pick
from trees.task_tree import TaskTree
from trees.tasks import GoHomeTask, PickTask, Task
from trees.toolbox import Toolbox

__all__ = ["TaskTree", "build_tree"]


def build_tree(task: Task, toolbox: Toolbox) -> TaskTree:
    """Build the tree of a task; nothing moves before its first tick."""
    return TaskTree(task, _root(task, toolbox), toolbox)


def _root(task: Task, toolbox: Toolbox) -> Behaviour:
    if isinstance(task, PickTask):
        return pick(toolbox)
    if isinstance(task, GoHomeTask):
        return go_home(toolbox)
    raise TypeError(f"no tree for a {type(task).__name__}")
