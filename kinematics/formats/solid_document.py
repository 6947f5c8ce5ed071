"""Solids and their poses as JSON: what a scene is made of, and what a hand holds of it.

Read strictly: whatever is missing, unknown, not finite or out of all proportion is an error that names
its place.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from kinematics.arrays import Array, Sealed
from kinematics.formats.json_reader import Node
from kinematics.geometry import poses
from kinematics.geometry.convex_parts import ConvexParts
from kinematics.geometry.poses import Transform
from kinematics.geometry.shapes import Ball, Box, Cylinder, Shape
from kinematics.scene.planning_scene import Pair, SceneObject

MAX_ENTRIES = 10_000
"""Held objects, soles and allowed pairs."""
MAX_POSITION = 1e3
MAX_SIZE_M = 1e3
MAX_MASS_KG = 1e3
MAX_PARTS, MAX_CORNERS = 64, 256
_FLAT_M = 1e-6
"""Bounds of plausibility, in m and rad: beyond them sums of squares lose all meaning."""
UNIT_TOLERANCE = 1e-3
"""A quaternion of a pose may miss length 1 by this much; it is normalised."""


@dataclass(frozen=True, slots=True)
class HeldObject(Sealed):
    """An object that a frame of the robot carries during the whole motion.

    Attributes:
        name: Its name; a world object of the same name is the same thing, and leaves the world.
        frame: Frame of the robot that carries it.
        frame_T_object: Pose in that frame, shape (4, 4).
        shape: Its solid, centred on its own frame.
        touch_links: Links that may touch it.
        mass_kg: How heavy it is; 0 where nobody has weighed it.
    """

    name: str
    frame: str
    frame_T_object: Transform
    shape: Shape
    touch_links: frozenset[str] = frozenset()
    mass_kg: float = 0.0


def optional_items(node: Node, key: str) -> list[Node]:
    """Entries of a list that need not be there; raises as ``read_held``."""
    return node.key(key).items(0, MAX_ENTRIES) if node.has(key) else []


def require_unique(root: Node, key: str, names: Sequence[str]) -> None:
    """Refuse a name that is there twice, of which one would vanish; raises as ``read_held``."""
    seen: set[str] = set()
    for name in names:
        if name in seen:
            raise root.key(key).error(f"{name!r} is there twice")
        seen.add(name)


def held_json(item: HeldObject) -> dict[str, object]:
    """What ``read_held`` reads."""
    return {
        "name": item.name,
        "frame": item.frame,
        "shape": _shape_json(item.shape),
        **pose_json(item.frame_T_object),
        "touch_links": sorted(item.touch_links),
        **({"mass_kg": item.mass_kg} if item.mass_kg > 0.0 else {}),
    }


def object_json(item: SceneObject) -> dict[str, object]:
    """What ``read_object`` reads."""
    return {
        "name": item.name,
        "shape": _shape_json(item.shape),
        **pose_json(item.world_T_object),
        "margin_m": item.margin_m,
        **({} if item.movable else {"movable": False}),
    }


def read_held(node: Node) -> HeldObject:
    """A held object.

    Raises:
        TrajectoryDocumentError: It is none; with its place.
    """
    node.only(("name", "frame", "shape", "position_m", "quaternion_xyzw"), ("touch_links", "mass_kg"))
    mass_kg = node.key("mass_kg").number(MAX_MASS_KG) if node.has("mass_kg") else 0.0
    if mass_kg < 0.0:
        raise node.key("mass_kg").error(f"must be 0 or more, not {mass_kg!r}")
    return HeldObject(
        name=node.key("name").text(),
        frame=node.key("frame").text(),
        frame_T_object=_placed(node),
        shape=_shape(node.key("shape")),
        touch_links=frozenset(link.text() for link in optional_items(node, "touch_links")),
        mass_kg=mass_kg,
    )


def read_object(node: Node) -> SceneObject:
    """A solid of the world; raises as ``read_held``."""
    node.only(("name", "shape", "position_m", "quaternion_xyzw"), ("margin_m", "movable"))
    margin_m = node.key("margin_m").number(MAX_SIZE_M) if node.has("margin_m") else 0.0
    if margin_m < 0.0:
        raise node.key("margin_m").error(f"must be 0 or more, not {margin_m!r}")
    movable = not node.has("movable") or node.key("movable").truth()
    return SceneObject(node.key("name").text(), _shape(node.key("shape")), _placed(node), margin_m, movable)


def read_pair(node: Node) -> Pair:
    """Two names that may touch; raises as ``read_held``."""
    first, second = (item.text() for item in node.items(2, 2))
    if first == second:
        raise node.error(f"{first!r} cannot touch itself")
    return frozenset((first, second))


def read_pose(node: Node) -> Transform:
    """A pose, shape (4, 4); raises as ``read_held``."""
    node.only(("position_m", "quaternion_xyzw"))
    return _placed(node)


def _placed(node: Node) -> Transform:
    position: Array = node.key("position_m").numbers(("x", "y", "z"), MAX_POSITION)
    quaternion: Array = node.key("quaternion_xyzw").numbers(("x", "y", "z", "w"), 2.0)
    length = float(np.linalg.norm(quaternion))
    if abs(length - 1.0) > UNIT_TOLERANCE:
        raise node.key("quaternion_xyzw").error(f"must have length 1, not {length:.6g}")
    return poses.transform(poses.rotation_from_quaternion(quaternion), position)


def pose_json(pose: Transform) -> dict[str, object]:
    """What ``read_pose`` reads."""
    quaternion = poses.quaternion_from_rotation(pose[:3, :3])
    return {"position_m": pose[:3, 3].tolist(), "quaternion_xyzw": quaternion.tolist()}


def _shape(node: Node) -> Shape:
    kind = node.key("kind").choice(("box", "cylinder", "ball"))
    parts = _parts(node.key("parts")) if node.has("parts") else None
    if kind == "box":
        node.only(("kind", "size_m"), ("parts",))
        x, y, z = node.key("size_m").numbers(("x", "y", "z"), MAX_SIZE_M, positive=True)
        return Box((float(x), float(y), float(z)), parts)
    if kind == "cylinder":
        node.only(("kind", "radius_m", "height_m"), ("parts",))
        radius_m = node.key("radius_m").number(MAX_SIZE_M, positive=True)
        return Cylinder(radius_m, node.key("height_m").number(MAX_SIZE_M, positive=True), parts)
    node.only(("kind", "radius_m"), ("parts",))
    return Ball(node.key("radius_m").number(MAX_SIZE_M, positive=True), parts)


def _parts(node: Node) -> ConvexParts:
    node.only(("key", "corners_m"))
    hulls = [
        [corner.numbers(("x", "y", "z"), MAX_SIZE_M) for corner in part.items(4, MAX_CORNERS)]
        for part in node.key("corners_m").items(1, MAX_PARTS)
    ]
    for number, hull in enumerate(hulls):
        if np.linalg.svd(np.array(hull) - np.mean(hull, axis=0), compute_uv=False)[2] < _FLAT_M:
            raise node.key("corners_m").error(f"part {number} is flat")
    ends = tuple(np.cumsum([len(hull) for hull in hulls]).tolist())
    return ConvexParts(node.key("key").text(), np.array([row for hull in hulls for row in hull]), ends)


def _shape_json(shape: Shape) -> dict[str, object]:
    parts = {} if shape.parts is None else {"parts": _parts_json(shape.parts)}
    match shape:
        case Box(size_m=size):
            return {"kind": "box", "size_m": list(size), **parts}
        case Cylinder(radius_m=radius, height_m=height):
            return {"kind": "cylinder", "radius_m": radius, "height_m": height, **parts}
        case Ball(radius_m=radius):
            return {"kind": "ball", "radius_m": radius, **parts}


def _parts_json(parts: ConvexParts) -> dict[str, object]:
    return {"key": parts.key, "corners_m": [hull.tolist() for hull in parts.hulls]}
