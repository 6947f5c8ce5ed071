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
    is no longer than it was, and where its top is seen tells where it is.

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
        estimate = _by_its_top(estimate, target)
        place = estimate.odom_T_object[:3, 3]
        distance = float(np.linalg.norm(place - expected))
        if any(float(np.linalg.norm(place - other)) < min(same_object_m, distance) for other in others):
            continue
        if best is None or distance < best[1]:
            best = estimate, distance
    return best


def _by_its_top(estimate: ObjectEstimate, target: Target) -> ObjectEstimate:
    """A sighting with the height that is known, and where its top is, if it seems to have grown."""
    grown_m = estimate.shape.height_m - target.shape.height_m
    if estimate.lying or grown_m < _GROWN_M or isinstance(estimate.shape, Ball):
        return estimate
    known_m = target.shape.height_m
    raised = poses.translation(0.0, 0.0, 0.5 * grown_m) @ estimate.odom_T_object
    if isinstance(estimate.shape, Box):
        x, y, _ = estimate.shape.size_m
        return replace(estimate, odom_T_object=raised, shape=Box((x, y, known_m)))
    return replace(estimate, odom_T_object=raised, shape=replace(estimate.shape, height_m=known_m))
