"""A walk that draws the arms in where hands at home would come to something."""

from __future__ import annotations

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from trees.failures import Failure, FailureKind
from trees.nodes.alternatives import Alternatives
from trees.nodes.best_effort import BestEffort
from trees.nodes.judgements import judgement
from trees.skills.walking.change_viewpoint import ChangeViewpoint, Viewpoint
from trees.skills.walking.draw_arms_in import DrawArmsIn
from trees.toolbox import Toolbox

_NAMES = {"ahead": "go on", "around": "turn around", "back": "step back", "room": "make room"}


def change_viewpoint(toolbox: Toolbox, way: Viewpoint) -> Behaviour:
    """Go on, step back, make room, or turn, with the arms drawn in where they have no room to turn."""

    def leaf() -> Behaviour:
        return ChangeViewpoint(_NAMES[way], toolbox, way)

    return with_room(toolbox, leaf(), leaf()) if way == "around" else leaf()


def with_room(toolbox: Toolbox, at_home: Behaviour, drawn_in: Behaviour) -> Behaviour:
    """Walk with the hands at home if they have room, else with the arms drawn in.

    Where they have no room to get out again afterwards, they stay as they are.

    Args:
        toolbox: What leaves may call.
        at_home: The walk; infeasible where hands have no room.
        drawn_in: The same walk for narrower arms.
    """
    narrow = [DrawArmsIn("draw the arms in", toolbox), drawn_in]
    ways = [at_home, Sequence("with arms drawn in", memory=True, children=narrow)]
    out = BestEffort(DrawArmsIn("let the arms out", toolbox, out=True))
    walk = Alternatives("walk", ways, narrower_arms_are_useless)
    return Sequence("with room", memory=True, children=[walk, out])


@judgement
def narrower_arms_are_useless(failure: Failure) -> bool:
    """They help against want of room alone."""
    return failure.root.kind is not FailureKind.INFEASIBLE or bool(failure.choices)
