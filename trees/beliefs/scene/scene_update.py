"""Fold what a look saw into the planning scene."""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterable, Mapping
from dataclasses import dataclass, replace
from types import MappingProxyType

import numpy as np

from kinematics.arrays import Array
from kinematics.geometry import poses
from kinematics.geometry.poses import Transform
from kinematics.geometry.shapes import Box, Shape
from kinematics.scene.label import Label
from kinematics.scene.planning_scene import FLOOR, PlanningScene, SceneObject
from robots.perception.object_estimate import ObjectEstimate
from trees.policy import TreePolicy

_SAME_PLACE = 0.5
"""Two whose middles are nearer than this share of the wider one's width are at one place."""
SURE = 0.6
"""A sighting with less confidence does not do away with what is known."""
_STACKED = 0.4
"""Of both heights: middles farther apart than this are one above the other."""
_OVERLAP = 0.85
"""Two things whose middles are nearer than this share of both half widths would reach into each other."""
_WITHIN_M = 0.01
_ALL_OF_IT = 0.9
"""What is longer, wider and higher than this share of a thing is all of it, or nearly so."""
_HOLDS, _HOLDS_M = 1.0, 0.05
"""What is wider than this share of a thing, and so much more, could hold it."""


@dataclass(frozen=True, slots=True)
class SceneUpdate:
    """What a look has changed: the new planning scene, and what was seen, by the names in that scene."""

    scene: PlanningScene
    seen: Mapping[str, ObjectEstimate]


def kind_of(name: str) -> str:
    """The words of an object's name without its number: "red cup 2" is a "red cup"."""
    return name.rstrip("0123456789").rstrip()


def is_name(name: str) -> bool:
    """Whether it is what somebody is called: there is one person of that name."""
    return name[:1].isupper()


def words_for(estimate: ObjectEstimate) -> str:
    """How a thing is called: by its name, else by its kind, and an object by its colour as well, if known."""
    if estimate.category != "object":
        return estimate.name or estimate.kind
    # a capital letter is a person's, and a number at the end tells things of one name apart
    return kind_of(estimate.label.words.lower()) or estimate.kind


def updated_scene(
    scene: PlanningScene,
    estimates: Iterable[ObjectEstimate],
    policy: TreePolicy,
    could_be_unseen: Callable[[SceneObject], bool],
    may_have_moved: bool = True,
    reserved: Collection[str] = (FLOOR,),
    before: Mapping[str, ObjectEstimate] = MappingProxyType({}),
) -> SceneUpdate:
    """Replace what was seen anew, keep what could not be seen, drop what is no longer there.

    Names are kept from look to look. Furniture is never dropped: it does not walk away, and a
    robot that forgets a table runs into it. People do walk: who is recognised elsewhere is there.
    An object that was not seen is kept only where it may be out of view or hidden, and only while no
    other of its kind and colour has appeared (then it moved).

    Args:
        scene: What was believed before.
        estimates: What this look saw, in the odometry frame.
        policy: Margins, and how far apart two sightings of one object may be.
        could_be_unseen: Whether a thing could be where it is believed to be without being seen.
        may_have_moved: Whether one that appears may be one that was seen elsewhere in this task; not while
            the head merely looks around. What an earlier task has seen may have moved in any case.
        reserved: Names of the robot's parts and of the floor, by which the scene tells what may touch: what
            is called so is numbered from 2 on ("floor 2").
        before: How things were last seen in this task, by their names. A worse sighting, an unsure one or one
            that the picture's edge cuts off, of what was well seen says that it is still there, and nothing
            else; of what was badly seen, a part of a thing as a rule, a good one says what it is.
    """
    groups: dict[str, list[ObjectEstimate]] = {}
    parts_of: dict[str, list[ObjectEstimate]] = {}
    seen_now: list[ObjectEstimate] = []
    for estimate in estimates:
        name = _badly_seen(estimate, scene, before)
        if name is not None:
            parts_of.setdefault(name, []).append(estimate)
            continue
        seen_now.append(estimate)
        groups.setdefault(words_for(estimate), []).append(estimate)
    something = [part for parts in parts_of.values() for part in parts]
    objects: dict[str, SceneObject] = {}
    seen: dict[str, ObjectEstimate] = {}
    known_words = [kind_of(name) for name in scene.objects]
    for words in sorted({*groups, *known_words}):
        known = {name: item for name, item in scene.objects.items() if kind_of(name) == words}
        fresh = groups.get(words, [])
        furniture = any(not item.movable for item in known.values())
        matched = _match(known, fresh, policy.same_furniture_m if furniture else policy.same_object_m)
        strangers = [estimate for estimate in fresh if not any(estimate is m for m in matched.values())]
        for name, item in known.items():
            if name in matched:
                continue
            moved = bool(strangers) and (may_have_moved or name not in before or is_name(name))
            there = could_be_unseen(item) or name in parts_of or _place_taken(item, something)
            hidden = not moved and there and not _place_taken(item, seen_now)
            partial = name in before and before[name].cut and _is_part(before[name], seen_now)
            stays = hidden and not partial if item.movable else not (moved and is_name(name))
            if stays:
                objects[name] = item
                parts = parts_of.get(name, ())
                alike = next(
                    (part for part in parts if words_for(part) == words or _may_be(part, item)), None
                )
                if alike is not None:
                    seen[name] = _as_known(before.get(name, alike), item)
        taken = {*objects, *matched, *scene.attached, *reserved}
        for estimate in sorted(strangers, key=_face_m2, reverse=True):  # "table" is its top, not a leg
            name = _free_name(words, taken)
            taken.add(name)
            matched[name] = estimate
        for name, estimate in matched.items():
            objects[name] = scene_object(name, estimate, policy)
            seen[name] = estimate
    return SceneUpdate(scene.with_objects(objects.values()), seen)


def _as_known(estimate: ObjectEstimate, item: SceneObject) -> ObjectEstimate:
    """A sighting of a thing of which no more than a part is seen now: it is still as it is known to be."""
    return replace(estimate, odom_T_object=item.world_T_object, shape=item.shape)


def _well_seen(estimate: ObjectEstimate) -> bool:
    """Whether a sighting is sure of itself, and of all of the thing."""
    return estimate.confidence >= SURE and not estimate.cut


def _badly_seen(
    estimate: ObjectEstimate, scene: PlanningScene, before: Mapping[str, ObjectEstimate]
) -> str | None:
    """The known thing that a sighting is of which is unsure of itself, its kind or its size; None for none.

    Half of a cup, the other half behind a hand or cut by the picture's edge, looks like a box, or like a
    lower cup, and one wall of an open box like a board.
    """
    if estimate.category != "object" or not (estimate.confidence < SURE or estimate.cut or estimate.alike):
        return None
    words = words_for(estimate)
    for name, item in scene.objects.items():
        if not item.movable:
            continue
        known_well = name in before and _well_seen(before[name])
        partial = estimate.cut and not _as_large(estimate, item)
        no_larger = known_well or _length_m(estimate.shape) < _length_m(item.shape)
        if partial and no_larger and _may_be_part(estimate, item.shape, item.world_T_object):
            return name
        unsure = estimate.confidence < SURE or partial
        if kind_of(name) != words:
            doubted = unsure or _may_be(estimate, item)
            if doubted and _same_place(item, estimate) and not _could_hold(item, estimate):
                return name
        elif unsure and known_well and (_same_place(item, estimate) or _is_within(estimate, item)):
            return name
    return None


def _may_be(estimate: ObjectEstimate, item: SceneObject) -> bool:
    """Whether a sighting can be of a thing by its kind and its colour."""
    return item.label is not None and estimate.may_be(item.label.kind, item.label.color)


def _as_large(estimate: ObjectEstimate, item: SceneObject) -> bool:
    """Whether what is seen of a thing is about as long, wide and high as it is known to be."""
    seen, known = estimate.shape, item.shape
    return (
        _width_m(seen) > _ALL_OF_IT * _width_m(known)
        and _length_m(seen) > _ALL_OF_IT * _length_m(known)
        and seen.height_m > _ALL_OF_IT * known.height_m
    )


def _is_part(part: ObjectEstimate, seen: Iterable[ObjectEstimate]) -> bool:
    """Whether what was cut off by the picture's edge may be of something that is seen whole now."""
    return any(
        whole.category == "object"
        and _well_seen(whole)
        and _may_be_part(part, whole.shape, whole.odom_T_object)
        for whole in seen
    )


def _may_be_part(part: ObjectEstimate, shape: Shape, world_T_shape: Transform) -> bool:
    """Whether what goes on beyond the picture's edge, who knows whither, touches a solid."""
    room_m = _WITHIN_M + 0.5 * _length_m(part.shape)
    return _reaches(shape, world_T_shape, part.odom_T_object[:, 3], room_m)


def _place_taken(item: SceneObject, seen: Iterable[ObjectEstimate]) -> bool:
    """Whether something is seen where a thing was believed to be: two are never at one place.

    What may lie in it takes no place of its own.
    """
    return any(
        estimate.category == "object" and _same_place(item, estimate) and not _could_hold(item, estimate)
        for estimate in seen
    )


def _same_place(item: SceneObject, estimate: ObjectEstimate) -> bool:
    """Whether a thing and a sighting are of one place.

    A sighting of what is so much wider that it could hold the thing is another matter, and so is what is
    below or above it.
    """
    width, other = _width_m(item.shape), _width_m(estimate.shape)
    near = _beside_m(item, estimate) <= _SAME_PLACE * max(width, other)
    return near and not _stacked(item, estimate) and other < _HOLDS * width + _HOLDS_M


def _beside_m(item: SceneObject, estimate: ObjectEstimate) -> float:
    """How far apart a thing and a sighting are along the floor."""
    away = item.world_T_object[:2, 3] - estimate.odom_T_object[:2, 3]
    return float(np.hypot(away[0], away[1]))


def _stacked(item: SceneObject, estimate: ObjectEstimate) -> bool:
    """Whether one is above the other."""
    up_m = abs(float(item.world_T_object[2, 3] - estimate.odom_T_object[2, 3]))
    return up_m > _STACKED * (item.shape.height_m + estimate.shape.height_m)


def _could_hold(item: SceneObject, estimate: ObjectEstimate) -> bool:
    """Whether a thing is so wide that what is seen may lie in it, and is as unsure for that."""
    return _width_m(item.shape) > _length_m(estimate.shape) + _HOLDS_M


def _is_within(estimate: ObjectEstimate, item: SceneObject) -> bool:
    """Whether the middle of a sighting is in a thing: one side of a box that the picture cuts off."""
    return _reaches(item.shape, item.world_T_object, estimate.odom_T_object[:, 3], _WITHIN_M)


def _reaches(shape: Shape, world_T_shape: Transform, place: Array, room_m: float) -> bool:
    """Whether a solid holds a place, shape (4,), or ends nearer to it than that."""
    local = poses.inverse(world_T_shape) @ place
    if isinstance(shape, Box):
        half = 0.5 * np.array(shape.size_m) + room_m
        return bool((np.abs(local[:3]) < half).all())
    beside = float(np.hypot(local[0], local[1])) < shape.radius_m + room_m
    return beside and abs(float(local[2])) < 0.5 * shape.height_m + room_m


def _width_m(shape: Shape) -> float:
    return min(shape.size_m[:2]) if isinstance(shape, Box) else 2.0 * shape.radius_m


def _length_m(shape: Shape) -> float:
    return max(shape.size_m[:2]) if isinstance(shape, Box) else 2.0 * shape.radius_m


def _match(
    known: Mapping[str, SceneObject], fresh: list[ObjectEstimate], within_m: float
) -> dict[str, ObjectEstimate]:
    """Pair names with estimates, nearest pairs first, each at most once."""
    pairs = sorted(
        (_apart_m(item, estimate), name, i)
        for name, item in known.items()
        for i, estimate in enumerate(fresh)
    )
    matched: dict[str, ObjectEstimate] = {}
    used: set[int] = set()
    for distance, name, i in pairs:
        if name in matched or i in used:
            continue
        moves = known[name].movable or fresh[i].category == "person"
        if distance <= within_m or (moves and _overlap(known[name], fresh[i])):
            matched[name] = fresh[i]
            used.add(i)
    return matched


def _apart_m(item: SceneObject, estimate: ObjectEstimate) -> float:
    """How far apart two sightings are; of what moves on a piece with a model, while that is shut."""
    if item.moves is None or estimate.moves is None:
        return float(np.linalg.norm(item.world_T_object[:3, 3] - estimate.odom_T_object[:3, 3]))
    if not item.moves.is_same(estimate.moves):
        return math.inf
    return math.dist(item.moves.shut[:3, 3], estimate.moves.shut[:3, 3])


def _overlap(item: SceneObject, estimate: ObjectEstimate) -> bool:
    """Whether two things or people, there and here, would reach into each other: so it is one, seen wrongly.

    What is seen unsurely, half of it beyond the edge of the picture, is no second one where it may reach.
    """
    width_m = _width_m if _well_seen(estimate) else _length_m
    least_m = 0.5 * _OVERLAP * (width_m(item.shape) + width_m(estimate.shape))
    return not _stacked(item, estimate) and _beside_m(item, estimate) < least_m


def _free_name(words: str, taken: set[str]) -> str:
    number = 1
    name = words
    while name in taken:
        number += 1
        name = f"{words} {number}"
    return name


def _label(name: str, estimate: ObjectEstimate) -> Label:
    """What it is called; furniture is told by its own name, whatever else it is called."""
    if estimate.category == "object":
        return estimate.label
    words = kind_of(name)
    if estimate.category == "person":
        return Label(words, traits=estimate.traits)
    names = (words, *estimate.names) if estimate.names else ()
    return Label(words, names=names, categories=estimate.categories)


def scene_object(name: str, estimate: ObjectEstimate, policy: TreePolicy) -> SceneObject:
    """What was seen, as a planning scene has it."""
    fixed = estimate.category != "object"
    return SceneObject(
        name=name,
        shape=estimate.shape,
        world_T_object=estimate.odom_T_object,
        margin_m=policy.furniture_margin_m if fixed else policy.object_margin_m,
        movable=not fixed,
        label=_label(name, estimate),
        moves=estimate.moves,
    )


def _face_m2(estimate: ObjectEstimate) -> float:
    """Of a box from above; nothing for what is round. A fridge is its boards, not its back."""
    return estimate.shape.size_m[0] * estimate.shape.size_m[1] if isinstance(estimate.shape, Box) else 0.0
