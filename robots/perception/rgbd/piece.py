"""A solid of a piece of furniture, as it is told."""

from __future__ import annotations

from dataclasses import dataclass

from kinematics.arrays import InFloat64
from kinematics.geometry import poses
from kinematics.geometry.poses import Transform
from kinematics.geometry.shapes import Shape
from robots.scenes import furniture
from robots.scenes.furniture_names import own_name
from robots.scenes.scene_description import Furniture


@dataclass(frozen=True, slots=True)
class Piece(InFloat64):
    """One solid of a piece of furniture that is seen.

    Attributes:
        kind: "table".
        name: Of its own, or None.
        shape, odom_T_solid: Its solid, and where it is.
        confidence: In [0, 1].
        assumed: What of it was not seen and is taken from the map, or from nothing: "edges".
        names, categories: What the map says that it is called besides, and belongs to.
    """

    kind: str
    name: str | None
    shape: Shape
    odom_T_solid: Transform
    confidence: float
    assumed: frozenset[str] = frozenset()
    names: tuple[str, ...] = ()
    categories: tuple[str, ...] = ()


def pieces_of(
    item: Furniture, confidence: float, assumed: frozenset[str] = frozenset(), raised_m: float = 0.0
) -> list[Piece]:
    """The solids of a piece of the map, where that has it.

    Args:
        item: The piece, in the odometry frame.
        confidence, assumed: As of each solid.
        raised_m: How much higher they are seen.
    """
    told, up = own_name(item.name, item.kind), poses.translation(0.0, 0.0, raised_m)
    return [
        Piece(
            kind=item.kind,
            name=told,
            shape=solid.shape,
            odom_T_solid=up @ solid.world_T_solid,
            confidence=confidence,
            assumed=assumed,
            names=item.names,
            categories=item.categories,
        )
        for solid in furniture.solids(item)
    ]
