"""A start that is nearer to something than it should be, because that something moved.

No plan can begin where the robot already breaks a margin. What is nearer than its margin at the start
keeps most of the distance that it has there; a movable object that is believed to touch a link may be
touched by that link. Everything else is judged as before.
"""

from __future__ import annotations

from dataclasses import replace

import coal
import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from kinematics.collision import coal_shape
from kinematics.robot_model import RobotModel
from kinematics.scene import PlanningScene, SceneObject
from kinematics.shapes import Ball, Box

# Kept between the distance at the start and the margin that is asked instead, for rounding.
SLACK_M = 0.001
# Of the distance at the start that has to be kept: hardly any motion leads straight away from a thing.
KEPT_SHARE = 0.6


def relaxed_at(
    model: RobotModel, scene: PlanningScene, q: NDArray[np.float64], reserve_m: float = 0.0
) -> PlanningScene:
    """Lower the margins that a configuration breaks.

    Args:
        model: The robot.
        scene: What is around.
        q: Where the robot is, shape (nq,).
        reserve_m: What the caller adds to every margin.

    Returns:
        The same scene when nothing is too near; else one in which ``q`` is free, unless a link is in
        furniture or in another link.
    """
    geometry, data = model.geometry(), model.pin.createData()
    placed = geometry.createData()
    pin.updateGeometryPlacements(model.pin, data, geometry, placed, q)
    relaxed = scene
    for item in scene.objects.values():
        keep_m = item.margin_m + reserve_m
        distances = {
            model.link_of(part): _distance(part, at, item)
            for part, at in zip(geometry.geometryObjects, placed.oMg, strict=True)
            if _may_be_near(part, at, item, keep_m) and not scene.is_allowed(model.link_of(part), item.name)
        }
        nearest = min(distances.values(), default=np.inf)
        if nearest >= keep_m:
            continue
        margin = max(0.0, KEPT_SHARE * nearest - reserve_m - SLACK_M)
        relaxed = relaxed.with_object(replace(item, margin_m=margin))
        if item.movable:
            touching = [link for link, distance in distances.items() if distance < reserve_m + SLACK_M]
            relaxed = relaxed.allowing((link, item.name) for link in touching)
    return relaxed


def _may_be_near(part: pin.GeometryObject, at: pin.SE3, item: SceneObject, near_m: float) -> bool:
    """Whether a ball about a part comes near a box about an object."""
    ball = part.geometry
    local = (at.act(ball.aabb_center) - item.world_T_object[:3, 3]) @ item.world_T_object[:3, :3]
    shape = item.shape
    if isinstance(shape, Box):
        half = 0.5 * np.array(shape.size_m)
    elif isinstance(shape, Ball):
        half = np.full(3, shape.radius_m)
    else:
        half = np.array([shape.radius_m, shape.radius_m, 0.5 * shape.height_m])
    outside = np.maximum(np.abs(local) - half, 0.0)
    return bool(np.sqrt(outside @ outside) < ball.aabb_radius + near_m)


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
