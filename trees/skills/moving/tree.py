"""Walk at a velocity."""

from __future__ import annotations

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from trees.nodes.alternatives import Alternatives
from trees.skills.moving.drive import Drive
from trees.skills.moving.move import Move
from trees.skills.walking.ready_to_walk import ReadyToWalk
from trees.skills.walking.walk_with_room import change_viewpoint, narrower_arms_are_useless
from trees.toolbox import Toolbox


def move(toolbox: Toolbox) -> Behaviour:
    """Stand upright where the body leans, walk at a velocity for a time or a distance, then stand.

    Where the hands have no room to turn on the spot, a step away comes first.
    """
    upright = ReadyToWalk("stand upright", toolbox, only_if_it_leans=True)
    away = [
        ReadyToWalk("hands at home", toolbox),
        change_viewpoint(toolbox, "room"),
        Move("walk", toolbox),
    ]
    ways = [Move("walk", toolbox), Sequence("from a step away", memory=True, children=away)]
    walk = Alternatives("walk or turn", ways, narrower_arms_are_useless)
    return Sequence("move", memory=True, children=[upright, walk])


def drive(toolbox: Toolbox) -> Behaviour:
    """Stand upright where the body leans, follow velocities as they are sent, then stand."""
    upright = ReadyToWalk("stand upright", toolbox, only_if_it_leans=True)
    return Sequence("drive", memory=True, children=[upright, Drive("walk", toolbox)])
