"""A wider berth of things that may stand elsewhere than they were seen.

Margins are what a plan must keep where there is little room: 10 mm, which the error of a look (5 mm of bias
each way) exceeds once in seven things. Where there is room, nothing is lost by keeping twice as much.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from kinematics.collision.relaxed_start import relaxed_at
from kinematics.model.robot_model import RobotModel
from kinematics.scene.planning_scene import PlanningScene

BERTH_M = 0.01
"""Beside the margin: 20 mm in all are exceeded once in 3,000."""


def widened(scene: PlanningScene, by_m: float) -> PlanningScene:
    """The scene with wider margins of its movable things; the same one when there are none."""
    items = scene.objects.values()
    if not any(item.movable for item in items):
        return scene
    return scene.with_objects(
        replace(item, margin_m=item.margin_m + by_m) if item.movable else item for item in items
    )


def wide_berth(
    model: RobotModel, scene: PlanningScene, q: NDArray[np.float64], reserve_m: float
) -> PlanningScene:
    """Widen the margins of movable things, as far as a configuration keeps them.

    Args:
        model: The robot.
        scene: What is around, as ``q`` is free in it.
        q: Where the robot is, shape (nq,).
        reserve_m: What the caller adds to every margin.

    Returns:
        A scene in which no margin is narrower; for planning alone, and never to be judged by.
    """
    wide = widened(scene, BERTH_M)
    if wide is scene:
        return scene
    kept = relaxed_at(model, wide, q, reserve_m).objects
    return scene.with_objects(
        replace(item, margin_m=max(item.margin_m, kept[item.name].margin_m))
        for item in scene.objects.values()
    )
