"""Find one known object among what a look saw."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from kinematics.scene.planning_scene import PlanningScene
from robots.perception.object_estimate import ObjectEstimate
from trees.beliefs.scene.scene_update import kind_of, words_for
from trees.port_values import Target


def nearest_sighting(
    target: Target,
    expected: NDArray[np.float64],
    estimates: Iterable[ObjectEstimate],
    scene: PlanningScene,
    same_object_m: float,
) -> tuple[ObjectEstimate, float] | None:
    """The sighting of the target nearest to where it is expected, and its distance from there in m.

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
        if estimate.category != "object" or estimate.kind != target.kind:
            continue
        if estimate.color is not None and estimate.color != target.color:
            continue
        if estimate.names and words_for(estimate) != kind_of(target.name):
            continue
        place = estimate.odom_T_object[:3, 3]
        distance = float(np.linalg.norm(place - expected))
        if any(float(np.linalg.norm(place - other)) < min(same_object_m, distance) for other in others):
            continue
        if best is None or distance < best[1]:
            best = estimate, distance
    return best
