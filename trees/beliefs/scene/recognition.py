"""Find one known object among what a look saw."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from kinematics.geometry import poses
from kinematics.geometry.shapes import Ball, Box
from kinematics.scene.planning_scene import PlanningScene
from robots.perception.object_estimate import ObjectEstimate
from trees.beliefs.scene.scene_update import kind_of, words_for
from trees.port_values import Target

_GROWN_M = 0.03
"""Looks of one thing differ by less in its height."""


def nearest_sighting(
    target: Target,
    expected: NDArray[np.float64],
    estimates: Iterable[ObjectEstimate],
    scene: PlanningScene,
    same_object_m: float,
) -> tuple[ObjectEstimate, float] | None:
    """The sighting of the target nearest to where it is expected, and its distance from there in m.

    What is seen to be higher than the target is known to be has its foot out of sight, behind something: it
    is no longer than it was, and where its top is seen tells where it is. Of what is lower a part is hidden,
    by fingers or by the picture's edge.

    A sighting has the target's kind, colour (or no colour) and name (or no name), and is not where
    another object of the same words is known to be.

    Args:
        target: What to look for.
        expected: Where it should be, shape (3,).
        estimates: What was seen.
        scene: What is known of the others.
        same_object_m: Two sightings nearer than this are one object.
    """
    others = [
        item.world_T_object[:3, 3]
        for name, item in scene.objects.items()
        if name != target.name and kind_of(name) == kind_of(target.name)
    ]
    best: tuple[ObjectEstimate, float] | None = None
    for estimate in estimates:
        if not estimate.may_be(target.kind, target.color):
            continue
        if estimate.names and words_for(estimate) != kind_of(target.name):
            continue
        estimate = _as_known(estimate, target, float(expected[2]))
        place = estimate.odom_T_object[:3, 3]
        distance = float(np.linalg.norm(place - expected))
        if any(float(np.linalg.norm(place - other)) < min(same_object_m, distance) for other in others):
            continue
        if best is None or distance < best[1]:
            best = estimate, distance
    return best


def _as_known(estimate: ObjectEstimate, target: Target, expected_z_m: float) -> ObjectEstimate:
    """A sighting with the height that is known.

    One that has grown is where its top is. Of one that is shorter a part is hidden, above or below: it is
    where it is expected, as far as what is seen can be a part of it there.
    """
    shape, known_m = estimate.shape, target.shape.height_m
    grown_m = shape.height_m - known_m
    if estimate.lying or isinstance(shape, Ball) or abs(grown_m) < _GROWN_M:
        return estimate
    half_m = 0.5 * abs(grown_m)
    off_m = expected_z_m - float(estimate.odom_T_object[2, 3])
    up_m = half_m if grown_m > 0.0 else min(max(off_m, -half_m), half_m)
    moved = poses.translation(0.0, 0.0, up_m) @ estimate.odom_T_object
    if isinstance(shape, Box):
        x, y, _ = shape.size_m
        return replace(estimate, odom_T_object=moved, shape=Box((x, y, known_m)))
    return replace(estimate, odom_T_object=moved, shape=replace(shape, height_m=known_m))
