"""A motion problem: solids, a start and a goal, as plain values."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from kinematics.arrays import Array
from kinematics.geometry import poses
from kinematics.geometry.shapes import Ball, Box, Cylinder, Shape
from kinematics.scene.planning_scene import SceneObject


@dataclass(frozen=True, slots=True)
class Problem:
    """Bring an arm from one configuration to another past solids.

    Attributes:
        family: Kind of scene.
        number: Which of its family; with the seed it names the problem.
        objects: The solids in the world, in the frame of the arm's base.
        start: Configuration at the start, shape (7,), rad.
        goal: Configuration at the goal, shape (7,), rad.
    """

    family: str
    number: int
    objects: tuple[SceneObject, ...]
    start: Array
    goal: Array

    @property
    def name(self) -> str:
        """Family and number."""
        return f"{self.family}/{self.number}"

    def to_json(self) -> dict[str, Any]:
        """As plain values: lengths in m, angles in rad, quaternions xyzw."""
        return {
            "family": self.family,
            "number": self.number,
            "objects": [object_to_json(item) for item in self.objects],
            "start": self.start.tolist(),
            "goal": self.goal.tolist(),
        }

    @staticmethod
    def from_json(document: Mapping[str, Any]) -> Problem:
        """Read what :meth:`to_json` wrote."""
        return Problem(
            family=document["family"],
            number=document["number"],
            objects=tuple(_object_from_json(item) for item in document["objects"]),
            start=np.array(document["start"]),
            goal=np.array(document["goal"]),
        )


def object_to_json(item: SceneObject) -> dict[str, Any]:
    """One solid as plain values: its kind, sizes (edges; radius, height; radius) and pose."""
    kind, size = _kind_and_size(item.shape)
    quaternion = poses.quaternion_from_rotation(item.world_T_object[:3, :3])
    return {
        "name": item.name,
        "kind": kind,
        "size": size,
        "position": item.world_T_object[:3, 3].tolist(),
        "quaternion": quaternion.tolist(),
    }


def _kind_and_size(shape: Shape) -> tuple[str, list[float]]:
    if isinstance(shape, Box):
        return "box", list(shape.size_m)
    if isinstance(shape, Cylinder):
        return "cylinder", [shape.radius_m, shape.height_m]
    return "ball", [shape.radius_m]


def _object_from_json(document: Mapping[str, Any]) -> SceneObject:
    size = document["size"]
    shapes: dict[str, Shape] = {}
    if document["kind"] == "box":
        shapes["box"] = Box((size[0], size[1], size[2]))
    elif document["kind"] == "cylinder":
        shapes["cylinder"] = Cylinder(size[0], size[1])
    else:
        shapes["ball"] = Ball(size[0])
    pose = poses.transform(poses.rotation_from_quaternion(document["quaternion"]), document["position"])
    return SceneObject(document["name"], shapes[document["kind"]], pose, movable=False)
