"""Gestures: wave, point at, look at."""

from __future__ import annotations

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from trees.failures import Failure, FailureKind
from trees.leaves.check_trajectory import CheckTrajectory
from trees.leaves.go_home import GoHome, tidily
from trees.leaves.stream_motion import StreamMotion
from trees.leaves.wait import Hold
from trees.nodes.alternatives import Alternatives
from trees.nodes.judgements import judgement
from trees.skills.gestures.look_at_place import LookAtPlace
from trees.skills.gestures.plan_pointing import PlanPointing
from trees.skills.gestures.raise_hand import RaiseHand
from trees.skills.gestures.settings import GestureSettings
from trees.skills.gestures.swing_hand import SwingHand
from trees.skills.gestures.turn_to import BEHIND_RAD, turned_to
from trees.skills.gestures.verify_pointing import VerifyPointing
from trees.skills.looking.find_unseen import FindUnseen
from trees.skills.looking.look_along_way import seen_way
from trees.skills.looking.search_place import everywhere
from trees.skills.searching.look_elsewhere import found_by_turning
from trees.toolbox import Toolbox

_LOOKS_ON_WAY = 3
"""Near a table an arm that points passes over things that the search for one of them did not show; for what
the first look found it may go elsewhere."""


def wave(toolbox: Toolbox) -> Behaviour:
    """Find the person, turn to them, wave, and lower the hand. Reads "task", writes "evidence"."""
    children: list[Behaviour] = [
        found_by_turning("find the person", toolbox, toolbox.policy.level_gazes),
        turned_to("turn to them", toolbox, toolbox.policy.level_gazes[:1]),
        RaiseHand("raise hand", toolbox),
        SwingHand("swing hand", toolbox),
        GoHome("lower hand", toolbox),
    ]
    return tidily("wave", children, toolbox, toolbox.policy.walk_timeout_s)


def point_at(toolbox: Toolbox) -> Behaviour:
    """Find it, point at it for a while, and lower the arm. Reads "task", writes "evidence"."""
    children: list[Behaviour] = [
        found_by_turning("find it", toolbox, everywhere(toolbox)),
        turned_to("turn to it", toolbox, everywhere(toolbox)),
        PlanPointing("plan pointing", toolbox),
        seen_way(
            "look below the way",
            toolbox,
            FindUnseen,
            lambda: PlanPointing("plan again", toolbox),
            _LOOKS_ON_WAY,
        ),
        CheckTrajectory("check pointing", toolbox, {"step": "reach", "checked": "checked_reach"}),
        StreamMotion("stretch arm", toolbox, {"checked": "checked_reach"}),
        VerifyPointing("see where it points", toolbox),
        Hold("hold", toolbox, toolbox.policy.of(GestureSettings).pointing_hold_s),
        GoHome("lower arm", toolbox),
    ]
    return tidily("point at", children, toolbox, toolbox.policy.walk_timeout_s)


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
        found_by_turning("find it", toolbox, everywhere(toolbox)),
        turned_to("face it", toolbox, everywhere(toolbox), BEHIND_RAD),
        Alternatives("look", ways, hopeless=hands_are_not_in_the_way),
    ]
    return tidily("look at", children, toolbox, toolbox.policy.walk_timeout_s)


@judgement
def hands_are_not_in_the_way(failure: Failure) -> bool:
    """All but a planner's no: what a hand has lifted over a table is in the way of who leans over it."""
    return failure.kind is not FailureKind.INFEASIBLE or bool(failure.choices)
