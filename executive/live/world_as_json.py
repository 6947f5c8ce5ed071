"""The whole world as it is believed, for programs that draw it: solids, poses, errors and confidences.

Lengths are metres; poses are in the odometry frame as place and quaternion (x, y, z, w).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from executive.live.told_as_json import beginning
from kinematics.geometry import poses
from kinematics.geometry.poses import Transform
from kinematics.geometry.shapes import Box, Cylinder, Shape
from kinematics.model.robot_model import RobotModel
from kinematics.motion.trajectory import Trajectory
from kinematics.scene.planning_scene import FLOOR, SceneObject
from robots.perception.object_estimate import ObjectEstimate
from robots.scenes.scene_description import Region
from trees.beliefs.scene.believed_thing import PERSON
from trees.beliefs.scene.labels import label_of
from trees.toolbox import Toolbox
from trees.world_model import WorldModel

_PATH_POINTS, _LEAST_PATH_M = 40, 0.02


def world_json(
    world: WorldModel, paths: Sequence[Mapping[str, Any]] = (), rooms: Sequence[Mapping[str, Any]] = ()
) -> dict[str, Any]:
    """What is believed, as JSON values: the version of the scene and its things, nearest the origin first.

    A thing's ``held`` is the frame that carries it, and its pose is then in that frame. ``error_m`` are the
    standard deviations along x, y and z, and ``confidence`` is that of the look of this task that showed it;
    both are left out where no look of this task did.

    Args:
        world: The world model.
        paths: The ways that hands are planned to go, from ``paths_json``.
        rooms: Those of the map, from ``rooms_json``.
    """
    scene = world.scene
    held = [
        {**_thing(body.body, body.frame_T_object, world.sightings.get(name)), "held": body.frame}
        for name, body in sorted(scene.attached.items())
    ]
    free = sorted(scene.objects.values(), key=lambda one: float(np.hypot(*one.world_T_object[:2, 3])))
    things = [
        _thing(one, one.world_T_object, world.sightings.get(one.name)) for one in free if one.name != FLOOR
    ]
    told = beginning([*held, *things])
    return {"version": scene.version, "things": told, "paths": list(paths), "rooms": list(rooms)}


def believed_json(toolbox: Toolbox, planned: Trajectory | None) -> dict[str, Any]:
    """Everything that is believed, and the way that is planned; as ``world_json``.

    Args:
        toolbox: Of the robot.
        planned: The trajectory that is carried out, or None.
    """
    return world_json(toolbox.world, paths_json(toolbox.model, planned), rooms_json(toolbox.places))


def rooms_json(places: Mapping[str, Region]) -> list[Mapping[str, Any]]:
    """The rooms of the map, in the odometry frame: ``name``, ``middle_m``, ``size_m`` and ``yaw_rad``."""
    return [
        {
            "name": name,
            "middle_m": _rounded(np.array(room.position_m), 3),
            "size_m": _rounded(np.array(room.size_m), 3),
            "yaw_rad": round(room.yaw_rad, 4),
        }
        for name, room in places.items()
    ]


def paths_json(model: RobotModel, planned: Trajectory | None) -> list[Mapping[str, Any]]:
    """The ways that hands are planned to go: ``hand`` and ``points_m``; one that stays where it is has none.

    Args:
        model: The robot.
        planned: The trajectory that is carried out, or None.
    """
    if planned is None:
        return []
    samples = planned.q[np.unique(np.linspace(0, len(planned.t_s) - 1, _PATH_POINTS).astype(int))]
    found: list[Mapping[str, Any]] = []
    for hand, frame in model.description.tcp_frames.items():
        points = np.array([model.frame_pose(q, frame)[:3, 3] for q in samples])
        if np.ptp(points, axis=0).max() > _LEAST_PATH_M:
            found.append({"hand": hand, "points_m": points.round(3).tolist()})
    return found


def _thing(one: SceneObject, pose: Transform, seen: ObjectEstimate | None) -> Mapping[str, Any]:
    label = label_of(one)
    is_person = not one.movable and (label.kind == PERSON or one.name[:1].isupper())
    told: dict[str, Any] = {
        "name": one.name,
        "kind": label.kind,
        "color": label.color,
        "is": "object" if one.movable else "person" if is_person else "furniture",
        **_solid(one.shape),
        "place_m": _rounded(pose[:3, 3], 4),
        "quaternion": _rounded(poses.quaternion_from_rotation(pose[:3, :3]), 5),
        "margin_m": round(one.margin_m, 4),
    }
    if seen is not None:
        told["confidence"] = round(seen.confidence, 3)
        if seen.error is not None:
            told["error_m"] = _rounded(np.sqrt(np.diag(seen.error.covariance_m2)), 4)
    return {key: value for key, value in told.items() if value is not None}


def _solid(shape: Shape) -> dict[str, Any]:
    if isinstance(shape, Box):
        return {"shape": "box", "size_m": _rounded(np.array(shape.size_m), 4)}
    if isinstance(shape, Cylinder):
        return {"shape": "cylinder", "size_m": [round(shape.radius_m, 4), round(shape.height_m, 4)]}
    return {"shape": "ball", "size_m": [round(shape.radius_m, 4)]}


def _rounded(values: Any, digits: int) -> list[float]:
    return [round(float(value), digits) for value in values]
