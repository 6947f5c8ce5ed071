"""Things as the robot believes them to be, seen from where it stands."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field, replace

import numpy as np

from kinematics.arrays import Array, Sealed
from kinematics.geometry import poses
from kinematics.geometry.poses import Transform
from kinematics.geometry.shapes import Box, Cylinder, Shape
from kinematics.scene.label import Label
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from kinematics.scene.support_of import half_height_m, support_of
from trees.beliefs.scene.labels import label_in, label_of, words_besides

PERSON = "person"


@dataclass(frozen=True, slots=True)
class BelievedThing(Sealed):
    """One thing of the world model.

    Attributes:
        name: Its name in the planning scene: "red cup 2".
        label: What it is called.
        shape: Its solid.
        place_m: Of its centre, from the point on the floor below the base: x ahead, y to the left, z up,
            shape (3,).
        half_height_m: Half its vertical extent, as it stands or lies.
        movable: Whether it is an object that could be picked up; furniture and people are not.
        support: Name of the furniture it stands on, or None when none is known.
    """

    name: str
    label: Label
    shape: Shape
    place_m: Array
    half_height_m: float
    movable: bool
    support: str | None

    @property
    def kind(self) -> str:
        """Its kind: "cup"."""
        return self.label.kind

    @property
    def color(self) -> str | None:
        """Its colour, or None when it could not be told."""
        return self.label.color

    @property
    def is_person(self) -> bool:
        """People are known by their names, which begin with a capital, or as "person"."""
        return not self.movable and (self.kind == PERSON or self.name[:1].isupper())

    @property
    def words(self) -> str:
        """Its name, or colour, if known, and kind."""
        return self.label.words

    @property
    def top_m(self) -> float:
        """Height of its highest point."""
        return float(self.place_m[2]) + self.half_height_m

    @property
    def bottom_m(self) -> float:
        """Height of its lowest point."""
        return float(self.place_m[2]) - self.half_height_m

    @property
    def distance_m(self) -> float:
        """From the robot, along the floor."""
        return float(math.hypot(self.place_m[0], self.place_m[1]))

    @property
    def radius_m(self) -> float:
        """Of the upright cylinder around it, when it stands."""
        if isinstance(self.shape, Box):
            return 0.5 * math.hypot(self.shape.size_m[0], self.shape.size_m[1])
        return self.shape.radius_m

    @property
    def volume_m3(self) -> float:
        """Of its solid."""
        if isinstance(self.shape, Box):
            return math.prod(self.shape.size_m)
        if isinstance(self.shape, Cylinder):
            return math.pi * self.shape.radius_m**2 * self.shape.height_m
        return 4.0 / 3.0 * math.pi * self.shape.radius_m**3


@dataclass(frozen=True, slots=True)
class Surroundings(Sealed):
    """What the robot believes to be around it.

    Attributes:
        things: Objects and furniture, in the order of their names.
        held: What is in its hands, by name, and what that is called.
        last_acted_on: Name of the object that the task before was about, or None.
        here_T_asked: Where the robot stood when it was asked, from where it stands, shape (4, 4).
        sent_to: Name of the furniture that it was told to walk to, and has; "the cup" is the one there.
    """

    things: tuple[BelievedThing, ...]
    held: Mapping[str, Label] = field(default_factory=dict)
    last_acted_on: str | None = None
    here_T_asked: Transform = field(default_factory=lambda: np.eye(4))
    sent_to: str | None = None

    @property
    def objects(self) -> tuple[BelievedThing, ...]:
        """What could be picked up."""
        return tuple(thing for thing in self.things if thing.movable)

    @property
    def furniture_words(self) -> Mapping[str, frozenset[str]]:
        """What the furniture is called, without numbers, and what each may be called besides."""
        fixed = (thing for thing in self.things if not thing.movable and not thing.is_person)
        return words_besides((thing.kind, thing.label) for thing in fixed)

    def label(self, name: str) -> Label:
        """What something of that name is called; by its name alone where it is not known any more."""
        known = {thing.name: thing.label for thing in self.things}
        return self.held.get(name) or known.get(name) or label_in(name)

    def only(self, names: tuple[str, ...]) -> Surroundings:
        """The same with no other objects than those named."""
        kept = tuple(thing for thing in self.things if not thing.movable or thing.name in names)
        return replace(self, things=kept)

    def without(self, names: tuple[str, ...]) -> Surroundings:
        """The same without some things."""
        kept = tuple(thing for thing in self.things if thing.name not in names)
        return replace(self, things=kept)


def surroundings(
    scene: PlanningScene,
    odom_T_base: Transform,
    support_gap_m: float,
    last_acted_on: str | None = None,
    asked_at: Transform | None = None,
    sent_to: str | None = None,
) -> Surroundings:
    """Look at a planning scene from where the robot stands.

    Args:
        scene: What is believed; in the odometry frame.
        odom_T_base: Pose of the robot's base, shape (4, 4); only place and heading count.
        support_gap_m: Between an object's lowest point and what it stands on, at most.
        last_acted_on: Name of the object that the task before was about.
        asked_at: Pose of the base when the robot was asked, shape (4, 4); None is the same place.
        sent_to: As for ``Surroundings``.
    """
    floor_place = (float(odom_T_base[0, 3]), float(odom_T_base[1, 3]), 0.0)
    standing = poses.transform(poses.rotation_z(poses.yaw_of(odom_T_base[:3, :3])), floor_place)
    base_T_odom = poses.inverse(standing)
    things = [_thing(item, scene, base_T_odom, support_gap_m) for _, item in sorted(scene.objects.items())]
    asked = base_T_odom @ (odom_T_base if asked_at is None else asked_at)
    held = {name: label_of(body.body) for name, body in sorted(scene.attached.items())}
    return Surroundings(tuple(things), held, last_acted_on, asked, sent_to)


def _thing(item: SceneObject, scene: PlanningScene, base_T_odom: Transform, gap_m: float) -> BelievedThing:
    support = support_of(item, scene, gap_m) if item.movable else None
    return BelievedThing(
        name=item.name,
        label=label_of(item),
        shape=item.shape,
        place_m=(base_T_odom @ item.world_T_object)[:3, 3],
        half_height_m=half_height_m(item),
        movable=item.movable,
        support=None if support is None else support.name,
    )
