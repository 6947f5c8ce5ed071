"""Walk at a velocity."""

from __future__ import annotations

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from trees.leaves.move import Move
from trees.toolbox import Toolbox


def move(toolbox: Toolbox) -> Behaviour:
    """Walk at a velocity for a time or a distance, then stand."""
    return Sequence("move", memory=True, children=[Move("walk", toolbox)])
