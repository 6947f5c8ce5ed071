"""What a task is aimed at: a thing, furniture, a person, as it was last seen, or a place of the map."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from types import MappingProxyType
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Sealed
from kinematics.geometry.planar import PlanarPose
from kinematics.geometry.poses import Transform
from kinematics.geometry.shapes import Box, Shape
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from robots.perception.detector import Category
from robots.perception.object_estimate import ObjectEstimate
from robots.scenes.furniture_names import kind_called
from robots.scenes.scene_description import Region
from trees.beliefs.grounding.choice_words import from_the_left
from trees.beliefs.grounding.furniture_called import called_so
from trees.beliefs.grounding.grounding import (
    Ambiguous,
    Choice,
    Found,
    Grounding,
    Missing,
    ground,
    ground_furniture,
    says_which,
)
from trees.beliefs.grounding.names_of_things import may_name_a
from trees.beliefs.grounding.questions import which_is_meant
from trees.beliefs.grounding.report_words import kinds_in
from trees.beliefs.scene.believed_thing import PERSON, Surroundings
from trees.beliefs.scene.labels import besides, label_of, plain, words_besides
from trees.beliefs.scene.scene_update import kind_of
from trees.failures import Failure, Reason
from trees.tasks import Destination, HandOverTask, ObjectDescription, ObjectOf

# From the top of a person's cylinder down to the middle of the face.
_FACE_BELOW_TOP_M = 0.13
# Confidence in what is not in view.
_BELIEVED = 0.5
_ANYBODY = ("me", "in_front", "in front", "person", "somebody")


@dataclass(frozen=True, slots=True)
class Place(Sealed):
    """What a task is aimed at: a thing, a piece of furniture, a person or a part of the floor, with its pose.

    Attributes:
        name: Its name in the planning scene.
        category: What sort of thing it is; "region" for a part of the floor.
        shape: Its solid.
        odom_T_place: Its pose, shape (4, 4).
        confidence: How sure the detector was of it, in [0, 1].
        because: Why it is that, for people, where the word that was said is not what it is called.
    """

    name: str
    category: Category | Literal["region"]
    shape: Shape
    odom_T_place: Transform
    confidence: float
    because: str = ""

    @property
    def aim_m(self) -> NDArray[np.float64]:
        """What to look at or point at, shape (3,): the middle of a thing, the face of a person."""
        middle: NDArray[np.float64] = self.odom_T_place[:3, 3].copy()
        if self.category == "person":
            middle[2] += 0.5 * self.shape.height_m - _FACE_BELOW_TOP_M
        return middle


SLOTS = ("object", "person", "to", "on", "source")
"""Slots of tasks that say what they are aimed at, the one that counts first."""


def aim_of(task: object, slots: Sequence[str] = SLOTS) -> Destination | None:
    """The slot of a task that says what it is aimed at: an object, a person, or a place.

    Raises:
        TypeError: It refers to an object of another task that was not filled in.
    """
    slot = slot_of(task, slots)
    wanted: Destination | None = None if slot is None else getattr(task, slot)
    if isinstance(wanted, ObjectOf):
        raise TypeError("the object of an earlier task was not filled in")
    return wanted


def slot_of(task: object, slots: Sequence[str] = SLOTS) -> str | None:
    """Name of the slot that says what a task is aimed at."""
    return next((slot for slot in slots if getattr(task, slot, None) is not None), None)


WHOSE = "of"
"""The slot of a task that tells something of somebody."""


PERSON_SLOTS = (PERSON,)
"""For what is done to somebody, or said."""


def aims_at_person(task: object, slot: str | None) -> bool:
    """Whether what a slot describes is somebody, whatever the words are."""
    return slot in (PERSON, WHOSE) or (slot == "to" and isinstance(task, HandOverTask))


def where_person_is(task: object, slot: str | None) -> Destination | None:
    """Where the person whom a slot describes is said to be; None where nobody says it, or it is no person."""
    described = WHOSE if hasattr(task, WHOSE) else PERSON
    has_thing = getattr(task, "object", None) is not None
    return getattr(task, "source", None) if slot == described and not has_thing else None


def is_anybody(wanted: Destination | None) -> bool:
    """Whether a person is meant of whom nothing is said."""
    return wanted in (None, *_ANYBODY[1:]) or wanted == ObjectDescription(PERSON)


def resolve(
    wanted: Destination | None,
    seen: Mapping[str, ObjectEstimate],
    around: Surroundings,
    slot: str = "object",
    somebody: bool = False,
    recalled: Mapping[str, Place] = MappingProxyType({}),
    *,
    whoever: bool = False,
) -> Place | Failure:
    """Find what is meant among what was seen.

    Args:
        wanted: A description, or the name of a person, a place or a piece of furniture; "me" is the
            nearest person, "in_front" (and None) the one who stands most straight ahead.
        seen: Estimates by the names that they have in the planning scene.
        around: What is believed, for descriptions that compare things.
        slot: Of the task, that says so; an answer to a question goes there.
        somebody: Whether a person is meant, whatever the words are.
        recalled: People by their names, where they were seen before.
        whoever: Whether one who is there is meant, of whom nothing is said: not the one straight ahead.

    Returns:
        The place, or why not: nothing fits, or several things do (the failure has ``choices``).
    """
    if isinstance(wanted, ObjectOf):
        raise TypeError("the object of an earlier task was not filled in")
    if whoever:
        return _grounded(person_meant(ObjectDescription(PERSON), around), seen, slot, recalled)
    if isinstance(wanted, ObjectDescription) and compares_people(wanted, somebody):
        return _grounded(person_meant(wanted, around), seen, slot, recalled, one_will_do=True)
    if isinstance(wanted, ObjectDescription) and wanted.kind != PERSON and not wanted.name:
        if says_which(wanted) and _has_furniture(seen, wanted):
            return _grounded(ground_furniture(wanted, around), seen, slot)
        fitting = _furniture_called(wanted.kind, seen) if wanted.kind and wanted.color is None else {}
        if not fitting:
            return _grounded(ground(wanted, around), seen, slot)
    else:
        word = wanted if isinstance(wanted, str) else "in_front" if wanted is None else wanted.name or PERSON
        fitting = _named(word, seen, around)
        if isinstance(wanted, ObjectDescription) and wanted.name and wanted.kind is not None:
            fitting = {name: item for name, item in fitting.items() if _may_be_a(wanted.kind, name, item)}
    if not fitting:
        message = f"no {words_of(wanted)} seen"
        return Failure.postcondition(message, seen=kinds_in(seen)).because(Reason.NOT_SEEN)
    if len(fitting) > 1:
        choices = tuple(Choice(name, name) for name in sorted(fitting))
        message = f"which {words_of(wanted)}? there are {len(fitting)}"
        return which_is_meant(Ambiguous(message, choices), slot)
    ((name, item),) = fitting.items()
    return place_from(name, item)


def place_from(name: str, item: ObjectEstimate) -> Place:
    """A sighting as a place."""
    return Place(name, item.category, item.shape, item.odom_T_object, item.confidence)


def place_believed(item: SceneObject, category: Category) -> Place:
    """Where something was when it was last seen, half believed: a person may have gone or moved it."""
    return Place(item.name, category, item.shape, item.world_T_object, _BELIEVED)


def people_first(seen: Mapping[str, ObjectEstimate], around: Surroundings) -> list[str]:
    """Names of the people in view, the one who stands most straight ahead of the robot first."""
    people = [name for name, item in seen.items() if item.category == "person"]
    places = _places(seen, around)
    return sorted(people, key=lambda name: (abs(math.atan2(places[name][1], places[name][0])), name))


def _places(seen: Mapping[str, ObjectEstimate], around: Surroundings) -> dict[str, NDArray[np.float64]]:
    """Where things are, from the robot; what nobody believes in yet, from the odometry frame."""
    believed = {thing.name: thing.place_m for thing in around.things}
    return {name: believed.get(name, item.odom_T_object[:3, 3]) for name, item in seen.items()}


def furniture_named(kind: str, scene: PlanningScene) -> list[SceneObject]:
    """The solids of the furniture that is called so in a scene, the one with the largest face first."""
    fixed = [item for item in scene.objects.values() if not item.movable]
    words = called_so(kind, words_besides((kind_of(item.name), label_of(item)) for item in fixed))
    found = [item for item in fixed if kind_of(item.name) in words]
    return sorted(found, key=lambda item: -_face_m2(item))


def _grounded(
    meant: Grounding,
    seen: Mapping[str, ObjectEstimate],
    slot: str,
    recalled: Mapping[str, Place] = MappingProxyType({}),
    *,
    one_will_do: bool = False,
) -> Place | Failure:
    """Something among what is believed; but for what is recalled it must have been seen just now.

    Who is alone there is the guest, whatever a guest looks like: ``one_will_do``.
    """
    match meant:
        case Ambiguous() as unclear:
            return which_is_meant(unclear, slot, one_will_do=one_will_do)
        case Missing(message):
            return Failure.postcondition(message, seen=kinds_in(seen)).because(Reason.NOT_SEEN)
        case Found(names, because):
            if names[0] in seen:
                return replace(place_from(names[0], seen[names[0]]), because=because)
            if names[0] in recalled:
                return recalled[names[0]]
            message = f"{_the(names[0])} was seen before, but is not in view now"
            return Failure.postcondition(message).because(Reason.OUT_OF_VIEW)


def _the(name: str) -> str:
    return name if name[:1].isupper() else f"the {name}"


def _has_furniture(seen: Mapping[str, ObjectEstimate], wanted: ObjectDescription) -> bool:
    kind, said = kind_called(wanted.kind or ""), plain(wanted.kind or "")
    pieces = (item for item in seen.values() if item.category == "furniture")
    return any(item.kind == kind or said in besides(item.label) for item in pieces)


def _furniture_called(said: str, seen: Mapping[str, ObjectEstimate]) -> dict[str, ObjectEstimate]:
    """Of furniture, "table" is its top, "table 2" a leg or another one."""
    furniture = {name: item for name, item in seen.items() if item.category == "furniture"}
    words = called_so(said, words_besides((kind_of(name), item.label) for name, item in furniture.items()))
    return {name: item for name, item in furniture.items() if name in words or name.lower() == said.lower()}


def _named(word: str, seen: Mapping[str, ObjectEstimate], around: Surroundings) -> dict[str, ObjectEstimate]:
    people = people_first(seen, around)
    if word in _ANYBODY:
        if word == "me":
            places = _places(seen, around)
            people.sort(key=lambda name: float(np.linalg.norm(places[name][:2])))
        return {name: seen[name] for name in people[:1]}
    same = [name for name in people if name.casefold() == word.casefold()]
    things = [name for name, item in seen.items() if item.category == "object" and word in (name, item.kind)]
    return {name: seen[name] for name in same or _furniture_called(word, seen) or things}


def _may_be_a(kind: str, name: str, item: ObjectEstimate) -> bool:
    return kind == item.kind or may_name_a(kind.casefold(), name)


def _face_m2(item: SceneObject) -> float:
    size = getattr(item.shape, "size_m", (0.0, 0.0, 0.0))
    return float(size[0] * size[1])


def called(wanted: Destination | None) -> str:
    """What a task is aimed at, as people call it: "the kitchen", "the red cup", "Ana", "the person"."""
    by_name = isinstance(wanted, str) and not wanted.islower()
    return words_of(wanted) if by_name else f"the {words_of(wanted)}"


def words_of(wanted: Destination | None) -> str:
    """The same without an article."""
    if wanted is None or wanted in _ANYBODY:
        return "person"
    return str(wanted)


def compares_people(wanted: ObjectDescription, somebody: bool = False) -> bool:
    """Whether it says more of a person than that it is one: who was seen first is not taken for them then.

    Args:
        wanted: A description.
        somebody: Whether a person is meant, whatever the words are.
    """
    if wanted.name or not (somebody or wanted.kind == PERSON):
        return False
    said = (wanted.ordinal, wanted.relation, wanted.size, wanted.color, wanted.material)
    return wanted.kind != PERSON or bool(wanted.traits) or any(one is not None for one in said)


def person_meant(wanted: ObjectDescription, around: Surroundings) -> Grounding:
    """Find somebody by order and place; what cannot be seen of people leads to a question.

    Args:
        wanted: A description of somebody: "the person on the left", "the guest".
        around: What is believed to be around.
    """
    people = tuple(thing for thing in around.things if thing.is_person)
    if not people:
        return Missing(f"no {wanted} seen")
    if wanted.kind == PERSON and wanted.color is None:
        return ground(wanted, around, among=people)
    choices = tuple(Choice(thing.name, thing.name) for thing in from_the_left(people))
    return Ambiguous(f"which one is the {wanted}? that cannot be seen of people", choices)


START = "start"
"""What a task calls the place where the robot began."""
_HEIGHT_M = 2.0
_SPOT_M = 0.1


def place_of_region(name: str, region: Region) -> Place:
    """A region as a place, certain as the map is."""
    pose = PlanarPose(*region.position_m, region.yaw_rad).transform(0.5 * _HEIGHT_M)
    return Place(name, "region", Box((*region.size_m, _HEIGHT_M)), pose, 1.0)


def start() -> Place:
    """Where the robot began and how it stood there: the origin of its odometry."""
    return Place(
        START, "region", Box((_SPOT_M, _SPOT_M, _HEIGHT_M)), PlanarPose().transform(0.5 * _HEIGHT_M), 1.0
    )
