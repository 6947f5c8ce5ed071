"""Packages to be shown and told from each other, and tables with some of them."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from PIL import Image

from kinematics.geometry import poses
from kinematics.geometry.shapes import Box, Cylinder
from robots.scenes.light import Light, LightKind
from robots.scenes.scene_description import Furniture, SceneDescription, SceneItem
from robots.simulated.camera.standing_view import Gaze
from tools.evaluate.shown.pictures import made_picture

LIGHTS: tuple[LightKind, ...] = ("bright", "dim", "warm")
_NAMES = (
    "tomato soup", "corn flakes", "green tea", "black beans", "oat biscuits", "sea salt",
    "rye crackers", "plum jam", "fish fingers", "cocoa powder", "chick peas", "dog treats",
)  # fmt: skip
NAMES: tuple[str, ...] = _NAMES
_TABLE = Furniture("table", "table", (0.70, 1.20, 0.75), (0.95, 0.0))
_GAP_M = 0.03
_CLOSE_M = 0.62
"""A thing that is shown is put so near to the robot."""


@dataclass(frozen=True, slots=True)
class Package:
    """One thing with a picture on it.

    Attributes:
        name: "tomato soup"; empty for one that nobody has shown.
        shape: A can or a box.
        picture: Its file.
    """

    name: str
    shape: Box | Cylinder
    picture: str


def packages(seed: int, names: Sequence[str], folder: Path) -> list[Package]:
    """Random packages, their pictures in a folder."""
    rng = np.random.default_rng([seed, 1201])
    made = []
    for number, name in enumerate(names):
        file = folder / f"{seed}-{number}.png"
        Image.fromarray(made_picture(seed * 1000 + number)).save(file)
        if rng.random() < 0.5:
            shape: Box | Cylinder = Cylinder(float(rng.uniform(0.030, 0.040)), float(rng.uniform(0.09, 0.13)))
        else:
            a, b, c = rng.uniform((0.045, 0.05, 0.10), (0.07, 0.10, 0.16)).tolist()
            shape = Box((a, b, c))
        made.append(Package(name, shape, str(file)))
    return made


def shown_scene(package: Package, turn_rad: float, light: LightKind = "bright") -> SceneDescription:
    """One package before the robot, turned."""
    return _scene([_item(package, 0, (_CLOSE_M + 0.10, 0.0), turn_rad)], light)


def table_scene(seed: int, known: Sequence[Package], strangers: Sequence[Package]) -> SceneDescription:
    """A table with five of the known packages, and one that nobody has shown."""
    rng = np.random.default_rng([seed, 1202])
    chosen = [known[int(i)] for i in rng.permutation(len(known))[:5]]
    chosen.append(strangers[int(rng.integers(len(strangers)))])
    items: list[SceneItem] = []
    for number, package in enumerate(chosen):
        for _ in range(200):
            place = float(rng.uniform(0.68, 1.0)), float(rng.uniform(-0.35, 0.35))
            apart = [
                math.dist(place, one.world_T_object[:2, 3]) - _round_m(one) - _reach_m(package.shape)
                for one in items
            ]
            if all(gap > _GAP_M for gap in apart):
                items.append(_item(package, number, place, float(rng.uniform(-math.pi, math.pi))))
                break
    return _scene(items, LIGHTS[int(rng.integers(len(LIGHTS)))])


def gaze(seed: int) -> Gaze:
    """Where the robot looks in the scene of a seed."""
    rng = np.random.default_rng([seed, 1203])
    low, high = (0.62, -0.10, 0.05), (0.78, 0.10, 0.25)
    return Gaze(*(float(value) for value in rng.uniform(low, high)))


def _item(package: Package, number: int, place: tuple[float, float], yaw_rad: float) -> SceneItem:
    height = _TABLE.size_m[2] + 0.5 * package.shape.height_m
    kind = "can" if isinstance(package.shape, Cylinder) else "box"
    return SceneItem(
        name=package.name or f"stranger {number}",
        kind=kind,
        color="white",
        shape=package.shape,
        mass_kg=0.2,
        friction=0.8,
        world_T_object=poses.transform(poses.rotation_z(yaw_rad), (*place, height)),
        texture=package.picture,
    )


def _scene(items: Sequence[SceneItem], light: LightKind) -> SceneDescription:
    scene = SceneDescription("shown", furniture=(_TABLE,), objects=tuple(items), light=Light(light))
    return replace(scene, perception=replace(scene.perception, kind="rgbd"))


def _reach_m(shape: Box | Cylinder) -> float:
    return shape.radius_m if isinstance(shape, Cylinder) else 0.5 * math.hypot(*shape.size_m[:2])


def _round_m(item: SceneItem) -> float:
    assert isinstance(item.shape, Box | Cylinder)
    return _reach_m(item.shape)
