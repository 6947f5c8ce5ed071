"""The tree that says what a task would do: it looks, plans and checks; no leaf of it moves anything."""

from __future__ import annotations

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from trees.leaves.check_trajectory import CheckTrajectory
from trees.skills.looking.detect import Detect
from trees.skills.pick.plan_pick import PlanPick
from trees.task_tree import TaskTree
from trees.tasks import PickTask, Task
from trees.toolbox import Toolbox


def build_dry_run(task: Task, toolbox: Toolbox) -> TaskTree:
    """Build the dry run of a task, from where the robot stands and looks now.

    Raises:
        TypeError: There is no dry run of such a task.
    """
    if not isinstance(task, PickTask):
        raise TypeError(f"no dry run of a {type(task).__name__}")
    children: list[Behaviour] = [Detect("detect", toolbox), PlanPick("plan pick", toolbox)]
    children += [
        CheckTrajectory(f"check {step}", toolbox, {"step": step, "checked": f"checked_{step}"})
        for step in ("reach", "approach", "lift")
    ]
    return TaskTree(task, Sequence("rehearsal", memory=True, children=children), toolbox)
