"""What stands on a top touches it: every such object is one more measurement of the top's height.

Each thing is seen with an error of its own, so that a cup seems to float over its table or to be sunk
in it. The mean of all heights at which one top is touched is nearer to the truth than each (the error
falls with the square root of their number), and objects then stand where they are believed to stand.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from kinematics.geometry.shapes import Ball, Box
from robots.perception.fusion.gaussian import Gaussian, Innovation, Measurement
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
    for i, feet in _standing(estimates, tops, gap_m).items():
        agreed = float(np.mean([tops[i], *feet.values()]))
        moved[i] = _raised(estimates[i], agreed - tops[i])
        for j, foot in feet.items():
            moved[j] = _raised(estimates[j], agreed - foot)
    return moved


def seen_to_float(estimates: Sequence[ObjectEstimate], gap_m: float = GAP_M) -> list[tuple[int, Innovation]]:
    """Compare each top's height with the feet of what stands on it.

    Args:
        estimates: In the odometry frame, z up.
        gap_m: As of ``standing_on_tops``.

    Returns:
        The index of each top on which something stands, with by how much the feet are above it. Estimates
        that declare no error are left out.
    """
    tops = {i: _top_m(item) for i, item in enumerate(estimates) if _is_top(item) and item.error is not None}
    found = []
    for i, feet in _standing(estimates, tops, gap_m).items():
        told = [(foot, _height_variance(estimates[j])) for j, foot in feet.items()]
        told = [(foot, variance) for foot, variance in told if variance > 0.0]
        if not told:
            continue
        feet_at = Gaussian(np.array([told[0][0]]), np.array([[told[0][1]]]))
        for foot, variance in told[1:]:
            feet_at = feet_at.updated(_height("camera", foot, variance))
        top = _height("camera", tops[i], _height_variance(estimates[i]))
        innovation = feet_at.innovation(top)
        found.append((i, replace(innovation, difference=-innovation.difference)))
    return found


def _height(source: str, at_m: float, variance_m2: float) -> Measurement:
    return Measurement(source, 0.0, np.array([at_m]), np.array([[variance_m2]]), np.eye(1))


def _height_variance(item: ObjectEstimate) -> float:
    """Of an estimate's upper or lower end, beside others of the same camera; 0 when it declares no error."""
    if item.error is None:
        return 0.0
    shape = item.shape
    half_m = shape.radius_m if isinstance(shape, Ball) else 0.5 * shape.height_m
    return float(item.error.own_m2[2, 2]) + (item.error.size_share * half_m) ** 2


def _standing(
    estimates: Sequence[ObjectEstimate], tops: Mapping[int, float], gap_m: float
) -> dict[int, dict[int, float]]:
    """By the index of each top, the feet on it by the index of what stands there."""
    on: dict[int, dict[int, float]] = {i: {} for i in tops}
    for j, item in enumerate(estimates):
        foot = _foot_m(item)
        if foot is None:
            continue
        near = [i for i, top in tops.items() if abs(foot - top) <= gap_m and _over(estimates[i], item)]
        if near:  # a board lies over the cupboard below it, whose top is as near
            on[max(near, key=tops.__getitem__)][j] = foot
    return on


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
