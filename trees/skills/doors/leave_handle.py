"""Let go of the handle at which a cancelled task left a hand, before anything else is done."""

from __future__ import annotations

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from trees.leaves.release import Release
from trees.nodes.best_effort import BestEffort
from trees.skills.doors.handle.step_back import StepBack
from trees.toolbox import Toolbox


def leave_handle(toolbox: Toolbox) -> Behaviour:
    """Open the hand and draw it straight back; any other way would take the door along."""
    children = [Release("let go", toolbox), BestEffort(StepBack("draw back", toolbox))]
    return Sequence("leave the handle", memory=True, children=children)
