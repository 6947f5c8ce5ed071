"""Ways to take hold of a simple solid with a two-sided gripper.

A grasp is a TCP pose: x along the approach, y along the opening. Candidates turn about the vertical
(yaw), tilt from the side to from above, and roll by half a turn; the order is by what usually works
(the natural direction of the arm first), the planner decides.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import product
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array
from kinematics.geometry import poses
from kinematics.geometry.shapes import Ball, Box, Cylinder
from kinematics.model.robot_description import GripperDescription, Hand
from kinematics.requests.grasp import Grasp
from kinematics.scene.planning_scene import SceneObject

# Steps of 15 degrees in yaw and 20 in tilt: neighbours differ by less than the wrist can make up for.
YAWS_RAD = tuple(math.radians(a) for a in (0, 15, -15, 30, -30, 45, -45, 60, -60, 75, -75, 90, -90, 110, 130))
TILTS_RAD = tuple(math.radians(a) for a in (0, 20, 40, 60, 75, 90))
_STEEPEST_RAD = math.radians(70)
_NATURAL_TILT_RAD = math.radians(20)
_ROUNDING_RAD = 1e-6
# Left between pads and object on each side, so that a perception error of this size still fits.
OPENING_RESERVE_M = 0.006
# One of the other grasps of something low reaches less deep by this.
SHALLOWER_M = 0.006
# Stands for the height at which a hand usually grasps, ``GripperDescription.above_middle``: it is compared
# with, and no share of the height of its own.
ABOVE_MIDDLE = 0.12
# Where else, when that does not go: nearer to the top over a high table, lower under an overhang.
NEAR_TOP = 0.4
OTHER_HEIGHTS = (0.28, NEAR_TOP, 0.0)
# Flat pads along the object hold it better than the edges of two pads that it stands between.
STRADDLE_COST = 1.0
# Across a narrower edge of a box the fingers have more room beside it than perception errs: worth a turn.
ROOMY_M = 0.055
TIGHT_COST_PER_M = 20.0
# Half a turn about the approach: signs of a rotation's columns.
_HALF_TURN = np.array([1.0, -1.0, -1.0])
# A grasp as it is, and rolled by that: what its name gets, and what it costs.
_ROLLED = ("", " rolled")
_ROLLED_COST = (0.0, 0.3)
# An object that stands is upright to within this; a lying one is grasped like a box.
UPRIGHT_COSINE = math.cos(math.radians(20))


@dataclass(frozen=True, slots=True)
class GraspCandidate:
    """A grasp with its preference: smaller cost first.

    Attributes:
        grasp: The grasp itself.
        cost: How far it is from the natural grasp of that hand; no unit.
    """

    grasp: Grasp
    cost: float


@dataclass(frozen=True, slots=True)
class GraspTable:
    """Candidate grasps of one hand as arrays, most natural first; ``candidate`` makes an object of a row.

    Attributes:
        hand: The hand.
        approach_m: Length of the straight approach.
        world_T_tcp: Where the TCP is, shape (n, 4, 4).
        diameter_m: Width of what is between the pads, shape (n,).
        cost: As of ``GraspCandidate``, shape (n,).
        off_centre_m: As of ``Grasp``, shape (n,); None where it is 0.
        label: What ``name`` makes the labels of: the first parts by yaw and kind, the index of the yaw and of
            the kind of each grasp, and the end of its label.
    """

    hand: Hand
    approach_m: float
    world_T_tcp: Array
    diameter_m: Array
    cost: Array
    label: tuple[tuple[tuple[str, ...], ...], NDArray[np.intp], NDArray[np.intp], Sequence[str]]
    off_centre_m: Array | None = None

    def __len__(self) -> int:
        return len(self.cost)

    def name(self, row: int) -> str:
        """Label of a grasp."""
        names, yaw, kind, suffix = self.label
        return names[int(yaw[row])][int(kind[row])] + suffix[row]

    def candidate(self, row: int) -> GraspCandidate:
        """One candidate."""
        grasp = Grasp(
            hand=self.hand,
            label=self.name(row),
            world_T_tcp=self.world_T_tcp[row],
            approach_m=self.approach_m,
            diameter_m=float(self.diameter_m[row]),
            off_centre_m=0.0 if self.off_centre_m is None else float(self.off_centre_m[row]),
        )
        return GraspCandidate(grasp, float(self.cost[row]))


def widest_between_pads_m(gripper: GripperDescription) -> float:
    """Width of what a gripper takes hold of at most, as far as perception can be trusted."""
    return gripper.max_opening_m - 2.0 * OPENING_RESERVE_M


def least_width_m(item: SceneObject) -> float:
    """Least distance between two opposite upright faces of an object: what is to fit between the pads."""
    if not isinstance(item.shape, Box):
        return 2.0 * item.shape.radius_m
    upright = int(np.argmax(np.abs(item.world_T_object[2, :3])))
    return float(min(size for axis, size in enumerate(item.shape.size_m) if axis != upright))


def least_depth_m(item: SceneObject, gripper: GripperDescription) -> float:
    """How deep along the fingers an upright box is where they open so far; infinite where they do not."""
    if not isinstance(item.shape, Box):
        return 2.0 * item.shape.radius_m
    upright = int(np.argmax(np.abs(item.world_T_object[2, :3])))
    one, other = (size for axis, size in enumerate(item.shape.size_m) if axis != upright)
    widest = widest_between_pads_m(gripper)
    return min((b for a, b in ((one, other), (other, one)) if a <= widest), default=math.inf)


def grasp_table(
    item: SceneObject,
    gripper: GripperDescription,
    natural_yaw_rad: float,
    approach_m: float,
    heights: Sequence[float] = (ABOVE_MIDDLE,),
    extra_cost: float = 0.0,
) -> GraspTable:
    """Candidates for one hand, most natural first.

    Args:
        item: What is to be grasped.
        gripper: The hand's gripper.
        natural_yaw_rad: Heading, in the world, in which this arm reaches that place most easily.
        approach_m: Length of the straight approach.
        heights: Where to grasp from the side: above the middle, as shares of the object's height.
        extra_cost: Of this hand, added to every candidate's.
    """
    # the arm prefers to come from its own outer side: the elbow stays off the trunk
    outward = 1.0 if gripper.hand == "right" else -1.0
    widest = widest_between_pads_m(gripper)
    kinds = tuple(
        (tilt, height)
        for tilt, height in product(TILTS_RAD, heights)
        # from above, palm and fingertips leave little choice of height
        if (height in (ABOVE_MIDDLE, NEAR_TOP) or tilt <= _STEEPEST_RAD)
        and tilt <= gripper.steepest_rad + _ROUNDING_RAD
    )
    headings = poses.rotations_z(natural_yaw_rad + outward * np.array(YAWS_RAD))
    leans = poses.rotations_y(np.array([tilt for tilt, _ in kinds]))
    # (yaw, kind, 3, 3)
    rotations = headings[:, None] @ leans
    if _is_round(item):
        placed = _round_places(rotations, [_round_spot(item, gripper, *kind, widest) for kind in kinds])
    else:
        placed = _box_places(item, gripper, rotations, kinds, widest)
    names, costs = _names(outward, kinds, _NATURAL_TILT_RAD if gripper.palm_side_m is None else 0.0)
    cost = np.array(costs)[placed.yaw, placed.kind] + placed.cost + extra_cost
    order = np.argsort(cost, kind="stable")
    suffix = [placed.suffix[row] for row in order]
    label = names, placed.yaw[order], placed.kind[order], suffix
    places, widths = placed.world_T_tcp[order], placed.diameter_m[order]
    if gripper.palm_side_m is None:
        return GraspTable(gripper.hand, approach_m, places, widths, cost[order], label)
    beside = np.array([gripper.grasped_at_m(width) for width in widths.tolist()])
    places[:, :3, 3] -= beside[:, None] * places[:, :3, 1]
    held = np.array([gripper.held_at_m(width) for width in widths.tolist()])
    return GraspTable(gripper.hand, approach_m, places, widths, cost[order], label, held)


@functools.lru_cache(maxsize=16)
def _names(
    outward: float, kinds: tuple[tuple[float, float], ...], natural_tilt_rad: float
) -> tuple[tuple[tuple[str, ...], ...], tuple[tuple[float, ...], ...]]:
    """Labels and costs by yaw and kind, before what a placement adds to them."""
    names = tuple(
        tuple(
            f"yaw {math.degrees(outward * yaw):+.0f} tilt {math.degrees(tilt):.0f}"
            + ("" if height == ABOVE_MIDDLE else f" at {0.5 + height:.2f}")
            for tilt, height in kinds
        )
        for yaw in YAWS_RAD
    )
    costs = tuple(
        tuple(abs(yaw - math.radians(10)) + 0.6 * abs(tilt - natural_tilt_rad) for tilt, _ in kinds)
        for yaw in YAWS_RAD
    )
    return names, costs


def key_of(hand: Hand, label: str) -> str:
    """How ``PickRequest.excluded`` names a grasp."""
    return f"{hand} {label}"


class _Places(NamedTuple):
    """Places of the TCP in rows, with the number of their yaw and of their kind; n rows each."""

    yaw: NDArray[np.intp]
    kind: NDArray[np.intp]
    world_T_tcp: Array
    diameter_m: Array
    suffix: Sequence[str]
    cost: Array


def _is_round(item: SceneObject) -> bool:
    """Whether a hand may come from any side alike: a ball, or a cylinder that stands."""
    if isinstance(item.shape, Cylinder):
        return bool(abs(item.world_T_object[2, 2]) >= UPRIGHT_COSINE)
    return isinstance(item.shape, Ball)


def _round_spot(
    item: SceneObject, gripper: GripperDescription, tilt: float, height: float, limit: float
) -> tuple[Array, float, float] | None:
    """Place of the TCP, opening and cost on something round, or None when it cannot be held so."""
    centre, shape = item.world_T_object[:3, 3], item.shape
    if isinstance(shape, Ball):
        over_m = _over_ball(shape.radius_m, tilt, height, gripper)
        if over_m is None or not gripper.pad_gap_m < 2.0 * shape.radius_m <= limit:
            return None
        return centre + np.array([0.0, 0.0, over_m]), _straddled_opening(shape.radius_m, gripper), 0.0
    if not isinstance(shape, Cylinder) or 2.0 * shape.radius_m > limit:
        return None
    over_m = _reach_in(shape.height_m, height, shape.radius_m, tilt, gripper)
    if over_m is None:
        return None
    place = centre + np.array([0.0, 0.0, over_m])
    if not _straddled(tilt, gripper):
        return place, 2.0 * shape.radius_m, 0.0
    if shape.radius_m > 0.5 * gripper.pad_gap_m:
        return place, _straddled_opening(shape.radius_m, gripper), STRADDLE_COST
    return None


def _box_places(
    item: SceneObject,
    gripper: GripperDescription,
    rotations: Array,
    kinds: Sequence[tuple[float, float]],
    limit: float,
) -> _Places:
    """Grasps of a box, or of a cylinder that lies: the opening is along one of the horizontal edges.

    Args:
        item: What is grasped.
        gripper: The hand's gripper.
        rotations: Wanted ones by yaw and kind, shape (yaws, kinds, 3, 3).
        kinds: Tilts and heights.
        limit: What is wider than this is not held, m.
    """
    if isinstance(item.shape, Box):
        size = item.shape.size_m
    else:
        size = 2.0 * item.shape.radius_m, 2.0 * item.shape.radius_m, item.shape.height_m
    axes = item.world_T_object[:3, :3]
    upward = int(np.argmax(np.abs(axes[2])))
    edges = [edge for edge in range(3) if edge != upward and size[edge] <= limit]
    yaws, count = len(rotations), len(kinds)
    # (yaw, kind, edge, roll)
    places = np.zeros((yaws, count, len(edges), 2, 4, 4))
    places[..., 3, 3] = 1.0
    cost = np.empty((yaws, count, len(edges), 2))
    held = np.ones((count, len(edges)), dtype=np.bool_)
    for k, edge in enumerate(edges):
        turned, turn = _parallel_to(axes[:, edge], rotations)
        half_depth = 0.5 * size[3 - edge - upward]
        depths = [_reach_in(size[upward], at, half_depth, tilt, gripper) for tilt, at in kinds]
        goes_around = 2.0 * half_depth <= gripper.around_m
        held[:, k] = [depth is not None and goes_around for depth in depths]
        places[:, :, k, :, :3, 3] = item.world_T_object[:3, 3]
        places[:, :, k, :, 2, 3] += np.array([depth or 0.0 for depth in depths])[:, None]
        places[:, :, k, 0, :3, :3], places[:, :, k, 1, :3, :3] = turned, turned * _HALF_TURN
        tight = TIGHT_COST_PER_M * max(0.0, size[edge] - ROOMY_M)
        cost[:, :, k] = np.abs(turn)[..., None] + np.array(_ROLLED_COST) + tight
    each = 2 * len(edges)
    every = _Places(
        yaw=np.repeat(np.arange(yaws), count * each),
        kind=np.tile(np.repeat(np.arange(count), each), yaws),
        world_T_tcp=places.reshape(-1, 4, 4),
        diameter_m=np.tile(np.repeat([size[edge] for edge in edges], 2), yaws * count),
        suffix=[f" edge {edge}{rolled}" for edge in edges for rolled in _ROLLED] * (yaws * count),
        cost=cost.ravel(),
    )
    if held.all():
        return every
    rows = np.flatnonzero(np.tile(np.repeat(held.ravel(), 2), yaws))
    yaw, kind, world_T_tcp, diameter_m, suffix, cost_of = every
    names = [suffix[row] for row in rows]
    return _Places(yaw[rows], kind[rows], world_T_tcp[rows], diameter_m[rows], names, cost_of[rows])


def _parallel_to(edge: Array, rotations: Array) -> tuple[Array, Array]:
    """Rotations, shape (yaws, kinds, 3, 3), turned so that the pads are parallel to the faces of an edge.

    Returns:
        They, and by how much they were turned about the vertical, shape (yaws, kinds), rad.
    """
    closing = rotations[..., :2, 1]
    across = np.where(closing @ edge[:2] < 0.0, -1.0, 1.0)[..., None] * edge[:2]
    turn = np.arctan2(across[..., 1], across[..., 0]) - np.arctan2(closing[..., 1], closing[..., 0])
    turn = (turn + math.pi) % (2.0 * math.pi) - math.pi
    return poses.rotations_z(turn.ravel()).reshape(rotations.shape) @ rotations, turn


def _reach_in(
    height: float, at: float, half_depth: float, tilt: float, gripper: GripperDescription
) -> float | None:
    """Height of the TCP above the object's middle; None where the palm keeps the pads off it.

    From the side at the wanted share ``at`` of the height, or where the hand usually does; from above as deep
    as palm and overlap want, measured along the approach; in between the blend by the tilt's sine.
    """
    usual = max(gripper.above_middle * height, gripper.side_gap_m - 0.5 * height)
    wanted = at * height if at >= 0.0 else max(at * height, gripper.side_gap_m - 0.5 * height)
    side = min(usual if at == ABOVE_MIDDLE else wanted, 0.5 * height - gripper.side_overlap_m)
    deepest = gripper.palm_distance_m - gripper.palm_gap_m
    least = gripper.pad_overlap_m
    overlap = max(least, min(0.45 * height, height - gripper.tip_gap_m))
    low = height - _foot_gap(tilt, at, gripper)
    if tilt > _STEEPEST_RAD and gripper.lowest_overlap_m <= low < least:
        overlap = low
    above = 0.5 * height - min(overlap, deepest)
    share = math.sin(tilt) ** 2
    blended = (1.0 - share) * side + share * above
    if tilt < math.radians(5):
        return blended if half_depth <= deepest else None
    # the tilted palm stays clear of the near edge of the top
    lowest = 0.5 * height - (deepest - half_depth * math.cos(tilt)) / math.sin(tilt)
    return max(blended, lowest) if lowest <= 0.5 * height - gripper.lowest_overlap_m else None


def _foot_gap(tilt: float, at: float, gripper: GripperDescription) -> float:
    """Least height of the TCP above the foot of something low that is grasped from above."""
    tilted = gripper.low_tilt_gap_m * math.cos(tilt)
    return gripper.low_tip_gap_m + tilted + (SHALLOWER_M if at == NEAR_TOP else 0.0)


def _over_ball(radius: float, tilt: float, height: float, gripper: GripperDescription) -> float | None:
    """Height of the TCP above a ball's middle, or None where its sides would be at the edge of the pads.

    From above the fingertips stay off what the ball lies on, and still reach below its middle.
    """
    if tilt <= _STEEPEST_RAD:
        return 0.0
    over_m = max(0.0, _foot_gap(tilt, height, gripper) - radius)
    return over_m if over_m <= gripper.over_ball_m else None


def _straddled(tilt: float, gripper: GripperDescription) -> bool:
    """Whether the line along which an upright cylinder touches a side passes between its pads."""
    return 0.5 * gripper.pad_gap_m * math.sin(tilt) > gripper.pad_half_size_m[0][2] * math.cos(tilt)


def _straddled_opening(radius: float, gripper: GripperDescription) -> float:
    """Opening on something round that sinks in between the pads of one side."""
    return radius + math.sqrt(radius**2 - (0.5 * gripper.pad_gap_m) ** 2)


def _round_places(rotations: Array, spots: Sequence[tuple[Array, float, float] | None]) -> _Places:
    """Places on something round; rotations by yaw and kind, shape (yaws, kinds, 3, 3), spots by kind."""
    usable = [(k, spot) for k, spot in enumerate(spots) if spot is not None]
    yaws, kinds = len(rotations), len(usable)
    # (yaw, kind, roll)
    places = np.zeros((yaws, kinds, 2, 4, 4))
    numbers = np.array([k for k, _ in usable], np.intp)
    turned = rotations[:, numbers]
    places[:, :, 0, :3, :3], places[:, :, 1, :3, :3] = turned, turned * _HALF_TURN
    places[..., 3, 3] = 1.0
    for at, (_, spot) in enumerate(usable):
        places[:, at, :, :3, 3] = spot[0]
    of_spots = [np.array([spot[1:] for _, spot in usable]).reshape(-1, 2)[:, part] for part in (0, 1)]
    cost = of_spots[1][:, None] + np.array(_ROLLED_COST)
    return _Places(
        yaw=np.repeat(np.arange(yaws), 2 * kinds),
        kind=np.tile(np.repeat(numbers, 2), yaws),
        world_T_tcp=places.reshape(-1, 4, 4),
        diameter_m=np.tile(np.repeat(of_spots[0], 2), yaws),
        suffix=_ROLLED * (yaws * kinds),
        cost=np.tile(cost.ravel(), yaws),
    )
