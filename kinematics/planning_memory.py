"""Pinocchio's working memory for planning: for one thread, on any stance, never for the checker."""

from __future__ import annotations

import functools

import pinocchio as pin

from kinematics.robot_model import RobotModel


@functools.lru_cache(maxsize=4)
def planning_memory(model: RobotModel) -> pin.Data:
    """The memory of a model; to make it takes as long as thirty evaluations with it."""
    return model.pin.createData()
