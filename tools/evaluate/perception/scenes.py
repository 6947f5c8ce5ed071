"""Random tables to be looked at: those of the picks, tidy and crowded, and some with everything on them."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

from kinematics.geometry import poses
from kinematics.geometry.shapes import Ball, Box, Cylinder, Shape
from robots.scenes.fixed_camera import FixedCamera
from robots.scenes.light import Light, LightKind
from robots.scenes.scene_description import Furniture, SceneDescription, SceneItem
from robots.scenes.scene_words import COLORS
from tools.evaluate.scenes import episode_rng, pick_scene, read_episode_scene

KINDS = ("tabletop", "clutter", "varied")
LIGHTS: tuple[LightKind, ...] = ("bright", "dim", "warm", "side")
GAP_M = (0.02, 0.08)
"""Between things of a varied table."""
_COUNT = (3, 9)
_ROOM_CAMERA_RAD, _ROOM_CAMERA_M, _ROOM_CAMERA_UP_M = (-2.0, 2.0), (0.8, 1.8), (0.6, 1.4)
"""Of a camera in the room: heading from the table, 0 away from the robot; how far away, how high above it."""
_HEAD_TILT_RAD, _HEAD_PAN_RAD, _LEAN_RAD = (0.60, 0.80), (-0.25, 0.25), (0.0, 0.30)


@dataclass(frozen=True, slots=True)
class Look:
    """One picture to take: of what, in which light, from where.

    Attributes:
        scene: With its light.
        kind: One of ``KINDS``.
        tilt_rad, pan_rad, lean_rad: Of head and trunk.
    """

    scene: SceneDescription
    kind: str
    tilt_rad: float
    pan_rad: float
    lean_rad: float


def look(seed: int, light: LightKind | None = None) -> Look:
    """The picture of one seed.

    Args:
        seed: Kind of table, light and view follow from it.
        light: Another light than the seed's.
    """
    rng = episode_rng(seed, 41)
    kind = KINDS[int(rng.integers(len(KINDS)))]
    drawn = LIGHTS[int(rng.integers(3))]  # light from the side is asked for
    scene = read_episode_scene(pick_scene(seed, crowded=kind == "clutter"), seed)
    if kind == "varied":
        table = scene.furniture[0]
        scene = replace(scene, objects=tuple(_varied(rng, table)))
    scene = replace(scene, light=Light(drawn if light is None else light))
    tilt, pan, lean = (float(rng.uniform(*span)) for span in (_HEAD_TILT_RAD, _HEAD_PAN_RAD, _LEAN_RAD))
    return Look(scene, kind, tilt, pan, lean)


def watched(what: Look, seed: int) -> Look:
    """The same look, in a room with a camera somewhere beyond or beside the table, which looks at it."""
    rng = episode_rng(seed, 42)
    table = what.scene.furniture[0]
    middle = np.array([*table.position_m, table.size_m[2]])
    heading, away = rng.uniform(*_ROOM_CAMERA_RAD), rng.uniform(*_ROOM_CAMERA_M)
    up = rng.uniform(*_ROOM_CAMERA_UP_M)
    place = middle + np.array([away * math.cos(heading), away * math.sin(heading), up])
    aim = middle + np.array([*rng.uniform(-0.1, 0.1, 2), 0.0])
    (x, y, z), (to_x, to_y, to_z) = place.tolist(), aim.tolist()
    camera = FixedCamera("room camera", (x, y, z), (to_x, to_y, to_z))
    return replace(what, scene=replace(what.scene, cameras=(camera,)))


def _varied(rng: np.random.Generator, table: Furniture) -> list[SceneItem]:
    placed: list[SceneItem] = []
    half = 0.5 * np.array(table.size_m[:2]) - 0.08
    for number in range(int(rng.integers(_COUNT[0], _COUNT[1] + 1))):
        kind, shape, wall_m = _thing(rng)
        color = list(COLORS)[int(rng.integers(len(COLORS)))]
        yaw, gap = float(rng.uniform(-math.pi, math.pi)), float(rng.uniform(*GAP_M))
        for _ in range(40):
            x, y = np.array(table.position_m) + rng.uniform(-half, half)
            # most of a table's depth is out of the robot's reach: what it looks at is nearer
            pose = poses.transform(
                poses.rotation_z(yaw), (float(x), float(y), table.size_m[2] + 0.5 * shape.height_m)
            )
            item = SceneItem(f"{color} {kind} {number + 1}", kind, color, shape, 0.2, 0.6, pose, wall_m)
            if all(_apart(item, other) > gap for other in placed):
                placed.append(item)
                break
    return placed


def _thing(rng: np.random.Generator) -> tuple[str, Shape, float | None]:
    kind = ("box", "box", "bottle", "can", "cup", "ball", "bowl")[int(rng.integers(7))]

    def between(low: float, high: float) -> float:
        return float(rng.uniform(low, high))

    match kind:
        case "box":
            return kind, Box((between(0.03, 0.10), between(0.03, 0.10), between(0.04, 0.16))), None
        case "ball":
            return kind, Ball(between(0.025, 0.05)), None
        case "bowl":
            return kind, Cylinder(between(0.06, 0.09), between(0.045, 0.07)), 0.006
        case "bottle":
            return kind, Cylinder(between(0.025, 0.04), between(0.16, 0.22)), None
        case "can":
            return kind, Cylinder(between(0.028, 0.04), between(0.09, 0.13)), None
        case _:
            return kind, Cylinder(between(0.020, 0.040), between(0.08, 0.16)), None


def _apart(a: SceneItem, b: SceneItem) -> float:
    between = a.world_T_object[:2, 3] - b.world_T_object[:2, 3]
    return float(np.linalg.norm(between)) - _reach_m(a) - _reach_m(b)


def _reach_m(item: SceneItem) -> float:
    shape = item.shape
    return 0.5 * math.hypot(*shape.size_m[:2]) if isinstance(shape, Box) else shape.radius_m
