"""Find somebody, come near, and turn to them."""

from __future__ import annotations

from collections.abc import Sequence as Many

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from trees.beliefs.grounding.destination import PERSON_SLOTS, aim_of, slot_of, where_person_is
from trees.failures import Failure, FailureKind
from trees.nodes.alternatives import Alternatives
from trees.nodes.best_effort import BestEffort
from trees.nodes.judgements import defect, judgement, looking_elsewhere_is_useless
from trees.nodes.retry import Retry
from trees.skills.gestures.turn_to import turned_to
from trees.skills.looking.search_place import search_place
from trees.skills.meeting.if_far import IfFar
from trees.skills.meeting.if_outside import IfOutside
from trees.skills.meeting.is_near import IsNear
from trees.skills.meeting.settings import MeetingSettings
from trees.skills.searching.choose_room import ChooseRoom
from trees.skills.searching.look_elsewhere import going, people_in_rooms, turned_around, worth_going
from trees.skills.telling.who_speaks import SPEAKER, who_speaks
from trees.skills.walking.ready_to_walk import ReadyToWalk
from trees.skills.walking.walk_to import WalkTo
from trees.skills.walking.walk_with_room import with_room
from trees.toolbox import Toolbox

_GOES_THERE = 2
"""How often the robot goes into a room where somebody may stand in the way for a while."""


def met(task: object, toolbox: Toolbox, slots: Many[str] = PERSON_SLOTS) -> list[Behaviour]:
    """Somebody is found, the robot comes near and turns to them. Reads "task", writes "place".

    Where there is no room for the feet to turn, trunk and head are left to whoever goes on.

    Args:
        task: What is to be done; where the person is said to be, nobody is looked for elsewhere.
        toolbox: What leaves may call.
        slots: Of the task, that say who is meant, the one that counts first.
    """
    settings, level = toolbox.policy.of(MeetingSettings), toolbox.policy.level_gazes
    return [
        found_person(task, toolbox, slots),
        _near(toolbox, slots),
        BestEffort(turned_to("turn to them", toolbox, level[:1], settings.faced_rad, slots)),
    ]


def found_person(task: object, toolbox: Toolbox, slots: Many[str] = PERSON_SLOTS) -> Behaviour:
    """Look where the person is said to be, or else from here, all around, and in other rooms.

    Arguments are as for ``met``. Writes "place".
    """
    if aim_of(task, slots) == SPEAKER:
        return who_speaks(toolbox)
    said_at = where_person_is(task, slot_of(task, slots))
    ways = _seen_here(toolbox, slots)
    if toolbox.can_walk and isinstance(said_at, str) and said_at in toolbox.places:
        ways = [_seen_there(toolbox, slots, said_at) for _ in range(_GOES_THERE)]
    elif toolbox.can_walk and said_at is None:
        ways += people_in_rooms(toolbox, slots)
    return Alternatives("find the person", ways, looking_elsewhere_is_useless, worth_going)


def _seen_there(toolbox: Toolbox, slots: Many[str], room: str) -> Behaviour:
    """Go into a room, as far as people there leave a way, and look around in it."""
    level = toolbox.policy.level_gazes
    go: list[Behaviour] = [
        ChooseRoom("know the room", toolbox, {"rooms_before": "rooms"}, said=room),
        BestEffort(search_place("see who is in the way", toolbox, level[:1], slots)),
        *going(toolbox, {"place": "room"}),
    ]
    inside = IfOutside(Sequence("go there", memory=True, children=go), toolbox, room)
    look = Alternatives("look there", _seen_here(toolbox, slots), looking_elsewhere_is_useless, worth_going)
    return Sequence(f"in the {room}", memory=True, children=[BestEffort(inside), look])


def _seen_here(toolbox: Toolbox, slots: Many[str]) -> list[Behaviour]:
    level = toolbox.policy.level_gazes
    around = turned_around(toolbox, level, slots) if toolbox.can_walk else []
    return [search_place("look around", toolbox, level, slots), *around]


def _near(toolbox: Toolbox, slots: Many[str]) -> Behaviour:
    """Walk to where the person was seen, and look again: people walk on."""
    go: list[Behaviour] = [
        ReadyToWalk("stand upright", toolbox),
        with_room(toolbox, WalkTo("walk", toolbox, if_hands_fit=True), WalkTo("walk", toolbox)),
        Alternatives("see again", _seen_here(toolbox, slots), looking_elsewhere_is_useless, worth_going),
        IsNear("is near", toolbox),
    ]
    again = ReadyToWalk("stand upright", toolbox)
    attempts = toolbox.policy.of(MeetingSettings).attempts
    nearer = Retry(
        "approach", Sequence("attempt", memory=True, children=go), again, attempts, going_after_is_useless
    )
    return IfFar(Sequence("come near", memory=True, children=[nearer]), toolbox)


@judgement
def going_after_is_useless(failure: Failure, before: Failure | None) -> bool:
    """Who has walked on is walked after; where no way leads twice in a row, none does."""
    twice = before is not None and before.kind is failure.kind is FailureKind.INFEASIBLE
    fine = failure.kind in (FailureKind.POSTCONDITION, FailureKind.INFEASIBLE)
    return defect(failure) or bool(failure.choices) or twice or not fine
