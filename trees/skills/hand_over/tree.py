"""Hand an object over: offer it, wait for a pull, let go, see that it did not fall; else it is taken back."""

from __future__ import annotations

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from trees.failures import Failure, Reason
from trees.leaves.go_home import GoHome, tidily
from trees.leaves.wait import Hold
from trees.nodes.alternatives import Alternatives
from trees.nodes.best_effort import BestEffort
from trees.nodes.judgements import defect, judgement, looking_elsewhere_is_useless
from trees.policy import Gaze
from trees.skills.carrying.draw_back import DrawBack
from trees.skills.carrying.get_in_hand import get_in_hand
from trees.skills.carrying.look_at_placement import LookAtPlacement
from trees.skills.carrying.note_bystanders import NoteBystanders
from trees.skills.hand_over.await_pull import AwaitPull
from trees.skills.hand_over.give import Give
from trees.skills.hand_over.look_at_taker import LookAtTaker
from trees.skills.hand_over.offer import Offer
from trees.skills.hand_over.settings import HandOverSettings
from trees.skills.hand_over.verify_taken import VerifyTaken
from trees.skills.looking.search_place import search_place
from trees.skills.walking.ready_to_walk import ReadyToWalk
from trees.toolbox import Toolbox


def hand_over(toolbox: Toolbox) -> Behaviour:
    """The whole skill. Reads "task" of the tree's namespace, writes "evidence"."""
    policy = toolbox.policy
    know_who = search_place("know the person", toolbox, _gazes(toolbox), slots=("to",))
    children: list[Behaviour] = [
        get_in_hand(toolbox, know_who),
        _find_the_person(toolbox),
        NoteBystanders("note what stands about", toolbox),
        Offer("offer", toolbox),
        AwaitPull("wait for the pull", toolbox),
        Give("give", toolbox),
        Hold("let it go", toolbox, policy.of(HandOverSettings).after_giving_s),
        BestEffort(DrawBack("draw back", toolbox)),
        GoHome("go home", toolbox),
        _see_who_has_it(toolbox),
    ]
    return tidily("hand over", children, toolbox)


def _gazes(toolbox: Toolbox) -> tuple[Gaze, ...]:
    level = toolbox.policy.level_gazes
    return (*level, *level[:1])


def _find_the_person(toolbox: Toolbox) -> Behaviour:
    """As the robot stands once it has the thing, then upright: out of a deep reach it could not look up."""
    gazes = _gazes(toolbox)
    upright: list[Behaviour] = [
        BestEffort(ReadyToWalk("stand upright", toolbox)),
        search_place("look again", toolbox, gazes, slots=("to",)),
    ]
    ways = [
        search_place("look around", toolbox, gazes, slots=("to",)),
        Sequence("from upright", memory=True, children=upright),
    ]
    return Alternatives("find the person", ways, looking_elsewhere_is_useless)


def _see_who_has_it(toolbox: Toolbox) -> Behaviour:
    """Where it was offered and below, then at who took it, the head and what is in the hands."""
    ways: list[Behaviour] = [
        Sequence(name, memory=True, children=[look, VerifyTaken(f"verify taken {where}", toolbox)])
        for name, where, look in (
            ("look where it was", "below", LookAtPlacement("look below", toolbox)),
            ("look at the person", "ahead", LookAtTaker("look up", toolbox)),
        )
    ]
    return Alternatives("see who has it", ways, hopeless=seen_elsewhere)


@judgement
def seen_elsewhere(failure: Failure) -> bool:
    """It was seen where it should not be: another look does not help."""
    return defect(failure) or failure.reason in (Reason.DROPPED, Reason.TAKEN_BY_ANOTHER)
