"""Go to the home posture."""

from __future__ import annotations

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from trees.leaves.go_home import GoHome
from trees.nodes.best_effort import BestEffort
from trees.skills.home.if_nothing_is_known import IfNothingIsKnown
from trees.skills.home.leave_object import leave_what_stands
from trees.skills.home.lift_clear import LiftClear
from trees.skills.home.look_at_hands import LookAtHands
from trees.skills.looking.survey import Survey
from trees.toolbox import Toolbox


def go_home(toolbox: Toolbox) -> Behaviour:
    """Bring the whole body home; hands keep what they hold.

    Who took over a robot that another one left over a table looks first where its hands are, and takes its
    fingers off what stands between them.
    """
    looks: list[Behaviour] = [
        LookAtHands("look at the hands", toolbox),
        Survey("see what is about them", toolbox, {"sightings_now": "sightings"}),
        leave_what_stands(toolbox),
    ]
    look = Sequence("look", memory=True, children=looks)
    children = [
        IfNothingIsKnown(BestEffort(look), toolbox),
        BestEffort(LiftClear("lift it clear", toolbox)),
        GoHome("move home", toolbox),
    ]
    return Sequence("go home", memory=True, children=children)
