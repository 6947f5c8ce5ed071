"""Go to the home posture."""

from __future__ import annotations

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from trees.best_effort import BestEffort
from trees.leaves.go_home import GoHome
from trees.leaves.lift_clear import LiftClear
from trees.toolbox import Toolbox


def go_home(toolbox: Toolbox) -> Behaviour:
    """Bring the whole body home; hands keep what they hold."""
    children = [BestEffort(LiftClear("lift it clear", toolbox)), GoHome("move home", toolbox)]
    return Sequence("go home", memory=True, children=children)
