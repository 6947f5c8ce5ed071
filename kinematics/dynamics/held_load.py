"""What hangs on a robot's hands, as part of its model."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from kinematics.model.derived import Recent
from kinematics.model.robot_model import RobotModel
from kinematics.motion.trajectory import HeldLoad
from kinematics.scene.planning_scene import PlanningScene

_KEPT = 8
"""Loads of one robot."""


def loads_in(scene: PlanningScene) -> tuple[HeldLoad, ...]:
    """The loads of a scene: each attached body whose mass is known, at its centre."""
    if not scene.attached:
        return ()
    return tuple(
        HeldLoad(
            body.frame,
            body.mass_kg,
            (
                float(body.frame_T_object[0, 3]),
                float(body.frame_T_object[1, 3]),
                float(body.frame_T_object[2, 3]),
            ),
        )
        for body in scene.attached.values()
        if body.mass_kg > 0.0
    )


def loaded(model: RobotModel, loads: Sequence[HeldLoad]) -> RobotModel:
    """The same robot with loads: its CoM, its mass and its dynamics are those of both.

    Args:
        model: The robot with empty hands.
        loads: What it carries; without any it is the model itself.

    Raises:
        UnknownNameError: A load hangs on a frame that the model does not have.
    """
    return model.derived(_lately).of(tuple(loads), lambda: _loaded(model, loads)) if loads else model


def _lately(_model: RobotModel) -> Recent[tuple[HeldLoad, ...], RobotModel]:
    """What a robot carried lately: planner and checker ask for the same one many times."""
    return Recent(_KEPT)


def _loaded(model: RobotModel, loads: Sequence[HeldLoad]) -> RobotModel:
    return model.with_point_masses([(load.frame, load.mass_kg, np.array(load.point_m)) for load in loads])
