"""Grasps of a thing: by its outline where that fits, else by its surface; and why there is none."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence

import numpy as np

from kinematics.arrays import Array
from kinematics.geometry.convex_parts import ConvexParts
from kinematics.model.robot_description import GripperDescription, Hand
from kinematics.model.robot_model import RobotModel
from kinematics.planning.grasps import (
    ABOVE_MIDDLE,
    OTHER_HEIGHTS,
    GraspTable,
    grasp_table,
    least_width_m,
    widest_between_pads_m,
)
from kinematics.planning.palm_sections import with_one_width
from kinematics.planning.shape_grasps import (
    ShapeGrasps,
    needs_shape_grasps,
    shape_grasps,
)
from kinematics.scene.planning_scene import SceneObject
from kinematics.scene.support_of import half_height_m

_HALF_TURN = np.array([1.0, -1.0, -1.0])
_ROLLED_COST = 0.3
_BELLY_HEIGHTS = (-0.1, -0.18)
"""Below the middle, where most bottles are of one width over the height of fingers that close on a palm. They
come before those above it: on the way in a palm brushed against two slim ones near their tops; both fell."""
_USUAL_YAW_RAD, _USUAL_TILT_RAD, _TILT_SHARE = math.radians(10), math.radians(20), 0.6
"""As of grasps by an outline: an arm comes from its own outer side, and a little from above."""


def every_height(grippers: Iterable[GripperDescription]) -> tuple[float, ...]:
    """Where hands grasp, as shares of a thing's height from its middle: the usual height first."""
    palms = any(gripper.palm_side_m is not None for gripper in grippers)
    return (ABOVE_MIDDLE, *(_BELLY_HEIGHTS if palms else ()), *OTHER_HEIGHTS)


def any_grasp_table(
    item: SceneObject,
    model: RobotModel,
    hand: Hand,
    natural_yaw_rad: float,
    approach_m: float,
    heights: Sequence[float],
    extra_cost: float,
) -> GraspTable:
    """Candidates for one hand of a robot, most natural first; other arguments as of ``grasp_table``."""
    gripper, parts = model.description.grippers[hand], item.shape.parts
    if parts is None or not _by_surface(item, gripper):
        return grasp_table(item, gripper, natural_yaw_rad, approach_m, heights, extra_cost)
    if gripper.palm_side_m is not None:
        table = grasp_table(item, gripper, natural_yaw_rad, approach_m, heights, extra_cost)
        return with_one_width(table, parts, gripper, item.world_T_object)
    found = shape_grasps(parts, model, hand, item.world_T_object)
    places = item.world_T_object @ found.object_T_tcp
    rolled = places.copy()
    rolled[:, :3, :3] = places[:, :3, :3] * _HALF_TURN
    both = np.concatenate([places, rolled])
    outward = 1.0 if gripper.hand == "right" else -1.0
    cost = (
        _unnatural(both, natural_yaw_rad, outward)
        + np.concatenate([found.cost, found.cost + _ROLLED_COST])
        + extra_cost
    )
    order = np.argsort(cost, kind="stable")
    count = len(found.cost)
    names = tuple(f"by its shape {k}" for k in range(count))
    return GraspTable(
        hand=gripper.hand,
        approach_m=approach_m,
        world_T_tcp=both[order],
        diameter_m=np.tile(found.opening_m, 2)[order],
        cost=cost[order],
        label=(
            (names,),
            np.zeros(len(order), np.intp),
            np.tile(np.arange(count), 2)[order],
            ["" if row < count else " rolled" for row in order.tolist()],
        ),
        off_centre_m=np.concatenate([found.off_centre_m, -found.off_centre_m])[order],
    )


def _by_surface(item: SceneObject, gripper: GripperDescription) -> bool:
    """Whether a thing is unlike its outline, or its outline is too wide for the pads: it may have a wall."""
    parts = item.shape.parts
    if parts is None or not len(parts.surface):
        return False
    return needs_shape_grasps(parts) or least_width_m(item) > widest_between_pads_m(gripper)


def _unnatural(places: Array, natural_yaw_rad: float, outward: float) -> Array:
    """How far poses are from how an arm comes most easily, as of grasps by an outline, shape (n,)."""
    ahead = places[:, :3, 0]
    tilt = np.arcsin(np.clip(-ahead[:, 2], -1.0, 1.0))
    yaw = outward * (np.arctan2(ahead[:, 1], ahead[:, 0]) - natural_yaw_rad)
    yaw = (yaw + math.pi) % (2.0 * math.pi) - math.pi
    level = np.hypot(ahead[:, 0], ahead[:, 1])
    return np.asarray(level * np.abs(yaw - _USUAL_YAW_RAD) + _TILT_SHARE * np.abs(tilt - _USUAL_TILT_RAD))


def no_grasp_reason(item: SceneObject, model: RobotModel, hand: Hand) -> str | None:
    """Why a hand can take hold of a thing nowhere, in words for people; None where it could."""
    gripper, parts = model.description.grippers[hand], item.shape.parts
    if parts is None or not needs_shape_grasps(parts):
        return None
    if gripper.palm_side_m is not None:
        table = any_grasp_table(item, model, hand, 0.0, 0.0, every_height([gripper]), 0.0)
        width = f"nowhere is the {item.name} of one width over the height of this hand's fingers"
        return None if len(table) else f"{width} that goes into it"
    found = shape_grasps(parts, model, hand, item.world_T_object)
    return None if len(found.cost) else _reason(item, parts, found, gripper)


def _reason(item: SceneObject, parts: ConvexParts, found: ShapeGrasps, gripper: GripperDescription) -> str:
    name, widest = item.name, widest_between_pads_m(gripper)
    thick = 2.0 * max(half[1] for half in gripper.pad_half_size_m)
    height, across = 2.0 * half_height_m(item), _least_width_m(parts, item)
    if across > widest and height < thick:
        return (
            f"the {name} is flatter than this hand's fingers are thick: {1000 * height:.0f} mm, "
            f"and the fingers {1000 * thick:.0f} mm"
        )
    if found.fitting or math.isinf(found.narrowest_m):
        return f"nowhere do two sides of the {name} face each other where this hand's fingers go"
    if found.narrowest_m > widest:
        return (
            f"the {name} is too wide for the hand: {1000 * found.narrowest_m:.0f} mm, "
            f"and at most {1000 * widest:.0f} mm fit between the fingers"
        )
    felt_mm = 1000 * gripper.least_felt_m
    return (
        f"where the {name} is not too wide for the hand it is thinner than {felt_mm:.0f} mm, "
        "which its fingers do not feel"
    )


def _least_width_m(parts: ConvexParts, item: SceneObject) -> float:
    """The least level width of a thing as it lies."""
    level = parts.corners @ item.world_T_object[:2, :3].T
    angles = np.radians(np.arange(0, 180, 5))
    return float(np.ptp(level @ np.array([np.cos(angles), np.sin(angles)]), axis=0).min())
