"""Walk to furniture, an object or a person."""

from __future__ import annotations

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from trees.failures import Failure, FailureKind
from trees.leaves.go_home import tidily
from trees.nodes.alternatives import Alternatives
from trees.nodes.judgements import defect, judgement, looking_elsewhere_is_useless
from trees.nodes.retry import Retry
from trees.policy import Gaze
from trees.skills.looking.search_place import everywhere, search_place
from trees.skills.searching.look_elsewhere import (
    turned_around,
    viewpoint,
    where_it_may_be,
    where_it_was,
    worth_going,
)
from trees.skills.searching.recall_place import RecallPlace
from trees.skills.walk_to.choose_stand import ChooseStand
from trees.skills.walk_to.know_place import KnowPlace
from trees.skills.walk_to.may_be_elsewhere import MayBeElsewhere
from trees.skills.walk_to.see_front import SeeFront
from trees.skills.walk_to.settings import WalkToSettings
from trees.skills.walk_to.squared_up import SquaredUp
from trees.skills.walking.change_viewpoint import Viewpoint
from trees.skills.walking.ready_to_walk import ReadyToWalk
from trees.skills.walking.walk_to import WalkTo
from trees.skills.walking.walk_with_room import with_room
from trees.toolbox import Toolbox

_ON: tuple[Viewpoint, ...] = ("ahead", "around", "ahead")
"""Where the robot goes on to at random, after it has turned around and been to what it saw."""


def walk_to(toolbox: Toolbox) -> Behaviour:
    """Find it, walk there, look again, and correct. Reads "task", writes "evidence"."""
    steps = [find_place(toolbox), walks(toolbox, ChooseStand("choose where to stand", toolbox))]
    return tidily("walk to", steps, toolbox, toolbox.policy.walk_timeout_s)


def walks(toolbox: Toolbox, choose: Behaviour) -> Behaviour:
    """Walk to where one stands for a place that was seen, and correct. Reads "task" and "place".

    Args:
        toolbox: What leaves may call.
        choose: Writes "stand".
    """
    attempt = Sequence(
        "attempt",
        memory=True,
        children=[
            choose,
            ReadyToWalk("stand upright", toolbox),
            with_room(toolbox, WalkTo("walk", toolbox, if_hands_fit=True), WalkTo("walk", toolbox)),
            Alternatives(
                "find again",
                [
                    KnowPlace("know the place", toolbox),
                    SeeFront("see its front", toolbox, {"known": "place"}),
                    search_place("look again", toolbox, everywhere(toolbox)),
                ],
            ),
            SquaredUp("stand square", toolbox),
        ],
    )
    again = ReadyToWalk("stand upright", toolbox)
    return Retry(
        "walks", attempt, again, toolbox.policy.of(WalkToSettings).walk_attempts, another_walk_is_useless
    )


def find_place(toolbox: Toolbox) -> Behaviour:
    """Look from here, then from elsewhere: the camera does not see all that one can walk to."""
    policy = toolbox.policy
    far = (*policy.search_gazes[:1], *policy.level_gazes)
    ways: list[Behaviour] = [
        KnowPlace("know the place", toolbox),
        search_place("look around", toolbox, (*far, *policy.search_gazes[1:2])),
    ]
    ways += [RecallPlace("recall it", toolbox), where_it_was(toolbox)]
    around = turned_around(toolbox, _level_first(far))
    farther = [where_it_was(toolbox), *where_it_may_be(toolbox)]  # once more: there may be room to go by now
    for k, way in enumerate(_ON, start=len(around) + 1):
        farther.append(viewpoint(toolbox, k, way, _level_first(far)))
    farther.append(RecallPlace("recall anything", toolbox, anything=True))
    elsewhere = Alternatives("go and look", farther, looking_elsewhere_is_useless, worth_going)
    may_be = MayBeElsewhere("may be elsewhere", toolbox)
    ways += [*around, Sequence("elsewhere", memory=True, children=[may_be, elsewhere])]
    return Alternatives("find it", ways, looking_elsewhere_is_useless, worth_going)


def _level_first(gazes: tuple[Gaze, ...]) -> tuple[Gaze, ...]:
    return (*gazes[1:], gazes[0])


@judgement
def another_walk_is_useless(failure: Failure, before: Failure | None) -> bool:
    """Standing beside the place is put right by walking again; so is a way that was barred for a while."""
    twice = before is not None and before.kind is failure.kind is FailureKind.INFEASIBLE
    fine = failure.kind in (FailureKind.POSTCONDITION, FailureKind.INFEASIBLE)
    return defect(failure) or bool(failure.choices) or twice or not fine
