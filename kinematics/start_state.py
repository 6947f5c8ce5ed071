"""A start that is nearer to something than it should be, because that something moved.

No plan can begin where the robot already breaks a margin. What is nearer than its margin at the start
keeps most of the distance that it has there; a movable object that is believed to touch a link may be
touched by that link. Everything else is judged as before.
"""

from __future__ import annotations

import functools
from dataclasses import dataclass, replace

import coal
import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from kinematics.collision import coal_shape
from kinematics.robot_model import RobotModel
from kinematics.scene import PlanningScene, SceneObject
from kinematics.shapes import Ball, Box

Array = NDArray[np.float64]

# Kept between the distance at the start and the margin that is asked instead, for rounding.
SLACK_M = 0.001
# Of the distance at the start that has to be kept: hardly any motion leads straight away from a thing.
KEPT_SHARE = 0.6
# A start that keeps its margin by less than this is stuck as well: a way is judged in pieces, and the first
# of them counts as too near whichever way it leads.
ROOM_M = 0.002


def relaxed_at(model: RobotModel, scene: PlanningScene, q: Array, reserve_m: float = 0.0) -> PlanningScene:
    """Lower the margins that a configuration breaks, or just keeps.

    Args:
        model: The robot.
        scene: What is around.
        q: Where the robot is, shape (nq,).
        reserve_m: What the caller adds to every margin.

    Returns:
        The same scene when nothing is too near; else one in which ``q`` is free, unless a link is in
        furniture or in another link.
    """
    parts = _parts(model)
    geometry, placed = parts.geometry, parts.placed
    pin.updateGeometryPlacements(model.pin, parts.data, geometry, placed, q)
    centres = np.array([at.act(centre) for at, centre in zip(placed.oMg, parts.centres_m, strict=True)])
    relaxed = scene
    for item in scene.objects.values():
        keep_m = item.margin_m + reserve_m
        distances = {
            parts.links[k]: _distance(geometry.geometryObjects[k], placed.oMg[k], item)
            for k in _near(centres, parts.radii_m, item, keep_m + ROOM_M)
            if not scene.is_allowed(parts.links[k], item.name)
        }
        nearest = min(distances.values(), default=np.inf)
        if nearest >= keep_m + ROOM_M:
            continue
        if nearest >= keep_m:
            relaxed = relaxed.with_object(replace(item, margin_m=max(0.0, nearest - ROOM_M - reserve_m)))
            continue
        margin = max(0.0, KEPT_SHARE * nearest - reserve_m - SLACK_M)
        relaxed = relaxed.with_object(replace(item, margin_m=margin))
        if item.movable:
            touching = [link for link, distance in distances.items() if distance < reserve_m + SLACK_M]
            relaxed = relaxed.allowing((link, item.name) for link in touching)
    return relaxed


@dataclass(frozen=True, slots=True)
class _Parts:
    """A robot's collision geometries with a ball about each, in its own frame.

    With Pinocchio's memory for where they are: to make it takes longer than all that is done with it.
    """

    geometry: pin.GeometryModel
    data: pin.Data
    placed: pin.GeometryData
    links: tuple[str, ...]
    centres_m: tuple[Array, ...]
    radii_m: Array


@functools.lru_cache(maxsize=4)
def _parts(model: RobotModel) -> _Parts:
    geometry = model.geometry()
    items = list(geometry.geometryObjects)
    return _Parts(
        geometry,
        model.pin.createData(),
        geometry.createData(),
        tuple(model.link_of(item) for item in items),
        tuple(np.array(item.geometry.aabb_center) for item in items),
        np.array([item.geometry.aabb_radius for item in items]),
    )


def _near(centres_m: Array, radii_m: Array, item: SceneObject, near_m: float) -> list[int]:
    """Which balls come near a box about an object."""
    pose, shape = item.world_T_object, item.shape
    local = (centres_m - pose[:3, 3]) @ pose[:3, :3]
    if isinstance(shape, Box):
        half = 0.5 * np.array(shape.size_m)
    elif isinstance(shape, Ball):
        half = np.full(3, shape.radius_m)
    else:
        half = np.array([shape.radius_m, shape.radius_m, 0.5 * shape.height_m])
    outside = np.maximum(np.abs(local) - half, 0.0)
    return [int(k) for k in np.flatnonzero(np.sqrt(np.sum(outside**2, axis=1)) < radii_m + near_m)]


def _distance(part: pin.GeometryObject, at: pin.SE3, item: SceneObject) -> float:
    pose = item.world_T_object
    return float(
        coal.distance(
            part.geometry,
            coal.Transform3s(at.rotation, at.translation),
            coal_shape(item.shape),
            coal.Transform3s(pose[:3, :3], pose[:3, 3]),
            coal.DistanceRequest(),
            coal.DistanceResult(),
        )
    )
