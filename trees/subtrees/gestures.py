"""Gestures: wave, point at, look at."""

from __future__ import annotations

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from trees.alternatives import Alternatives
from trees.best_effort import BestEffort
from trees.failures import Failure, FailureKind
from trees.leaves.check_trajectory import CheckTrajectory
from trees.leaves.find_unseen import FindUnseen
from trees.leaves.go_home import GoHome
from trees.leaves.look_at import LookAtUnseen
from trees.leaves.look_at_place import LookAtPlace
from trees.leaves.plan_pointing import PlanPointing
from trees.leaves.raise_hand import RaiseHand
from trees.leaves.stream_motion import StreamMotion
from trees.leaves.survey import Survey
from trees.leaves.swing_hand import SwingHand
from trees.leaves.verify_pointing import VerifyPointing
from trees.leaves.wait import Hold
from trees.subtrees.search_place import everywhere, search_place
from trees.subtrees.tidily import tidily
from trees.toolbox import Toolbox
from trees.unless_seen import UnlessSeen

_LOOKS_ON_WAY = 2
"""For what was found at the first one, the arm may go elsewhere."""


def wave(toolbox: Toolbox) -> Behaviour:
    """Find the person, turn to them, wave, and lower the hand. Reads "task", writes "evidence"."""
    children: list[Behaviour] = [
        search_place("find the person", toolbox, toolbox.policy.level_gazes),
        RaiseHand("raise hand", toolbox),
        SwingHand("swing hand", toolbox),
        GoHome("lower hand", toolbox),
    ]
    return tidily("wave", children, toolbox)


def point_at(toolbox: Toolbox) -> Behaviour:
    """Find it, point at it for a while, and lower the arm. Reads "task", writes "evidence"."""
    children: list[Behaviour] = [
        search_place("find it", toolbox, everywhere(toolbox)),
        PlanPointing("plan pointing", toolbox),
        _look_below_the_way(toolbox, _LOOKS_ON_WAY),
        CheckTrajectory("check pointing", toolbox, {"step": "reach", "checked": "checked_reach"}),
        StreamMotion("stretch arm", toolbox, {"checked": "checked_reach"}),
        VerifyPointing("see where it points", toolbox),
        Hold("hold", toolbox, toolbox.policy.pointing_hold_s),
        GoHome("lower arm", toolbox),
    ]
    return tidily("point at", children, toolbox)


def _look_below_the_way(toolbox: Toolbox, looks: int) -> Behaviour:
    """Near a table an arm that points passes over things that the search for one of them did not show.

    Args:
        toolbox: What leaves may call.
        looks: So many, one after the other, at the most.
    """
    steps: list[Behaviour] = [
        BestEffort(LookAtUnseen("look", toolbox)),
        Survey("survey", toolbox, {"sightings_now": "sightings"}, keeping=True),
        PlanPointing("plan again", toolbox),
    ]
    if looks > 1:
        steps.append(_look_below_the_way(toolbox, looks - 1))
    children: list[Behaviour] = [
        FindUnseen("find what is unseen", toolbox),
        UnlessSeen(Sequence("look below the way", memory=True, children=steps)),
    ]
    return Sequence("its way is seen", memory=True, children=children)


def look_at(toolbox: Toolbox) -> Behaviour:
    """Find it, and keep it in the middle of the picture. Reads "task", writes "evidence"."""
    from_home: list[Behaviour] = [
        GoHome("draw the hands in", toolbox),
        LookAtPlace("turn to it from home", toolbox),
    ]
    ways: list[Behaviour] = [
        LookAtPlace("turn to it", toolbox),
        Sequence("with the hands at home", memory=True, children=from_home),
    ]
    children: list[Behaviour] = [
        search_place("find it", toolbox, everywhere(toolbox)),
        Alternatives("look", ways, hopeless=hands_are_not_in_the_way),
    ]
    return tidily("look at", children, toolbox)


def hands_are_not_in_the_way(failure: Failure) -> bool:
    """All but a planner's no: what a hand has lifted over a table is in the way of who leans over it."""
    return failure.kind is not FailureKind.INFEASIBLE or bool(failure.choices)
