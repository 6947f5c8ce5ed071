"""What is around, as part of an order's document, and back; read strictly."""

from __future__ import annotations

import dataclasses
from typing import Any

from kinematics.arrays import Array
from kinematics.formats.json_reader import Node
from kinematics.formats.solid_document import (
    held_json,
    object_json,
    optional_items,
    read_held,
    read_object,
    read_pair,
    require_unique,
)
from kinematics.formats.trajectory_fit import allowed_in, furnished, held_in
from kinematics.model.robot_model import RobotModel
from kinematics.scene.planning_scene import PlanningScene

SCENE_KEYS = ("objects", "furniture", "held", "allowed")


def scene_part(scene: PlanningScene, model: RobotModel) -> dict[str, Any]:
    """The part of a document that tells what is around."""
    return {
        "objects": [object_json(item) for item in scene.objects.values()],
        "furniture": [item.name for item in scene.objects.values() if not item.movable],
        "held": [held_json(item) for item in held_in(scene)],
        "allowed": sorted(sorted(pair) for pair in allowed_in(scene, model)),
    }


def read_scene_part(root: Node, model: RobotModel, q: Array) -> PlanningScene:
    """The scene of a document.

    Args:
        root: The document.
        model: The robot that shall carry it out.
        q: Its configuration, shape (nq,): where what it holds is.

    Raises:
        KinematicsError: It is none, or not of this robot; with the place and the reason.
    """
    furniture = {item.text() for item in optional_items(root, "furniture")}
    objects = [read_object(node) for node in optional_items(root, "objects")]
    around = PlanningScene().with_objects(
        dataclasses.replace(item, movable=item.name not in furniture) for item in objects
    )
    held = [read_held(node) for node in optional_items(root, "held")]
    require_unique(root, "objects", [item.name for item in objects])
    require_unique(root, "held", [item.name for item in held])
    allowed = frozenset(read_pair(node) for node in optional_items(root, "allowed"))
    return furnished(around, held, allowed, model, q)
