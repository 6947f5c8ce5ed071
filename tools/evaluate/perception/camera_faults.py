"""Faults of the camera in an episode, by name: what the picture, its time or its place has wrong."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import replace
from types import MappingProxyType

import numpy as np

from kinematics.geometry import poses
from kinematics.geometry.shapes import Box, Shape
from robots.scenes.light import LIGHT_KINDS, Light, LightChange
from robots.scenes.scene_description import SceneDescription, SceneItem
from robots.simulated.camera.feed import CameraFaults
from robots.simulated.camera.orders import LensFaults

MISCALIBRATED_RAD = math.radians(2.0)
_CHANGES_S = (0.5, 3.0)
_EPISODE_S = 60.0
_GAP_M, _HIGHER_M = (0.03, 0.05), (-0.01, 0.03)
"""Between the thing and what stands before it, as amid clutter, where hands come in from other sides; and by
how much that is higher."""

Wrong = Callable[[CameraFaults, np.random.Generator], None]


def _lens(**spans: tuple[float, float]) -> Wrong:
    def act(faults: CameraFaults, rng: np.random.Generator) -> None:
        drawn = {name: float(rng.uniform(*span)) for name, span in spans.items()}
        faults.lens = LensFaults(**drawn)  # type: ignore[arg-type]  # numbers, by name

    return act


def _frozen(faults: CameraFaults, _rng: np.random.Generator) -> None:
    faults.frozen = True


def _stale(faults: CameraFaults, rng: np.random.Generator) -> None:
    faults.late_s = float(rng.uniform(0.5, 1.5))


def _miscalibrated(faults: CameraFaults, rng: np.random.Generator) -> None:
    heading = float(rng.uniform(-math.pi, math.pi))
    turn = MISCALIBRATED_RAD * math.cos(heading), MISCALIBRATED_RAD * math.sin(heading)
    faults.lens = LensFaults(turn_rad=turn)


def _nothing(_faults: CameraFaults, _rng: np.random.Generator) -> None:
    """The scene itself is the fault."""


CAMERA_FAULTS: Mapping[str, Wrong] = MappingProxyType(
    {
        "dark": _lens(light=(0.001, 0.006)),
        "glare": _lens(glare=(0.3, 0.9)),
        "light_changes": _nothing,
        "occluded": _nothing,
        "lens_dirty": _lens(stain=(0.05, 0.25)),
        "depth_missing": _lens(no_depth=(0.2, 0.6)),
        "stale": _stale,
        "frozen": _frozen,
        "miscalibrated": _miscalibrated,
        "flicker": _lens(flicker=(0.3, 0.7)),
    }
)
"""Of ``evaluate pick``: each makes the robot see with its camera."""


def with_camera_fault(
    scene: SceneDescription, fault: str | None, target: str, rng: np.random.Generator
) -> SceneDescription:
    """The scene of an episode with a fault of the camera that is one of the scene."""
    if fault == "light_changes":
        now_s, changes = 0.0, []
        while now_s < _EPISODE_S:
            now_s += float(rng.uniform(*_CHANGES_S))
            changes.append(LightChange(now_s, LIGHT_KINDS[int(rng.integers(len(LIGHT_KINDS)))]))
        return replace(scene, light=Light("bright", tuple(changes)))
    if fault == "occluded":
        return _occluded(scene, target, rng)
    return scene


def _occluded(scene: SceneDescription, target: str, rng: np.random.Generator) -> SceneDescription:
    """Something stands before the thing, as the robot sees it from where it begins."""
    thing = next(item for item in scene.objects if item.name == target)
    x, y, z = thing.world_T_object[:3, 3].tolist()
    start = scene.robot_start
    away = math.hypot(x - start.x_m, y - start.y_m)
    size = (0.04, float(rng.uniform(0.05, 0.08)), thing.shape.height_m + float(rng.uniform(*_HIGHER_M)))
    before_m = float(rng.uniform(*_GAP_M)) + 0.5 * size[0] + _reach_m(thing.shape)
    heading = math.atan2(y - start.y_m, x - start.x_m)
    share = (away - before_m) / away
    top = z - 0.5 * thing.shape.height_m
    place = (start.x_m + share * (x - start.x_m), start.y_m + share * (y - start.y_m), top + 0.5 * size[2])
    blind = SceneItem(
        "grey box", "box", "grey", Box(size), 0.4, 0.6, poses.transform(poses.rotation_z(heading), place)
    )
    others = tuple(item for item in scene.objects if _far(item, place))
    table = scene.furniture[0]
    edge = table.position_m[0] - 0.5 * table.size_m[0] + 0.5 * size[0] + 0.01
    if place[0] < edge:  # it would stand over the edge of the table
        return scene
    return replace(scene, objects=(*others, blind))


def _reach_m(shape: Shape) -> float:
    return 0.5 * math.hypot(*shape.size_m[:2]) if isinstance(shape, Box) else shape.radius_m


def _far(item: SceneItem, place: tuple[float, float, float]) -> bool:
    if item.name == "red cup":
        return True
    return math.dist(item.world_T_object[:2, 3].tolist(), place[:2]) > 0.11
