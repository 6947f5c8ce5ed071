"""The planning scene: what the robot believes is around it, as an immutable value.

A change makes a new scene with a higher version; a plan carries the version that it was made for.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from types import MappingProxyType
from typing import Any, TypeVar

from kinematics.arrays import Sealed
from kinematics.errors import UnknownNameError
from kinematics.geometry import poses
from kinematics.geometry.poses import Transform
from kinematics.geometry.shapes import Box, Shape
from kinematics.scene.known_part import KnownPart
from kinematics.scene.label import Label

Pair = frozenset[str]
"""Two names, of links or of objects, in no order."""

FLOOR = "floor"
"""Name of the solid below z = 0 that every scene has, unless it says itself what its floor is."""

_FLOOR_SIZE_M = (40.0, 40.0, 2.0)


V = TypeVar("V")


def _frozen(mapping: Mapping[str, V]) -> Mapping[str, V]:
    """A private copy that cannot be changed; what is one already stays the same object."""
    return mapping if type(mapping) is MappingProxyType else MappingProxyType(dict(mapping))


@dataclass(frozen=True, slots=True)
class SceneObject(Sealed):
    """A solid in the world.

    Attributes:
        name: Unique in the scene.
        shape: Its solid, centred on its own frame.
        world_T_object: Pose, shape (4, 4).
        margin_m: Distance that every part of the robot keeps from it unless the pair is allowed;
            the perception error that a plan must survive.
        movable: Whether it may be grasped; furniture may not.
        label: What it is called besides; None where its name says it all. No plan depends on it.
        moves: Of what goes with a door or drawer that was recognised by a model of its piece; None else.
    """

    name: str
    shape: Shape
    world_T_object: Transform
    margin_m: float = 0.0
    movable: bool = True
    label: Label | None = None
    moves: KnownPart | None = None


def floor() -> SceneObject:
    """The floor of a scene that names none."""
    place = poses.translation(0.0, 0.0, -0.5 * _FLOOR_SIZE_M[2])
    return SceneObject(FLOOR, Box(_FLOOR_SIZE_M), place, movable=False)


@dataclass(frozen=True, slots=True)
class AttachedBody(Sealed):
    """An object that moves with a link because a hand holds it.

    Attributes:
        body: The object; its pose is the one at the moment of attaching.
        frame: Model frame that carries it.
        frame_T_object: Pose in that frame, shape (4, 4).
        touch_links: Links that may touch it.
        mass_kg: How heavy it was found to be; 0 while nobody has weighed it.
    """

    body: SceneObject
    frame: str
    frame_T_object: Transform
    touch_links: frozenset[str]
    mass_kg: float = 0.0


@dataclass(frozen=True, slots=True)
class PlanningScene:
    """World objects, attached bodies and the pairs that may touch.

    ``allowed`` is the allowed collision matrix: pairs of names (links, objects) that are not
    judged. Which links of the robot may touch each other is its description's to say: a pair of two
    links says nothing here.
    """

    version: int = 0
    objects: Mapping[str, SceneObject] = field(default_factory=lambda: _frozen({}))
    attached: Mapping[str, AttachedBody] = field(default_factory=lambda: _frozen({}))
    allowed: frozenset[Pair] = frozenset()

    def __post_init__(self) -> None:
        object.__setattr__(self, "objects", _frozen(self.objects))
        object.__setattr__(self, "attached", _frozen(self.attached))

    def with_object(self, item: SceneObject) -> PlanningScene:
        """Add an object, or replace the one of the same name."""
        return self._next(objects={**self.objects, item.name: item})

    def with_objects(self, items: Iterable[SceneObject]) -> PlanningScene:
        """Replace all world objects."""
        return self._next(objects={item.name: item for item in items})

    def without_object(self, name: str) -> PlanningScene:
        """Remove a world object.

        Raises:
            UnknownNameError: There is no such object.
        """
        self._require(name, self.objects)
        return self._next(objects={k: v for k, v in self.objects.items() if k != name})

    def with_attached(
        self,
        name: str,
        frame: str,
        frame_T_object: Transform,
        touch_links: Iterable[str],
        mass_kg: float = 0.0,
    ) -> PlanningScene:
        """Move a world object into the hand; its mass is 0 while nobody has weighed it.

        Raises:
            UnknownNameError: There is no such world object.
        """
        self._require(name, self.objects)
        body = AttachedBody(self.objects[name], frame, frame_T_object, frozenset(touch_links), mass_kg)
        rest = {k: v for k, v in self.objects.items() if k != name}
        return self._next(objects=rest, attached={**self.attached, name: body})

    def with_held_mass(self, name: str, mass_kg: float) -> PlanningScene:
        """Say how heavy an attached body was found to be.

        Raises:
            UnknownNameError: Nothing of that name is attached.
        """
        self._require(name, self.attached)
        return self._next(attached={**self.attached, name: replace(self.attached[name], mass_kg=mass_kg)})

    def with_detached(self, name: str, world_T_object: Transform) -> PlanningScene:
        """Put an attached body back into the world at a pose.

        Raises:
            UnknownNameError: Nothing of that name is attached.
        """
        self._require(name, self.attached)
        item = replace(self.attached[name].body, world_T_object=world_T_object)
        rest = {k: v for k, v in self.attached.items() if k != name}
        return self._next(objects={**self.objects, name: item}, attached=rest)

    def allowing(self, pairs: Iterable[tuple[str, str]]) -> PlanningScene:
        """Allow more pairs to touch."""
        return self._next(allowed=self.allowed | {frozenset(pair) for pair in pairs})

    def is_allowed(self, first: str, second: str) -> bool:
        """Tell whether two names may touch."""
        return frozenset((first, second)) in self.allowed

    def _next(
        self,
        objects: Mapping[str, SceneObject] | None = None,
        attached: Mapping[str, AttachedBody] | None = None,
        allowed: frozenset[Pair] | None = None,
    ) -> PlanningScene:
        return PlanningScene(
            version=self.version + 1,
            objects=self.objects if objects is None else _frozen(objects),
            attached=self.attached if attached is None else _frozen(attached),
            allowed=self.allowed if allowed is None else allowed,
        )

    def __reduce__(self) -> tuple[Any, ...]:
        """For worker processes: read-only views of dictionaries cannot be sent as they are."""
        return _scene_from, (self.version, dict(self.objects), dict(self.attached), self.allowed)

    @staticmethod
    def _require(name: str, known: Mapping[str, object]) -> None:
        if name not in known:
            raise UnknownNameError("object", name, list(known))


def _scene_from(
    version: int,
    objects: dict[str, SceneObject],
    attached: dict[str, AttachedBody],
    allowed: frozenset[Pair],
) -> PlanningScene:
    return PlanningScene(version, _frozen(objects), _frozen(attached), allowed)
