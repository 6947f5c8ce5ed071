"""A start that is nearer to something than it should be, because that something moved.

No plan can begin where the robot already breaks a margin. What is nearer than its margin at the start
keeps most of the distance that it has there; a movable object that is believed to touch a link may be
touched by that link. Everything else is judged as before.
"""

from __future__ import annotations

import functools
from collections.abc import Sequence
from dataclasses import dataclass, replace

import coal
import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from kinematics.collision import coal_shape
from kinematics.robot_model import RobotModel
from kinematics.scene import PlanningScene, SceneObject
from kinematics.shapes import Box, Shape

Array = NDArray[np.float64]

# Kept between the distance at the start and the margin that is asked instead, for rounding.
SLACK_M = 0.001
# Of the distance at the start that has to be kept: hardly any motion leads straight away from a thing.
KEPT_SHARE = 0.6
# A start that keeps its margin by less than this is stuck as well: a way is judged in pieces, and the first
# of them counts as too near whichever way it leads.
ROOM_M = 0.002
# Links whose poses differ by less than this stay where they are.
_AT_REST = 1e-9


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
    centres = _placed_centres(model, parts, q)
    items = list(scene.objects.values())
    relaxed = scene
    for item, near in zip(items, _near(centres, parts.radii_m, items, reserve_m + ROOM_M), strict=True):
        distances = {
            parts.links[k]: _distance(geometry.geometryObjects[k], placed.oMg[k], item)
            for k in near
            if not scene.is_allowed(parts.links[k], item.name)
        }
        nearest = min(distances.values(), default=np.inf)
        if nearest >= item.margin_m + reserve_m + ROOM_M:
            continue
        if nearest >= item.margin_m:  # the reserve alone is broken: it changes nothing about what is kept
            relaxed = relaxed.with_object(replace(item, margin_m=max(0.0, nearest - ROOM_M - reserve_m)))
            continue
        margin = max(0.0, KEPT_SHARE * nearest - reserve_m - SLACK_M)
        relaxed = relaxed.with_object(replace(item, margin_m=margin))
        if item.movable:
            touching = [link for link, distance in distances.items() if distance < reserve_m + SLACK_M]
            relaxed = relaxed.allowing((link, item.name) for link in touching)
    return relaxed


def touching_at_rest(model: RobotModel, scene: PlanningScene, q_start: Array, q_goal: Array) -> PlanningScene:
    """Let links that stay where they are be as near to things as they are.

    A hand that is believed to be inside a door is believed so wrongly, or holds it; either way the head
    may turn to look again.

    Args:
        model: The robot.
        scene: What is around.
        q_start, q_goal: Ends of a straight line between configurations, shape (nq,).

    Returns:
        The same scene when no link that rests is too near to anything.
    """
    parts = _parts(model)
    geometry, placed = parts.geometry, parts.placed
    _placed_centres(model, parts, q_goal)
    there = [pin.SE3(at) for at in placed.oMg]
    centres = _placed_centres(model, parts, q_start)
    resting = {k for k, at in enumerate(placed.oMg) if at.isApprox(there[k], _AT_REST)}
    items = list(scene.objects.values())
    pairs = [
        (parts.links[k], item.name)
        for item, near in zip(items, _near(centres, parts.radii_m, items, ROOM_M), strict=True)
        for k in resting.intersection(near)
        if _distance(geometry.geometryObjects[k], placed.oMg[k], item) < item.margin_m + ROOM_M
    ]
    return scene.allowing(pairs) if pairs else scene


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


def _placed_centres(model: RobotModel, parts: _Parts, q: Array) -> Array:
    """Place the geometries in ``parts`` at a configuration; centres of their balls, shape (n, 3)."""
    pin.updateGeometryPlacements(model.pin, parts.data, parts.geometry, parts.placed, q)
    return np.array([at.act(centre) for at, centre in zip(parts.placed.oMg, parts.centres_m, strict=True)])


def _near(
    centres_m: Array, radii_m: Array, items: Sequence[SceneObject], reserve_m: float
) -> list[list[int]]:
    """Which balls come near to a box about each object: nearer than its margin and a reserve."""
    poses = np.array([item.world_T_object for item in items]).reshape(-1, 4, 4)
    half = np.array([_half_extents_m(item.shape) for item in items]).reshape(-1, 1, 3)
    local = (centres_m - poses[:, None, :3, 3]) @ poses[:, :3, :3]
    outside = np.maximum(np.abs(local) - half, 0.0)
    near_m = np.array([item.margin_m + reserve_m for item in items])[:, None] + radii_m
    near = np.sqrt(np.sum(outside**2, axis=2)) < near_m
    return [np.flatnonzero(row).tolist() for row in near]


def _half_extents_m(shape: Shape) -> tuple[float, float, float]:
    if isinstance(shape, Box):
        x, y, z = shape.size_m
        return 0.5 * x, 0.5 * y, 0.5 * z
    return shape.radius_m, shape.radius_m, 0.5 * shape.height_m


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
