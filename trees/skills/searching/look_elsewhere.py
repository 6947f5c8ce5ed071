"""Look from elsewhere for what a task is aimed at: turned around, on furniture, in rooms, behind things."""

from __future__ import annotations

from collections.abc import Mapping
from collections.abc import Sequence as Many

from py_trees.behaviour import Behaviour
from py_trees.composites import Sequence

from trees.beliefs.grounding.destination import SLOTS
from trees.failures import Failure, FailureKind
from trees.nodes.alternatives import Alternatives
from trees.nodes.judgements import judgement, looking_elsewhere_is_useless
from trees.policy import Gaze
from trees.skills.looking.locate import Locate
from trees.skills.looking.search_place import search_place
from trees.skills.searching.choose_furniture import ChooseFurniture
from trees.skills.searching.choose_outlook import ChooseOutlook
from trees.skills.searching.choose_room import ChooseRoom
from trees.skills.searching.recall_support import RecallSupport
from trees.skills.walking.change_viewpoint import ChangeViewpoint, Viewpoint
from trees.skills.walking.ready_to_walk import ReadyToWalk
from trees.skills.walking.walk_to import WalkTo
from trees.skills.walking.walk_with_room import change_viewpoint, with_room
from trees.toolbox import Toolbox

_FURNITURE, _ROOMS, _FURNITURE_THERE, _OUTLOOKS = 3, 2, 2, 2
"""The robot goes to so much furniture that it saw, to so many rooms, to so much furniture that it saw there,
and beside so many tall things that hide others."""
_CHOOSING = (ChooseFurniture, ChooseRoom, ChooseOutlook)
_ALL_AROUND: tuple[Viewpoint, ...] = ("around", "room", "around", "around")


def turned_around(toolbox: Toolbox, gazes: Many[Gaze], slots: Many[str] = SLOTS) -> list[Behaviour]:
    """Ways to see it by turning once around, after a step where there is no room to turn."""
    return [viewpoint(toolbox, k, way, gazes, slots) for k, way in enumerate(_ALL_AROUND, start=1)]


def found_by_turning(name: str, toolbox: Toolbox, gazes: Many[Gaze]) -> Alternatives:
    """Look from here, then turned around; reads "task", writes "place"."""
    policy = toolbox.policy
    turned: list[Behaviour] = [
        *turned_around(toolbox, (*policy.level_gazes, *policy.search_gazes[:1])),
        Locate("look once more", toolbox),
    ]
    ways: list[Behaviour] = [
        search_place("look around", toolbox, gazes),
        Alternatives("turned", turned, looking_elsewhere_is_useless, worth_going),
    ]
    return Alternatives(name, ways, looking_elsewhere_is_useless, turning_if_it_walks)


@judgement
def turning_if_it_walks(way: Behaviour, _failure: Failure | None) -> bool:
    """Turns only where the robot can."""
    turns = (leaf for leaf in way.iterate() if isinstance(leaf, ChangeViewpoint))
    return all(turn.toolbox.can_walk for turn in turns)


def viewpoint(
    toolbox: Toolbox, number: int, way: Viewpoint, gazes: Many[Gaze], slots: Many[str] = SLOTS
) -> Behaviour:
    """Go on, step back, or turn; and look. Reads "task", writes "place"."""
    looks: list[Behaviour] = [
        ReadyToWalk("stand upright", toolbox),
        change_viewpoint(toolbox, way),
        search_place("look around", toolbox, gazes, slots),
    ]
    return Sequence(f"viewpoint {number}", memory=True, children=looks)


def where_it_may_be(toolbox: Toolbox, outlooks: int = _OUTLOOKS) -> list[Behaviour]:
    """Ways to see it from before furniture that was seen, in other rooms, then from beside what is tall."""
    return [
        *(_look_on_furniture(toolbox, one) for one in range(1, _FURNITURE + 1)),
        *(_look_in_room(toolbox, one) for one in range(1, _ROOMS + 1)),
        *(_look_behind(toolbox, one) for one in range(1, outlooks + 1)),
    ]


def people_in_rooms(toolbox: Toolbox, slots: Many[str]) -> list[Behaviour]:
    """Ways to see somebody from the middle of other rooms, and turned around there."""
    gazes = toolbox.policy.level_gazes
    ways: list[Behaviour] = []
    for number in range(1, _ROOMS + 1):
        looks: list[Behaviour] = [
            search_place("look around", toolbox, gazes, slots),
            *turned_around(toolbox, gazes, slots),
        ]
        room = [
            ChooseRoom("choose room", toolbox, {"rooms_before": "rooms"}),
            *going(toolbox, {"place": "room"}),
            Alternatives("look in it", looks, looking_elsewhere_is_useless, worth_going),
        ]
        ways.append(Sequence(f"look in room {number}", memory=True, children=room))
    return ways


def where_it_was(toolbox: Toolbox) -> Behaviour:
    """Go to where it was seen before, if that is not here, and look there. Reads "task", writes "place"."""
    stood = {"place": "stood_on"}
    looks = [
        RecallSupport("recall where it was", toolbox, stood),
        *going(toolbox, stood),
        search_place("look around", toolbox, _at_tops(toolbox)),
    ]
    return Sequence("look where it was", memory=True, children=looks)


@judgement
def worth_going(way: Behaviour, failure: Failure | None) -> bool:
    """Makes room only where there was none to turn; furniture and tall things while some are left."""
    choosing = [leaf for leaf in way.children if isinstance(leaf, _CHOOSING)]
    if choosing:
        return failure is None or failure.root.reason is not choosing[0].NONE_LEFT
    room = any(isinstance(leaf, ChangeViewpoint) and leaf.settings["way"] == "room" for leaf in way.children)
    return not room or (failure is not None and failure.root.kind is FailureKind.INFEASIBLE)


def _look_on_furniture(toolbox: Toolbox, number: int) -> Behaviour:
    looks = [
        ChooseFurniture("choose furniture", toolbox, {"visited_before": "visited"}),
        *going(toolbox, {"place": "furniture"}),
        search_place("look around", toolbox, _at_tops(toolbox)),
    ]
    return Sequence(f"look on furniture {number}", memory=True, children=looks)


def _at_tops(toolbox: Toolbox) -> tuple[Gaze, ...]:
    """What stands on furniture is not to be seen to the side at the height of the eyes."""
    first, *others = toolbox.policy.search_gazes
    return (first, toolbox.policy.level_gazes[0], *others)


def _look_in_room(toolbox: Toolbox, number: int) -> Behaviour:
    """From its middle, on what stands there, and once turned around."""
    policy = toolbox.policy
    gazes = (*policy.level_gazes, *policy.search_gazes[:1])
    ways = [
        search_place("look around", toolbox, gazes),
        *(_look_on_furniture(toolbox, one) for one in range(1, _FURNITURE_THERE + 1)),
        viewpoint(toolbox, 1, "around", gazes),
        _look_on_furniture(toolbox, _FURNITURE_THERE + 1),
    ]
    looks = [
        ChooseRoom("choose room", toolbox, {"rooms_before": "rooms"}),
        *going(toolbox, {"place": "room"}),
        Alternatives("look in it", ways, looking_elsewhere_is_useless, worth_going),
    ]
    return Sequence(f"look in room {number}", memory=True, children=looks)


def _look_behind(toolbox: Toolbox, number: int) -> Behaviour:
    looks = [
        ChooseOutlook("choose outlook", toolbox, {"hiding_before": "hiding"}),
        *going(toolbox, {"place": "hides", "stand": "outlook"}),
        search_place("look around", toolbox, toolbox.policy.level_gazes),
    ]
    return Sequence(f"look behind {number}", memory=True, children=looks)


def going(toolbox: Toolbox, there: Mapping[str, str]) -> tuple[Behaviour, Behaviour]:
    """Stand upright, and walk where some names of the walk's ports say.

    Args:
        toolbox: What leaves may call.
        there: The names that ports of the walk have: where its "place" and its "stand" come from.
    """
    walk = WalkTo("walk", toolbox, if_hands_fit=True, wiring=there)
    return (
        ReadyToWalk("stand upright", toolbox),
        with_room(toolbox, walk, WalkTo("walk", toolbox, wiring=there)),
    )
