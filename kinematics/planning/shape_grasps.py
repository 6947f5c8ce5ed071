"""Ways to take hold of a thing of any shape: where two sides of it face each other between the pads.

Candidates come from points of its surface (antipodal grasps: Nguyen, 1988): two points whose normals are
within the friction cone of the line between them, with a margin for errors of the pose. The hand is then
turned about that line, and each pose is judged by all points: what is between the pads. Whether the open
fingers and the palm pass by the rest, the hand's own solids tell. Frames are those of the thing; the planner
judges room, reach and motion.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array, Indices, Sealed
from kinematics.collision.validity import hand_judge
from kinematics.geometry.convex_parts import ConvexParts
from kinematics.geometry.poses import Transform
from kinematics.geometry.shapes import Box
from kinematics.model.derived import Recent
from kinematics.model.robot_description import GripperDescription, Hand
from kinematics.model.robot_model import RobotModel
from kinematics.scene.planning_scene import PlanningScene, SceneObject

Flags = NDArray[np.bool_]

FIT_ERROR_M = 0.006
"""A thing whose outline is nearer than this to it is grasped as if it were that."""
CONE_RAD = math.radians(25.0)
"""Between a normal and the line across: friction 0.6 holds to 31 degrees, and the pose is wrong by 3. Of the
most slanting a floating hand held 48 of 48, its pose wrong by 4 mm and 3 degrees."""
SPARE_OPENING_M = 0.006
_BETWEEN = 500
"""Points from which a line across is looked for."""
_THINNEST_M, _WALL_M, _BESIDE_M = 0.002, 0.02, 0.006
"""What is thinner than the first is nothing; than the second a wall, whose sides face each other where their
places are no farther beside each other than the third."""
_ENOUGH = 60
"""Grasps; where fewer are found of a thing, it is looked at more densely."""
_OVERLAP_M, _OVERLAP_SHARE = 0.013, 0.45
"""How much farther than the middle of the pads the thing is towards their tips, at most, and in shares of
half of a pad."""
_WAY_IN_M, _WAY_POINTS = 0.1, 6
"""Of the straight approach, looked at in so many places."""
_FINGER_THICK_M, _FINGER_WIDE_M = 0.012, 0.02
"""Of a finger's tip, at least: across the opening, and half of it across the approach."""
_TOUCH_M = 0.003
_FACING_M = 0.018
"""So far apart along the pads may be what the two sides press on."""
_LEAST_PATCH = 2
_ALIKE_COSINE = math.cos(math.radians(20.0))
_UP_COSINE = math.cos(math.radians(95.0))
"""An approach may come from a little below the level, not from farther below."""
_MOST = 400
_KEPT = 64
"""Things of one robot whose grasps are remembered."""
LEVER_COST_PER_M = 12.0
BELOW_COST_PER_M = 4.0
"""Held below its middle a thing leans in the hand, and the hand is nearer to what it stands on."""
SLANT_COST = 1.5
DEEP_COST = 0.1


@dataclass(frozen=True, slots=True)
class ShapeGrasps(Sealed):
    """Grasps of a thing by one hand, in the thing's frame, best first.

    Attributes:
        object_T_tcp: Where the TCP is, shape (n, 4, 4).
        opening_m: Between the pads when they hold it, shape (n,).
        off_centre_m: Of the middle of the thing from that between the pads, along the opening, shape (n,).
        cost: Lever of the weight, slant of the surfaces, shape (n,).
        narrowest_m: The least distance of two sides that face each other; infinite where none do.
        fitting: How many lines across are within the hand's opening.
    """

    object_T_tcp: Array
    opening_m: Array
    off_centre_m: Array
    cost: Array
    narrowest_m: float
    fitting: int


def needs_shape_grasps(parts: ConvexParts | None) -> bool:
    """Whether a thing is so unlike its outline that it is grasped by its surface."""
    return parts is not None and parts.outline_error_m >= FIT_ERROR_M and len(parts.surface) > 0


def shape_grasps(parts: ConvexParts, model: RobotModel, hand: Hand, pose: Transform) -> ShapeGrasps:
    """Grasps of a thing as it lies; the same thing, lying the same way, is looked at once.

    Args:
        parts: What it is made of, with points of its surface.
        model: The robot.
        hand: Which of its hands.
        pose: Of the thing in the world, shape (4, 4); only which way is up matters.
    """
    up = np.round(pose[2, :3], 1) + 0.0
    x, y, z = (up / np.linalg.norm(up)).tolist()
    lately = model.derived(_lately)
    return lately.of((parts, hand, (x, y, z)), lambda: _found(parts, model, hand, (x, y, z)))


def _lately(_model: RobotModel) -> Recent[tuple[ConvexParts, Hand, tuple[float, float, float]], ShapeGrasps]:
    """What a robot looked at lately: planners ask for the same thing many times."""
    return Recent(_KEPT)


def _found(parts: ConvexParts, model: RobotModel, hand: Hand, up: tuple[float, float, float]) -> ShapeGrasps:
    found = _looked_at(parts, model, hand, up, _USUAL)
    if len(found.cost) >= _ENOUGH:
        return found
    densely = _looked_at(parts, model, hand, up, _DENSE)
    return densely if len(densely.cost) > len(found.cost) else found


def _looked_at(
    parts: ConvexParts, model: RobotModel, hand: Hand, up: tuple[float, float, float], density: _Density
) -> ShapeGrasps:
    gripper = model.description.grippers[hand]
    widest = gripper.max_opening_m - 2.0 * SPARE_OPENING_M
    lines, narrowest = _lines_across(parts, gripper.least_felt_m, widest, density)
    middle = parts.surface.mean(axis=0)
    poses, slants = _turned(lines, np.array(up), density.turns)
    off_support = _off_support(poses, gripper, np.array(up), float((parts.corners @ np.array(up)).min()))
    poses, slants = poses[off_support], slants[off_support]
    points = np.concatenate([parts.surface[:900], parts.corners])
    normals = np.concatenate([parts.normals[:900], np.zeros_like(parts.corners)])
    kept = _judged(poses, points, normals, gripper, widest)
    kept = _with_room(kept, parts, model, hand)
    lever = _lever(kept.poses, middle, np.array(up))
    below = np.maximum(0.0, (middle - kept.poses[:, :3, 3]) @ np.array(up))
    cost = (
        LEVER_COST_PER_M * lever
        + BELOW_COST_PER_M * below
        + SLANT_COST * (slants[kept.row] + kept.slant)
        + DEEP_COST * kept.shallow
    )
    best = np.argsort(cost, kind="stable")[:_MOST]
    tcp_T_middle = np.einsum("nji,nj->ni", kept.poses[:, :3, :3], -kept.poses[:, :3, 3])
    return ShapeGrasps(
        object_T_tcp=kept.poses[best],
        opening_m=kept.opening_m[best],
        off_centre_m=tcp_T_middle[best, 1],
        cost=cost[best],
        narrowest_m=narrowest,
        fitting=len(lines.middle),
    )


def facing_sides(start: Array, outwards: Array, points: Array, normals: Array) -> tuple[Array, Array]:
    """How places on a surface face each other, seen from some of them.

    Args:
        start, outwards: Those places and their normals, shape (m, 3).
        points, normals: All places, shape (n, 3).

    Returns:
        The way across to each, shape (m, n, 3), and the cosine of how aslant the worse side is to it; -1
        where nothing is between. Through what is thinner than places are apart, a wall, the way is along the
        normal: pads press on more than a point.
    """
    apart = points[None] - start[:, None]
    length = np.sqrt(np.einsum("ijk,ijk->ij", apart, apart)) + 1e-12
    deep = -np.einsum("ijk,ik->ij", apart, outwards)
    arriving = np.einsum("ijk,jk->ij", apart, normals) / length
    worst = np.where(length > _THINNEST_M, np.minimum(deep / length, arriving), -1.0)
    beside = np.sqrt(np.maximum(length**2 - deep**2, 0.0))
    wall = (length < _WALL_M) & (beside < _BESIDE_M) & (deep > _THINNEST_M)
    i, j = np.nonzero(wall)
    apart[i, j] = -deep[i, j, None] * outwards[i]
    worst[i, j] = -np.einsum("ik,ik->i", outwards[i], normals[j])
    return apart, worst


class _Density(NamedTuple):
    """How densely a thing is looked at: lines across, how near alike ones may be, m, and turns about each."""

    lines: int
    alike_m: float
    turns: int


_USUAL, _DENSE = _Density(70, 0.012, 16), _Density(300, 0.006, 32)


class _Lines(NamedTuple):
    """Lines across a thing: the middle between the two sides, unit direction, and how aslant these are."""

    middle: Array
    across: Array
    slant: Array


def _lines_across(parts: ConvexParts, least: float, widest: float, density: _Density) -> tuple[_Lines, float]:
    """Lines between two sides that face each other, no two alike, and the least distance of such sides."""
    points, normals = parts.surface, parts.normals
    across, worst = facing_sides(points[:_BETWEEN], normals[:_BETWEEN], points, normals)
    length = np.sqrt(np.einsum("ijk,ijk->ij", across, across))
    facing = worst >= math.cos(CONE_RAD)
    narrowest = float(length[facing].min()) if facing.any() else math.inf
    worst = np.where(facing & (length >= least) & (length <= widest), worst, -1.0)
    best = worst.argmax(axis=1)
    rows = np.flatnonzero(worst[np.arange(len(best)), best] > 0.0)
    order = rows[np.argsort(-worst[rows, best[rows]], kind="stable")]
    middle = points[order] + 0.5 * across[order, best[order]]
    across = across[order, best[order]] / length[order, best[order]][:, None]
    slant = np.arccos(np.clip(worst[order, best[order]], -1.0, 1.0))
    chosen: list[int] = []
    for k in range(len(order)):
        near = np.linalg.norm(middle[chosen] - middle[k], axis=1) < density.alike_m
        if not np.any(near & (np.abs(across[chosen] @ across[k]) > _ALIKE_COSINE)):
            chosen.append(k)
            if len(chosen) == density.lines:
                break
    return _Lines(middle[chosen], across[chosen], slant[chosen]), narrowest


def _turned(lines: _Lines, up: Array, turns: int) -> tuple[Array, Array]:
    """The hand at each line, turned about it, and not from below; poses, and the slant of their line."""
    y = lines.across
    first = np.cross(y, np.where(np.abs(y @ up)[:, None] < 0.9, up, np.roll(np.eye(3)[0], 1)))
    first /= np.linalg.norm(first, axis=1)[:, None] + 1e-12
    second = np.cross(y, first)
    angles = 2.0 * math.pi * np.arange(turns) / turns
    x = np.cos(angles)[:, None, None] * first + np.sin(angles)[:, None, None] * second
    x = x.transpose(1, 0, 2).reshape(-1, 3)
    y = np.repeat(y, turns, axis=0)
    poses = np.zeros((len(x), 4, 4))
    poses[:, :3, 0], poses[:, :3, 1], poses[:, :3, 2] = x, y, np.cross(x, y)
    poses[:, :3, 3], poses[:, 3, 3] = np.repeat(lines.middle, turns, axis=0), 1.0
    downwards = x @ up <= -_UP_COSINE
    return poses[downwards], np.repeat(lines.slant, turns)[downwards]


def _off_support(poses: Array, gripper: GripperDescription, up: Array, level: float) -> Flags:
    """Whether the open fingers are above what the thing stands on; the planner judges all of the hand."""
    tips = max(half[2] for half in gripper.pad_half_size_m) + gripper.closing_advance_m
    out = 0.5 * gripper.max_opening_m + _FINGER_THICK_M
    x, y, z = (np.abs(poses[:, :3, k] @ up) for k in range(3))
    along = np.where(poses[:, :3, 0] @ up < 0.0, tips * x, 0.0)
    lowest = poses[:, :3, 3] @ up - along - out * y - _FINGER_WIDE_M * z
    return np.asarray(lowest > level, bool)


class _Kept(NamedTuple):
    """Poses that can hold: each with the row that it came from, opening, slant and how near to the tips."""

    poses: Array
    row: Indices
    opening_m: Array
    slant: Array
    shallow: Array


def _judged(poses: Array, points: Array, normals: Array, gripper: GripperDescription, widest: float) -> _Kept:
    """Keep the poses at which the thing is between the pads."""
    half_long = max(half[2] for half in gripper.pad_half_size_m)
    across = gripper.fingers_half_width_m
    narrow_m = min(half[0] for half in gripper.pad_half_size_m)
    open_m, found = 0.5 * gripper.max_opening_m - SPARE_OPENING_M, []
    for over_m in (0.0, min(_OVERLAP_M, _OVERLAP_SHARE * half_long)):
        for row, pose in enumerate(poses):
            place = pose.copy()
            place[:3, 3] -= over_m * pose[:3, 0]
            x, y, z = ((points - place[:3, 3]) @ place[:3, :3]).T
            beside = (np.abs(x) <= half_long) & (np.abs(z) <= across)
            # what is beyond the open fingers is not between them: the other side of a mug whose wall is
            pads = beside & (np.abs(y) <= open_m)
            if not pads.any():
                continue
            low, high = float(y[pads].min()), float(y[pads].max())
            opening, shift = high - low, 0.5 * (low + high)
            if not gripper.least_felt_m <= opening <= widest:
                continue
            # one side may be a single finger, which has to meet what the other side's outermost one meets
            middle = y[pads & (np.abs(z) <= narrow_m)]
            if not len(middle) or middle.min() > low + _TOUCH_M or middle.max() < high - _TOUCH_M:
                continue
            y = y - shift
            # what is cut off by the open fingers' ends may be what is between them once they are centred
            if np.ptp(y[beside & (np.abs(y) <= 0.5 * opening + SPARE_OPENING_M)]) > opening + _THINNEST_M:
                continue
            slant = _facing(x, y, z, normals @ place[:3, 1], pads, 0.5 * opening)
            if slant is None:
                continue
            place[:3, 3] += shift * place[:3, 1]
            found.append((place, row, opening, slant, float(over_m > 0.0)))
    if not found:
        nothing = np.zeros(0)
        return _Kept(np.zeros((0, 4, 4)), np.zeros(0, np.int64), nothing, nothing, nothing)
    each = list(zip(*found, strict=True))
    return _Kept(np.array(each[0]), np.array(each[1], np.int64), *(np.array(one) for one in each[2:]))


def _with_room(kept: _Kept, parts: ConvexParts, model: RobotModel, hand: Hand) -> _Kept:
    """Keep those at which nothing of the thing is in the way of the open hand, nor on the way there."""
    if not len(kept.poses):
        return kept
    size = 2.0 * np.abs(parts.corners).max(axis=0)
    whole = Box((float(size[0]), float(size[1]), float(size[2])), parts)
    alone = PlanningScene().with_object(SceneObject("thing", whole, np.eye(4)))
    judge = hand_judge(model, hand, alone, "", SPARE_OPENING_M)
    free = judge.fits_along(kept.poses, np.linspace(0.0, -_WAY_IN_M, _WAY_POINTS).tolist())
    poses, row, opening_m, slant, shallow = kept
    return _Kept(poses[free], row[free], opening_m[free], slant[free], shallow[free])


def _facing(x: Array, y: Array, z: Array, along: Array, pads: Flags, half: float) -> float | None:
    """How aslant the two sides are that the pads press on; None where they do not face each other.

    Args:
        x, y, z: Of all points, in the frame of the TCP.
        along: Component of their normals along the opening.
        pads: Which are between the pads.
        half: Of the opening.
    """
    low, high = pads & (y < -half + _TOUCH_M), pads & (y > half - _TOUCH_M)
    flat_low, flat_high = low & (along < -math.cos(CONE_RAD)), high & (along > math.cos(CONE_RAD))
    if flat_low.sum() < _LEAST_PATCH or flat_high.sum() < _LEAST_PATCH:
        return None
    for one in (x, z):
        begin = max(one[flat_low].min(), one[flat_high].min())
        end = min(one[flat_low].max(), one[flat_high].max())
        if begin > end + _FACING_M:
            return None
    return float(np.arccos(min(1.0, np.mean(np.abs(along[flat_low | flat_high])))))


def _lever(poses: Array, middle: Array, up: Array) -> Array:
    """How far the weight pulls beside the line between the pads, about which it could turn, shape (n,)."""
    if not len(poses):
        return np.zeros(0)
    off = middle - poses[:, :3, 3]
    y = poses[:, :3, 1]
    # the part of the moment that turns the thing about the opening
    return np.asarray(np.abs(np.einsum("ni,ni->n", np.cross(off, up), y)))
