"""Picks for a standing robot: something on a table or a low shelf, amid other things."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from kinematics.geometry import poses
from kinematics.geometry.shapes import Box, Cylinder
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import stance_at
from kinematics.requests.pick import PickRequest
from kinematics.scene.planning_scene import PlanningScene, SceneObject

TARGET = "cup"
# Distance kept from everything: what perception's error asks for.
MARGIN_M = 0.01
# Things stand this far apart, measured from middle to middle.
APART_M = 0.11


def picks(model: RobotModel, count: int, seed: int) -> Iterator[PickRequest]:
    """Draw picks amid 3 to 12 things on a table; the same arguments give the same picks."""
    stance = stance_at(model, model.q_home)
    for number in range(count):
        rng = np.random.default_rng([seed, number])
        yield PickRequest(model.q_home, stance, _clutter(rng), TARGET, seed=number)


def _clutter(rng: np.random.Generator) -> PlanningScene:
    top, near = float(rng.uniform(0.75, 0.95)), float(rng.uniform(0.40, 0.50))
    place = poses.translation(near + 0.35, 0.0, top - 0.02)
    objects = [SceneObject("table", Box((0.7, 1.4, 0.04)), place, MARGIN_M, movable=False)]
    spots: list[tuple[float, float]] = []
    for number in range(1 + int(rng.integers(3, 13))):
        while True:
            x, y = rng.uniform((near + 0.08, -0.5), (near + 0.45, 0.5)).tolist()
            if all(np.hypot(x - a, y - b) > APART_M for a, b in spots):
                break
        spots.append((x, y))
        height = float(rng.uniform(0.08, 0.12) if number == 0 else rng.uniform(0.08, 0.24))
        shape = Cylinder(float(rng.uniform(0.025, 0.038)), height)
        name = TARGET if number == 0 else f"thing {number}"
        pose = poses.translation(x, y, top + 0.5 * height)
        objects.append(SceneObject(name, shape, pose, MARGIN_M))
    return PlanningScene().with_objects(objects)
