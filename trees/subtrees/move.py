"""Walk at a velocity."""

from __future__ import annotations

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from trees.leaves.move import Move
from trees.leaves.ready_to_walk import ReadyToWalk
from trees.toolbox import Toolbox


def move(toolbox: Toolbox) -> Behaviour:
    """Stand upright where the body leans, walk at a velocity for a time or a distance, then stand."""
    upright = ReadyToWalk("stand upright", toolbox, only_if_it_leans=True)
    return Sequence("move", memory=True, children=[upright, Move("walk", toolbox)])
