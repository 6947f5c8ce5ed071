"""Go to the home posture."""

from __future__ import annotations

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from trees.leaves.go_home import GoHome
from trees.toolbox import Toolbox


def go_home(toolbox: Toolbox) -> Behaviour:
    """Bring the whole body home; hands keep what they hold."""
    return Sequence("go home", memory=True, children=[GoHome("move home", toolbox)])
