"""The window through which a simulated sensor looks at a world that it is allowed to know.

Implemented by the simulator and by the scripted scene of the fake robot. Only the perception stub,
the evaluation and tests may hold one.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Sealed
from kinematics.geometry.poses import Transform
from kinematics.geometry.shapes import Shape
from kinematics.scene.known_part import KnownPart
from robots.perception.detector import Category
from robots.scenes.furniture_names import own_name


@dataclass(frozen=True, slots=True)
class TrueObject(Sealed):
    """One solid of the world as it really is; a piece of furniture may be several solids.

    Attributes:
        name: Unique: an object's or a person's name, or "table/top" for a solid of furniture.
        category, kind, color: As in ``Detection``.
        shape: Its solid.
        world_T_object: Its pose, shape (4, 4).
        names, categories, traits: As in ``Detection``.
        moves: The same, with the pose in the world.
    """

    name: str
    category: Category
    kind: str
    color: str | None
    shape: Shape
    world_T_object: Transform
    names: tuple[str, ...] = ()
    categories: tuple[str, ...] = ()
    traits: tuple[str, ...] = ()
    moves: KnownPart | None = None

    @property
    def told_name(self) -> str | None:
        """The name that a detector tells: of people, and of furniture that has one of its own."""
        if self.category == "person":
            return self.name
        return own_name(self.name.partition("/")[0], self.kind) if self.category == "furniture" else None


class TruthView(Protocol):
    """What a perception stub reads."""

    def solids(self) -> tuple[TrueObject, ...]:
        """Everything that could be seen, in a fixed order."""
        ...

    def world_T_camera(self) -> Transform:
        """Pose of the camera's optical frame, shape (4, 4)."""
        ...

    def visible(self, name: str, points: NDArray[np.float64]) -> NDArray[np.bool_]:
        """Tell for each world point, shape (n, 3), on a solid whether a ray from the camera meets
        that solid before it meets anything else (robot included), shape (n,).
        """
        ...
