"""Which door or drawer is meant, among several."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace

from robots.scenes.scene_description import Region
from trees.beliefs.grounding.articles import with_article
from trees.beliefs.grounding.furniture_called import called_so, is_at, is_of, places_told, whole_in
from trees.beliefs.grounding.grounding import Ambiguous, Found, Missing, choices_among, ground
from trees.beliefs.grounding.names_of_things import may_name_a
from trees.beliefs.grounding.questions import which_is_meant
from trees.beliefs.grounding.ranking import PLACES, wrong_side
from trees.beliefs.openings.handles import BODY_OF, MEANT_BY, SHUT, HandleTarget
from trees.beliefs.scene.believed_thing import BelievedThing, Surroundings
from trees.failures import Failure
from trees.readings.odometry import what_is_around
from trees.tasks import CloseTask, ObjectDescription, OpenTask
from trees.toolbox import Toolbox

_NOT_ALONE = ("bottom", "middle")
"""Places that nobody says of the only one, as little as "the last"."""


def meant_part(
    task: OpenTask | CloseTask, fitting: Sequence[HandleTarget], toolbox: Toolbox
) -> HandleTarget | Failure:
    """The one that is described: "the top drawer", "the left door"; a question where several are.

    Of several that nothing tells apart it is the only one that is not open, or shut, already.

    Args:
        task: What is to be done.
        fitting: At least one; each is in the planning scene.
        toolbox: Tells where the robot stands, and what is around it.
    """
    if (wrong := misnamed(task, fitting)) is not None:
        return wrong
    described = replace(_described(task), name=None)
    if whole_of(task, toolbox.places) and all(item.moves is not None for item in fitting):
        described = replace(described, relation=None)
    if described.ordinal in PLACES and all(places_told(item.moves) for item in fitting):
        described = replace(described, ordinal=None)  # a model has told which is where
    around = what_is_around(toolbox)
    parts = {item.part: item for item in fitting}
    if described == ObjectDescription(described.kind):
        undone = {item.part: item for item in fitting if not is_so(task, item)}
        parts = undone or {item.part: item for item in fitting[:1]}
    room = _room_of(described, toolbox)
    if room is not None:
        described = replace(described, relation=None)
        parts = {name: item for name, item in parts.items() if _is_in(room, name, toolbox)}
    among = [thing for thing in around.things if thing.name in parts]
    match _told(described, around, among):
        case Ambiguous() as unclear:
            return which_is_meant(unclear)
        case Missing(message):
            return Failure.postcondition(message)
        case Found(names):
            return parts[names[0]]


def misnamed(task: OpenTask | CloseTask, fitting: Sequence[HandleTarget]) -> Failure | None:
    """Why none of them is meant: a name that contradicts the kind is another thing's."""
    wanted = _described(task)
    if wanted.name is None or any(item.part == wanted.name for item in fitting):
        return None
    kinds = MEANT_BY if wanted.kind is None else (wanted.kind,)
    if any(may_name_a(kind, wanted.name) for kind in kinds):
        return None
    return Failure.postcondition(f"no {wanted.name} seen")


def _described(task: OpenTask | CloseTask) -> ObjectDescription:
    return task.object if isinstance(task.object, ObjectDescription) else ObjectDescription()


def noun_of(task: OpenTask | CloseTask) -> str | None:
    """What was said that is to be opened or closed; None where that was left open."""
    return task.object.kind if isinstance(task.object, ObjectDescription) else None


def those_meant(
    task: OpenTask | CloseTask,
    items: Sequence[HandleTarget],
    places: Collection[str],
    known: Mapping[str, Collection[str]],
) -> list[HandleTarget]:
    """The doors and drawers of the kind that the noun means, and of the piece that is named.

    "The microwave" means its door; "the drawer of the cabinet" one of the cabinet's.

    Args:
        task: What is to be done.
        items: All that were seen.
        places: Names of the rooms on the map.
        known: What furniture is called, and what besides, as for ``called_so``.
    """
    noun, whole, place = noun_of(task), whole_of(task, places), _described(task).ordinal
    nouns = None if noun is None else {noun, *called_so(noun, known)}
    return [
        item for item in items if _is_a(nouns, item) and is_of(whole, item.moves) and is_at(place, item.moves)
    ]


def those_meant_here(
    task: OpenTask | CloseTask, items: Sequence[HandleTarget], toolbox: Toolbox
) -> list[HandleTarget]:
    """Those that are meant where the robot is, by what it believes to be there."""
    return those_meant(task, items, toolbox.places, what_is_around(toolbox).furniture_words)


def whole_of(task: OpenTask | CloseTask, places: Collection[str]) -> str | None:
    """The piece that it is said to be in: "cabinet" of "the top drawer of the cabinet"; a room is none."""
    whole = whole_in(_described(task))
    return None if whole in places else whole


def _is_a(nouns: Collection[str] | None, item: HandleTarget) -> bool:
    if nouns is None or item.kind in nouns:
        return True
    if item.moves is None:
        return any(MEANT_BY.get(noun) == item.kind for noun in nouns)
    return any(is_of(noun.removesuffix(f" {item.kind}"), item.moves) for noun in nouns)


def opens_nothing(task: OpenTask | CloseTask, fronts: Collection[str]) -> str:
    """That what is named is neither a door nor a drawer, nor has one that is known; else empty.

    Args:
        task: What is to be done.
        fronts: What perception tells apart by the piece that it is of: "microwave door".
    """
    noun = noun_of(task)
    if noun is None or noun in MEANT_BY or any(_has(noun, front) for front in fronts):
        return ""
    return f"{with_article(noun)} is nothing that I can open or close"


def with_fronts(fronts: Collection[str], kind: str | None) -> set[str]:
    """What has doors or drawers, by what those are called: "microwave" of "microwave door".

    Args:
        fronts: What they are called.
        kind: "door" or "drawer"; None for both.
    """
    split = (front.rpartition(" ") for front in fronts)
    return {of for of, _, part in split if of and part in ((kind,) if kind else BODY_OF)}


def _has(noun: str, front: str) -> bool:
    """Whether that is the door or drawer of what somebody names."""
    of = front.rpartition(" ")[0]
    return noun in (front, of, of.rpartition(" ")[2])


def is_so(task: OpenTask | CloseTask, item: HandleTarget) -> bool:
    """Whether a door or drawer is as the task wants it."""
    if isinstance(task, OpenTask):
        return item.opening >= item.open_enough
    return item.opening <= SHUT[item.kind]


def _told(
    described: ObjectDescription, around: Surroundings, among: list[BelievedThing]
) -> Found | Missing | Ambiguous:
    """As for objects; but colours of furniture are not seen, and the only one is not called the last."""
    if not among:
        return Missing(f"no {described} seen")
    if described.color is not None:
        question = f"which one is {described.color}? that is not seen of what opens"
        return Ambiguous(question, choices_among(among))
    if len(among) == 1 and described.ordinal is not None:
        aside = wrong_side(described.ordinal, among[0])
        if aside is not None:
            return Missing(f"only one {among[0].kind} seen, and it is on the {aside}")
        if described.ordinal == "last" or PLACES.get(described.ordinal) in _NOT_ALONE:
            return Missing(f"only one {among[0].kind} seen")
    return ground(described, around, among=among)


def _room_of(described: ObjectDescription, toolbox: Toolbox) -> Region | None:
    """The room of the map that it is said to be in."""
    relation = described.relation
    if relation is None or not isinstance(relation.to, str):
        return None
    return toolbox.places.get(relation.to)


def _is_in(room: Region, part: str, toolbox: Toolbox) -> bool:
    x_m, y_m = toolbox.world.scene.objects[part].world_T_object[:2, 3].tolist()
    return room.contains(x_m, y_m)
