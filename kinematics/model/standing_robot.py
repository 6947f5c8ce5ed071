"""A robot where it stands: its model and its stance as one value, and what follows from both."""

from __future__ import annotations

from collections.abc import Hashable
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from kinematics.arrays import Array, sealed
from kinematics.errors import KinematicsError
from kinematics.geometry import poses
from kinematics.model.derived import Derivable, Recent
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import Stance
from kinematics.model.support_polygon import SupportPolygon

_LEVEL = 1.0 - 1e-9
"""Cosine of what counts as level."""
_KEPT = 16
"""Stances of one robot."""


@dataclass(frozen=True, slots=True, eq=False)
class StandingRobot(Derivable):
    """A robot on planted soles, or on its mount.

    Whoever makes something that follows from model and stance alone (free coordinates, legs, solvers,
    tables) keeps it here, see ``derived``; ``of`` returns the same value for the same stance, with all
    that was made of it.

    Attributes:
        model: The robot, with what it carries.
        stance: Where its soles stand; without soles when it is welded.
    """

    model: RobotModel
    stance: Stance
    _derived: dict[Hashable, Any] = field(init=False, repr=False, default_factory=dict)

    @classmethod
    def of(cls, model: RobotModel, stance: Stance) -> StandingRobot:
        """The value of a model on a stance that is equal to the bit; the model keeps the last ones."""
        return model.derived(_lately).of(stance.key, lambda: cls(model, stance))

    @property
    def polygon(self) -> SupportPolygon:
        """What the CoM may stand over.

        Raises:
            UnknownNameError: The stance names a sole that the robot does not have.
            KinematicsError: The robot has soles, and none of them carries.
        """
        return self.derived(_polygon)

    @property
    def q_home(self) -> Array:
        """The home posture with its soles at the stance, a copy of shape (nq,).

        That of a welded robot is where it is mounted.
        """
        return self.derived(_home).copy()

    def placed(self, q: Array) -> Array:
        """Configuration with the same joints and the base where the soles put it, shape (nq,).

        Soles that disagree, because the joints do not keep their distance exactly, are averaged. A welded
        base is where it is mounted.

        Raises:
            KinematicsError: The stance has no sole, and the base is not welded.
            UnknownNameError: A sole's frame is not in the model.
        """
        model, soles = self.model, self.stance.soles
        if model.description.welded:
            return np.concatenate([model.q_home[:7], q[7:]])
        if not soles:
            raise KinematicsError("a stance without soles puts the base nowhere")
        at_origin = q.copy()
        at_origin[:7] = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0)
        found = model.frame_poses(at_origin, [frame for frame, _ in soles])
        bases = [
            world_T_sole @ poses.inverse(base_T_sole)
            for (_, world_T_sole), base_T_sole in zip(soles, found, strict=True)
        ]
        base = bases[0]
        for k, other in enumerate(bases[1:], start=2):
            base = poses.interpolate(base, other, 1.0 / k)
        at_origin[:3] = base[:3, 3]
        at_origin[3:7] = poses.quaternion_from_rotation(base[:3, :3])
        return at_origin


def _lately(_model: RobotModel) -> Recent[Hashable, StandingRobot]:
    """Where one robot stood lately: it stands in few places at a time."""
    return Recent(_KEPT)


def _polygon(robot: StandingRobot) -> SupportPolygon:
    return SupportPolygon(robot.stance, robot.model.description.soles)


def _home(robot: StandingRobot) -> Array:
    model = robot.model
    if model.description.welded:
        return sealed(model.q_home)
    soles = [world_T_sole for _, world_T_sole in robot.stance.soles]
    middle = poses.interpolate(soles[0], soles[-1], 0.5)
    if middle[2, 2] < _LEVEL:  # soles lie on what they stand on, the body stands upright all the same
        middle = poses.transform(poses.rotation_z(poses.yaw_of(middle[:3, :3])), middle[:3, 3])
    base = poses.transform(poses.rotation_from_quaternion(model.q_home[3:7]), model.q_home[:3])
    return sealed(model.configuration({}, middle @ base))
