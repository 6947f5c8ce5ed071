"""Where an object is to be put, and why there."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace

import numpy as np

from kinematics.arrays import Array
from kinematics.geometry import poses
from kinematics.geometry.poses import Transform
from kinematics.geometry.shapes import Box, Shape
from kinematics.requests.place import Spot
from kinematics.scene.free_spots import FreeSpot, footprint_radius_m, spots_beside, spots_on
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from kinematics.scene.support_of import furniture_right_below, support_of
from robots.scenes.furniture_names import kind_called
from robots.scenes.meshes.up_axis import upright
from trees.beliefs.grounding.destination import furniture_named
from trees.beliefs.grounding.grounding import (
    Ambiguous,
    Found,
    Missing,
    choices_among,
    ground,
    ground_furniture,
    says_which,
)
from trees.beliefs.grounding.questions import OTHER, which_is_meant
from trees.beliefs.grounding.report_words import kinds_in
from trees.beliefs.scene.believed_thing import Surroundings
from trees.beliefs.scene.furniture_pieces import are_one_piece
from trees.beliefs.scene.held_object import HeldObject
from trees.beliefs.scene.labels import besides, label_of
from trees.beliefs.scene.scene_update import kind_of
from trees.beliefs.sight.sight_of_tops import ABOVE_M, SightOfTops
from trees.failures import Failure, Reason
from trees.skills.place.on_things import spots_on_thing, thing_called, why_not_on
from trees.skills.place.places_by_people import person_compared_with, spots_by_person
from trees.tasks import WHERE_IT_WAS, Destination, ObjectDescription, Relation
from trees.world_model import FormerPlace

# Where a hand puts things down most easily, from the point between the feet: ahead, and to its own side.
COMFORTABLE_M = (0.48, 0.25)
_DIRECTIONS = {
    "left_of": (0.5 * math.pi,),
    "right_of": (-0.5 * math.pi,),
    "in_front_of": (math.pi,),
    "behind": (0.0,),
    "next_to": (0.5 * math.pi, -0.5 * math.pi, math.pi, 0.0),
}
# What is put back stands this near to where it was; else something else stands there now.
_BACK_WITHIN_M = 0.10
_SAME_PLACE_M = 0.005
# A thing whose hull rests with its own up so near to the vertical stands upright.
_LEANS_COSINE = math.cos(math.radians(20))
SURFACES = ("table", "counter", "shelf", "floor")


def spots_for(
    held: HeldObject,
    on: Destination | None,
    to: Destination | None,
    scene: PlanningScene,
    around: Surroundings,
    odom_T_base: Transform,
    support_gap_m: float,
    sight: SightOfTops,
    origin: FormerPlace | None = None,
) -> tuple[Spot, ...] | Failure:
    """Free spots for a held object, the best first.

    Args:
        held: The object.
        on: The surface that is named, or None.
        to: The other thing that is named: beside what it goes, or another surface; or None.
        scene: What is believed to be around.
        around: The same from where the robot stands.
        odom_T_base: Pose of the robot's base, shape (4, 4).
        support_gap_m: Between an object's lowest point and what it stands on, at most.
        sight: What has been looked at; only there is anything free.
        origin: Where a hand took it from, where that is known.
    """
    if to == WHERE_IT_WAS:
        return _back(held, origin, scene, odom_T_base, sight)
    relation = _relation(to)
    wish = _comfort(held, odom_T_base)
    radius = footprint_radius_m(held.shape)
    if relation is not None:
        found = _beside(relation, held, scene, around, odom_T_base, support_gap_m, wish, sight)
        if isinstance(found, Failure):
            return found
        top, spots = found
    else:
        surface = _put_on(on, to, scene, around, wish, None if origin is None else origin.support)
        if isinstance(surface, Failure):
            return surface
        if surface.movable:
            return _on_thing(held, surface, scene, wish, sight)
        known = sight.about(surface, radius, odom_T_base)
        top, spots = surface, spots_on(surface, scene, radius, wish, known)
    if not spots:
        where = f"on the {kind_of(top.name)}" if relation is None else str(relation)
        return _no_spot(where, held)
    return tuple(_resting(held, spot, top, scene) for spot in spots)


def _on_thing(
    held: HeldObject,
    thing: SceneObject,
    scene: PlanningScene,
    wish: Callable[[Array], float],
    sight: SightOfTops,
) -> tuple[Spot, ...] | Failure:
    """Spots on another thing, the middle of its top first."""

    def shown(place: Array) -> bool:
        return sight.shows(place + np.array([0.0, 0.0, ABOVE_M]))

    spots = spots_on_thing(thing, held.shape, scene, wish, shown)
    if isinstance(spots, Failure):
        return spots
    resting = tuple(_resting(held, spot, thing, scene) for spot in spots)
    return resting or _no_spot(f"on the {kind_of(thing.name)}", held)


def _no_spot(where: str, held: HeldObject) -> Failure:
    return Failure.infeasible(f"there is no spot {where} for the {held.name} that is free as far as was seen")


def why_not_there(
    on: Destination | None,
    to: Destination | None,
    scene: PlanningScene,
    around: Surroundings,
    support_gap_m: float,
    leaves: str | None = None,
    thing: Shape | None = None,
) -> Failure | None:
    """Why nobody could say where a thing goes, found out before it is picked up; None when it is known.

    Args:
        on: As for ``spots_for``.
        to: As for ``spots_for``.
        scene: What is believed to be around.
        around: The same from where the robot stands, without what is going to be moved.
        support_gap_m: As for ``spots_for``.
        leaves: What it stands on, where that is known.
        thing: Its solid, where that is known.
    """
    relation = _relation(to)
    if relation is not None:
        person = person_compared_with(relation.to, scene, around)
        known: object = person or _compared_with(relation, scene, around, support_gap_m)
    else:
        known = _put_on(on, to, scene, around, lambda _place: 0.0, leaves)
        if isinstance(known, SceneObject) and known.movable:
            return why_not_on(known, thing)
    return known if isinstance(known, Failure) else None


def _relation(to: Destination | None) -> Relation | None:
    """What a destination says about where beside something else it is."""
    if isinstance(to, ObjectDescription):
        if to.relation is not None and to.relation.kind in _DIRECTIONS and to.kind is None:
            return to.relation
        if to.kind is not None and kind_called(to.kind) not in SURFACES:
            return Relation("next_to", to)
    return None


def _put_on(
    on: Destination | None,
    to: Destination | None,
    scene: PlanningScene,
    around: Surroundings,
    wish: Callable[[Array], float],
    leaves: str | None,
) -> SceneObject | Failure:
    """The surface that is named, or a thing; of several surfaces that are not, the one that is wished for."""
    named, slot = (on, "on") if on is not None else (to, "to")
    thing = None if on is None else thing_called(on, scene, around)
    if thing is not None:
        return thing
    if isinstance(named, ObjectDescription) and (named.name is not None or says_which(named)):
        return _one_surface(named, slot, scene, around, leaves)
    if named is None:
        return _surface(named, scene, wish)
    tops = _tops_called(named, scene)
    doubt = _doubt(tops, named, scene, leaves)
    if doubt is None:
        return _surface(named, scene, wish)
    names = {top.name for top in tops}
    among = choices_among([thing for thing in around.things if thing.name in names])
    return which_is_meant(Ambiguous(f"which {named}? {doubt}", among), slot)


def _doubt(
    tops: list[SceneObject], named: Destination, scene: PlanningScene, leaves: str | None
) -> str | None:
    """Why it has to be asked which one is meant, if it has.

    Of several; of a red one, for colours of furniture are not seen; and whether "the table" is the side table
    that the thing stands on: one that nobody has seen may be meant.
    """
    if len(tops) > 1:
        return f"there are {len(tops)}"
    if tops and isinstance(named, ObjectDescription) and (named.color or named.material):
        look = named.color or f"made of {named.material}"
        return f"that it is {look} is not seen of furniture"
    if not tops or leaves is None or leaves not in scene.objects:
        return None
    if not are_one_piece(tops[0], scene.objects[leaves]):
        return None
    words = kind_of(tops[0].name)
    very = {words, *besides(label_of(tops[0]))}
    return f"it stands on the {words} already" if very.isdisjoint(_kinds(named, scene)) else None


def _tops_called(named: Destination, scene: PlanningScene) -> list[SceneObject]:
    """The largest flat solid of each piece of furniture that is called so."""
    tops: list[SceneObject] = []
    for item in (item for kind in _kinds(named, scene) for item in furniture_named(kind, scene)):
        if is_flat(item) and not any(are_one_piece(item, top) for top in tops):
            tops.append(item)
    return tops


def _surface(
    named: Destination | None, scene: PlanningScene, wish: Callable[[Array], float]
) -> SceneObject | Failure:
    kinds = _kinds(named, scene)
    tops = [item for kind in kinds for item in furniture_named(kind, scene)[:1] if is_flat(item)]
    if not tops:
        there = any(furniture_named(kind, scene) for kind in kinds)
        top = "no flat top of the" if there else "no"
        what = f"{top} {named}" if named is not None else "nothing to put it on"
        return Failure.postcondition(f"{what} seen", seen=kinds_in(scene.objects)).because(Reason.NOT_SEEN)
    return min(tops, key=lambda item: (wish(item.world_T_object[:3, 3]), item.name))


def _one_surface(
    named: ObjectDescription, slot: str, scene: PlanningScene, around: Surroundings, leaves: str | None
) -> SceneObject | Failure:
    """The table or board that is meant by an order, a place or its name."""
    match ground_furniture(named, around, leaves):
        case Ambiguous() as unclear:
            return which_is_meant(unclear, slot)
        case Missing(message):
            return Failure.postcondition(message, seen=kinds_in(scene.objects)).because(Reason.NOT_SEEN)
        case Found(names):
            return scene.objects[names[0]]


def _kinds(named: Destination | None, scene: PlanningScene) -> list[str]:
    if isinstance(named, str):
        return [named]
    if isinstance(named, ObjectDescription) and named.kind is not None:
        return [named.kind]
    fixed = {kind_of(item.name) for item in scene.objects.values() if not item.movable}
    return sorted(kind for kind in fixed if kind_called(kind) in SURFACES)


def is_surface(item: SceneObject) -> bool:
    """Whether it belongs to furniture that things are put on, not into."""
    return kind_called(kind_of(item.name)) in SURFACES


def is_flat(item: SceneObject) -> bool:
    """Whether it is much wider than high, as a top is: a leg is not."""
    return isinstance(item.shape, Box) and min(item.shape.size_m[:2]) > 2.0 * item.shape.height_m


def _beside(
    relation: Relation,
    held: HeldObject,
    scene: PlanningScene,
    around: Surroundings,
    odom_T_base: Transform,
    support_gap_m: float,
    wish: Callable[[Array], float],
    sight: SightOfTops,
) -> tuple[SceneObject, list[FreeSpot]] | Failure:
    around = replace(around, last_acted_on=held.name)  # "the other one" is not the held one
    person = person_compared_with(relation.to, scene, around)
    if isinstance(person, SceneObject):
        tops = [item for item in scene.objects.values() if is_surface(item) and is_flat(item)]
        angles = _DIRECTIONS[relation.kind]
        by = spots_by_person(person, tops, angles, held.shape, scene, odom_T_base, wish, sight)
        return by or _no_spot(str(relation), held)
    found = person or _compared_with(relation, scene, around, support_gap_m)
    if isinstance(found, Failure):
        return found
    other, top = found
    heading = poses.yaw_of(odom_T_base[:3, :3])
    directions = [heading + angle for angle in _DIRECTIONS[relation.kind]]
    radius = footprint_radius_m(held.shape)
    known = sight.about(top, radius, odom_T_base)
    return top, spots_beside(other, top, scene, radius, directions, wish, known)


def _back(
    held: HeldObject,
    origin: FormerPlace | None,
    scene: PlanningScene,
    odom_T_base: Transform,
    sight: SightOfTops,
) -> tuple[Spot, ...] | Failure:
    """Spots about the place that it was taken from, the nearest first."""
    if origin is None:
        return not_taken(held.name)
    top = scene.objects.get(origin.support)
    if top is None:
        return Failure.postcondition(f"the {origin.support} that it stood on is not seen")
    if not is_surface(top):
        return Failure.infeasible(
            f"the {held.name} was in the {kind_of(top.name)}: say what it is to be put into"
        )
    before = origin.odom_T_object[:3, 3]
    radius = footprint_radius_m(held.shape)
    seen = sight.about(top, radius, odom_T_base)

    def away_m(place: Array) -> float:
        return float(np.linalg.norm(place[:2] - before[:2]))

    def known(place: Array) -> bool:
        """What stands about the very place does not bar a hand, which took it from there."""
        return away_m(place) <= _SAME_PLACE_M or seen(place)

    there = (before - top.world_T_object[:3, 3]) @ top.world_T_object[:3, :3]
    spots = spots_on(top, scene, radius, away_m, known, at=(there[:2],))
    near = [spot for spot in spots if away_m(spot.place_m) <= _BACK_WITHIN_M]
    if not near:
        return Failure.infeasible(f"there is no room where the {held.name} was, as far as was seen")
    return tuple(_resting(held, spot, top, scene) for spot in near)


def not_taken(thing: object) -> Failure:
    """Why something cannot be put back."""
    return Failure.infeasible(f"where the {thing} was is not known: no hand has taken it from anywhere")


def _compared_with(
    relation: Relation, scene: PlanningScene, around: Surroundings, support_gap_m: float
) -> tuple[SceneObject, SceneObject] | Failure:
    """What something goes beside, and what that stands on."""
    other = _other(relation.to, scene, around)
    if isinstance(other, Failure):
        return other
    top = support_of(other, scene, support_gap_m)
    if top is None:
        return Failure.postcondition(f"what the {other.name} stands on is not seen")
    return other, top


def _other(to: Destination, scene: PlanningScene, around: Surroundings) -> SceneObject | Failure:
    """The object that a relation compares with."""
    if isinstance(to, str):
        to = ObjectDescription(kind=to)
    if not isinstance(to, ObjectDescription):
        raise TypeError("the object of an earlier task was not filled in")
    answer = ground(to, around)
    if isinstance(answer, Found):
        return scene.objects[answer.names[0]]
    if isinstance(answer, Ambiguous):
        return which_is_meant(answer, OTHER)
    return Failure.postcondition(answer.message)


def _comfort(held: HeldObject, odom_T_base: Transform) -> Callable[[Array], float]:
    """Distance from where this hand puts things down most easily, m."""
    ahead, aside = COMFORTABLE_M
    side = aside if held.hand == "left" else -aside
    turn = poses.rotation_z(poses.yaw_of(odom_T_base[:3, :3]))
    best = odom_T_base[:2, 3] + (turn @ (ahead, side, 0.0))[:2]

    def wish(place: Array) -> float:
        return float(np.linalg.norm(place[:2] - best))

    return wish


def _resting(held: HeldObject, spot: FreeSpot, top: SceneObject, scene: PlanningScene) -> Spot:
    """The pose of an object that stands upright on a spot; of any shape, as its hull rests there."""
    turn, height_m = how_it_stands(held.shape)
    below = [name for name in furniture_right_below(spot.place_m, scene) if name != top.name]
    return Spot(poses.transform(turn, spot.place_m + np.array([0.0, 0.0, height_m])), (top.name, *below))


def how_it_stands(shape: Shape) -> tuple[Array, float]:
    """How a thing is turned when it stands, shape (3, 3), and how high its middle is then."""
    parts = shape.parts
    if parts is None or not len(parts.rests):
        return np.eye(3), 0.5 * shape.height_m
    up = parts.rests[int(np.argmax(parts.rests[:, 2]))]
    if up[2] < _LEANS_COSINE:
        return np.eye(3), 0.5 * shape.height_m
    return upright((float(up[0]), float(up[1]), float(up[2]))), -float((parts.corners @ up).min())
