"""What stands on a top touches it: every such object is one more measurement of the top's height.

Each thing is seen with an error of its own, so that a cup seems to float over its table or to be sunk
in it. The mean of all heights at which one top is touched is nearer to the truth than each (the error
falls with the square root of their number), and objects then stand where they are believed to stand.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from kinematics.geometry.shapes import Ball, Box
from robots.perception.object_estimate import ObjectEstimate

# Four standard deviations of the difference of two heights, each wrong by 5 mm.
GAP_M = 0.03


def standing_on_tops(estimates: Sequence[ObjectEstimate], gap_m: float = GAP_M) -> list[ObjectEstimate]:
    """Give tops and what stands on them the height that they agree on.

    Args:
        estimates: In the odometry frame, z up; the order is kept.
        gap_m: Most that an object may seem to float, or to be sunk in.

    Returns:
        The same estimates; those of a top and of upright objects on it are moved vertically.
    """
    moved = list(estimates)
    tops = {i: _top_m(item) for i, item in enumerate(estimates) if _is_top(item)}
    on: dict[int, dict[int, float]] = {i: {} for i in tops}
    for j, item in enumerate(estimates):
        foot = _foot_m(item)
        if foot is None:
            continue
        near = [i for i, top in tops.items() if abs(foot - top) <= gap_m and _over(estimates[i], item)]
        if near:  # a board lies over the cupboard below it, whose top is as near
            on[max(near, key=tops.__getitem__)][j] = foot
    for i, feet in on.items():
        agreed = float(np.mean([tops[i], *feet.values()]))
        moved[i] = _raised(estimates[i], agreed - tops[i])
        for j, foot in feet.items():
            moved[j] = _raised(estimates[j], agreed - foot)
    return moved


def _is_top(item: ObjectEstimate) -> bool:
    return item.category == "furniture" and isinstance(item.shape, Box)


def _top_m(item: ObjectEstimate) -> float:
    half_m = 0.5 * item.shape.height_m if isinstance(item.shape, Box) else 0.0
    return float(item.odom_T_object[2, 3]) + half_m


def _foot_m(item: ObjectEstimate) -> float | None:
    """Height of an upright object's foot; None for furniture, people and what lies."""
    if item.category != "object" or item.lying:
        return None
    shape = item.shape
    height_m = 2.0 * shape.radius_m if isinstance(shape, Ball) else shape.height_m
    return float(item.odom_T_object[2, 3]) - 0.5 * height_m


def _over(top: ObjectEstimate, item: ObjectEstimate) -> bool:
    local = top.odom_T_object[:3, :3].T @ (item.odom_T_object[:3, 3] - top.odom_T_object[:3, 3])
    half = 0.5 * np.array(top.shape.size_m[:2]) if isinstance(top.shape, Box) else np.zeros(2)
    return bool(np.all(np.abs(local[:2]) <= half + GAP_M))


def _raised(item: ObjectEstimate, by_m: float) -> ObjectEstimate:
    pose = item.odom_T_object.copy()
    pose[2, 3] += by_m
    return replace(item, odom_T_object=pose)
