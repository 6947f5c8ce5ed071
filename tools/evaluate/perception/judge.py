"""One picture, what was found in it, and what is really there."""

from __future__ import annotations

import math
import time
from dataclasses import dataclass, field

import cv2
import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array
from kinematics.geometry import poses
from kinematics.geometry.poses import Transform
from kinematics.geometry.shapes import Box, Shape
from robots.interface.hardware import RobotData
from robots.models.description import load_robot
from robots.perception.rgbd.eyes import LEAST_THERE, Eyes, Seen, Thing
from robots.perception.rgbd.furniture_map import furniture_map
from robots.perception.rgbd.picture import Picture
from robots.perception.surface import surface_points
from robots.scenes.light import LightKind
from robots.scenes.scene_description import SceneDescription, SceneItem
from tools.evaluate.perception.scenes import look
from tools.evaluate.perception.stand import Stand, world_T_odom

VISIBLE = 0.4
"""A thing counts when so much of its outline is in sight."""
_RIGHT_M = 0.015
"""A thing that is told farther off than this is not where it is told to be."""
_SAME_M = 0.06


@dataclass(frozen=True, slots=True)
class ThingRecord:
    """One true thing, or one that was told and is not there.

    Attributes:
        name: In the scene; empty for what is not there.
        visible: Share of its outline that is in sight and in the picture.
        cut: Whether the picture's edge cuts it.
        found: Whether it was told.
        position_m: How far off it is told.
        size_m: How wrong each of its extents is.
        color, told_color, kind, told_kind: True words, and those that were told.
        alike: Kinds that were told to look alike.
        confidence: In [0, 1].
        right: There, of that kind, or of one that is told to look alike, and colour, and near enough.
        features, evidence: What its colour and its confidence were made of.
        score: Of the fit.
    """

    name: str
    visible: float
    cut: bool
    found: bool
    position_m: float = 0.0
    size_m: tuple[float, ...] = ()
    color: str | None = None
    told_color: str | None = None
    kind: str = ""
    told_kind: str = ""
    alike: tuple[str, ...] = ()
    confidence: float = 0.0
    right: bool = False
    features: tuple[float, ...] = ()
    evidence: tuple[float, ...] = ()
    score: float = 0.0


@dataclass(frozen=True, slots=True)
class PictureRecord:
    """What came of one picture.

    Attributes:
        seed, kind, light: Of the scene.
        looked_s: Processor time from picture to detections.
        things: True ones in the picture, and told ones that are not there.
        table_m: How wrong the height of the table is told, and its near edge; NaN when it is not told.
    """

    seed: int
    kind: str
    light: str
    looked_s: float
    things: tuple[ThingRecord, ...]
    table_m: tuple[float, float] = (math.nan, math.nan)
    broken: str = ""


@dataclass(slots=True)
class Bench:
    """Takes and judges pictures of one robot.

    Attributes:
        robot: Its data.
        last: The last picture, and what was found in it, for who draws it.
    """

    robot: RobotData = field(default_factory=lambda: load_robot("talos"))
    last: tuple[Picture, Seen, NDArray[np.int32]] | None = None

    def judge(self, seed: int, light: LightKind | None = None) -> PictureRecord:
        """Take the picture of a seed, look at it, and compare."""
        what = look(seed, light)
        stand = Stand(self.robot, what, seed)
        (picture, ids, world_T_told), owner = stand.taken(), stand.owner
        stand.close()
        eyes = Eyes(furniture_map(what.scene, np.random.default_rng([seed, 77])))
        began = time.process_time()
        seen = eyes.look(picture)
        looked_s = time.process_time() - began
        self.last = picture, seen, ids
        odom_T_world = poses.inverse(world_T_odom(what.scene))
        things = _compared(what.scene, seen, ids, owner, picture, world_T_told, odom_T_world)
        table = _table_error(what.scene, seen, odom_T_world)
        return PictureRecord(seed, what.kind, what.scene.light.kind, looked_s, tuple(things), table)


def _compared(
    scene: SceneDescription,
    seen: Seen,
    ids: NDArray[np.int32],
    owner: dict[int, str],
    picture: Picture,
    world_T_camera: Transform,
    odom_T_world: Transform,
) -> list[ThingRecord]:
    names = [item.name for item in scene.objects]
    number = np.full(int(ids.max()) + 2, -1, dtype=np.int64)
    for geom, name in owner.items():
        if geom < len(number) - 1:
            number[geom] = names.index(name)
    shown = number[ids]  # of each pixel, which object; -1 none (also for id -1: the last entry)
    told = [thing for thing in seen.things if thing.there >= LEAST_THERE]
    taken: dict[int, Thing] = {}
    records = []
    for thing in sorted(told, key=lambda one: -one.pixels):
        which = _whose(thing, scene, odom_T_world, taken)
        if which is None:
            records.append(_false(thing))
        else:
            taken[which] = thing
    for k, item in enumerate(scene.objects):
        visible, cut = _visible(item, picture, world_T_camera, int((shown == k).sum()))
        if visible < 0.02 and k not in taken:
            continue
        records.append(_record(item, visible, cut, taken.get(k), odom_T_world))
    return records


def _whose(
    thing: Thing, scene: SceneDescription, odom_T_world: Transform, taken: dict[int, Thing]
) -> int | None:
    """The nearest true thing that was not told yet, if it is near at all."""
    away = [
        float(np.linalg.norm((odom_T_world @ item.world_T_object[:, 3])[:2] - thing.solid.place_m[:2]))
        for item in scene.objects
    ]
    for k in np.argsort(away):
        if away[k] > _SAME_M:
            return None
        if int(k) not in taken:
            return int(k)
    return None


def _false(thing: Thing) -> ThingRecord:
    return ThingRecord(
        name="",
        visible=0.0,
        cut=False,
        found=True,
        told_color=thing.color,
        told_kind=thing.call.kind,
        confidence=thing.confidence,
        features=thing.color_features,
        evidence=thing.evidence,
        score=thing.solid.score,
    )


def _record(
    item: SceneItem, visible: float, cut: bool, thing: Thing | None, odom_T_world: Transform
) -> ThingRecord:
    if thing is None:
        return ThingRecord(item.name, visible, cut, False, color=item.color, kind=item.kind)
    off = float(np.linalg.norm((odom_T_world @ item.world_T_object[:, 3])[:3] - thing.solid.place_m))
    called = item.kind in (thing.call.kind, *thing.call.alike)
    right = off < _RIGHT_M and thing.color == item.color and called
    true, told = _extents(item.shape), _extents(thing.solid.shape)
    return ThingRecord(
        name=item.name,
        visible=visible,
        cut=cut,
        found=True,
        position_m=off,
        size_m=tuple(abs(a - b) for a, b in zip(true, told, strict=True)),
        color=item.color,
        told_color=thing.color,
        kind=item.kind,
        told_kind=thing.call.kind,
        alike=thing.call.alike,
        confidence=thing.confidence,
        right=right,
        features=thing.color_features,
        evidence=thing.evidence,
        score=thing.solid.score,
    )


def _extents(shape: Shape) -> tuple[float, float, float]:
    """The shorter and the longer extent on the ground, and the height."""
    if isinstance(shape, Box):
        a, b = sorted(shape.size_m[:2])
        return a, b, shape.size_m[2]
    return 2.0 * shape.radius_m, 2.0 * shape.radius_m, shape.height_m


def _visible(item: SceneItem, picture: Picture, world_T_camera: Transform, pixels: int) -> tuple[float, bool]:
    """The share of a thing's outline in sight, and whether the picture's edge cuts it."""
    points, _ = surface_points(item.shape)
    spread = 1.0 / 0.9 if isinstance(item.shape, Box) else 1.0  # samples of a box end before its edges
    corners = _hull_points(item.shape) if not isinstance(item.shape, Box) else points * spread
    world = corners @ item.world_T_object[:3, :3].T + item.world_T_object[:3, 3]
    camera = (world - world_T_camera[:3, 3]) @ world_T_camera[:3, :3]
    if (camera[:, 2] < 0.2).any():
        return 0.0, True
    outline = picture.pixels_of(camera).astype(np.float32)
    rows, columns = picture.depth_m.shape
    cut = bool((outline < 0).any() or (outline[:, 0] > columns - 1).any() or (outline[:, 1] > rows - 1).any())
    area = float(cv2.contourArea(cv2.convexHull(outline)))
    return min(pixels / max(area, 1.0), 1.0), cut


def _hull_points(shape: Shape) -> Array:
    angles = np.arange(32) * (2.0 * np.pi / 32)
    if isinstance(shape, Box):
        raise TypeError("a box has corners")
    ring = shape.radius_m * np.column_stack([np.cos(angles), np.sin(angles)])
    half = 0.5 * shape.height_m
    if hasattr(shape, "height_m") and type(shape).__name__ == "Ball":
        points, _ = surface_points(shape)
        return points
    return np.concatenate([np.column_stack([ring, np.full(32, z)]) for z in (-half, half)])


def _table_error(scene: SceneDescription, seen: Seen, odom_T_world: Transform) -> tuple[float, float]:
    if not seen.furniture:
        return math.nan, math.nan
    table = scene.furniture[0]
    told = seen.furniture[0]
    depth = table.size_m[0]
    world_T_told = poses.inverse(odom_T_world) @ told.odom_T_solid
    height = float(world_T_told[2, 3]) + 0.5 * told.shape.height_m
    told_depth = told.shape.size_m[0] if isinstance(told.shape, Box) else 0.0
    edge = (world_T_told @ np.array([-0.5 * told_depth, 0.0, 0.0, 1.0]))[0]
    return height - table.size_m[2], float(edge) - (table.position_m[0] - 0.5 * depth)
