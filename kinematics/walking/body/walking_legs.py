"""The legs of a robot that walks: in closed form where they have one, else by Newton's method."""

from __future__ import annotations

from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import Stance
from kinematics.model.standing_robot import StandingRobot
from kinematics.standing.leg_ik import LegIk
from kinematics.walking.body.hinged_legs import fill_hinged_legs
from kinematics.walking.body.legs import fill_legs


class WalkingLegs(Protocol):
    """Places the leg joints of one configuration over feet that move.

    Attributes:
        columns: Where each leg's joints are in a configuration, hip to ankle, shape (legs, 6).
        joints: Pinocchio's ids of the same.
    """

    columns: NDArray[np.intp]
    joints: list[tuple[int, ...]]

    def fill(self, q: Array, base_R: Array, feet: Array) -> bool:
        """Write the leg joints; tell whether every foot is within reach.

        Args:
            q: Configuration, shape (nq,); of legs without a closed form that of a moment ago.
            base_R: Orientation of the base, shape (3, 3).
            feet: x, y, height and heading of each sole, shape (legs, 4).
        """
        ...


def walking_legs(model: RobotModel) -> WalkingLegs:
    """The legs of a robot, left first.

    Raises:
        ModelError: A leg is not a chain of six hinges.
    """
    flat = tuple((sole.frame, np.eye(4)) for sole in model.description.soles)
    legs = LegIk(StandingRobot(model, Stance(flat)))
    return _ClosedLegs(model, legs) if legs.closed else _HingedLegs(model, legs)


class _ClosedLegs:
    def __init__(self, model: RobotModel, legs: LegIk) -> None:
        geometry = legs.geometry
        self.joints = [leg.joints for leg in geometry]
        self.columns = _columns(model, self.joints)
        self._hip = np.array([leg.hip_m for leg in geometry])
        self._bones = np.array([[leg.thigh_m, leg.shin_m] for leg in geometry])
        self._sole_R_ankle = np.array([leg.foot_R for leg in geometry])
        self._sole_p_ankle = np.array([leg.ankle_m for leg in geometry])

    def fill(self, q: Array, base_R: Array, feet: Array) -> bool:
        return bool(
            fill_legs(
                q,
                base_R,
                feet,
                self._hip,
                self._bones,
                self._sole_R_ankle,
                self._sole_p_ankle,
                self.columns,
            )
        )


class _HingedLegs:
    def __init__(self, model: RobotModel, legs: LegIk) -> None:
        chains = legs.chains
        self.joints = [chain.joints for chain in chains]
        self.columns = _columns(model, self.joints)
        self._turns = np.array([chain.turns for chain in chains])
        self._offsets = np.array([chain.offsets_m for chain in chains])
        self._axes = np.array([chain.axes for chain in chains])
        self._foot_R_sole = np.array([chain.foot_T_sole[:3, :3] for chain in chains])
        self._foot_p_sole = np.array([chain.foot_T_sole[:3, 3] for chain in chains])

    def fill(self, q: Array, base_R: Array, feet: Array) -> bool:
        return bool(
            fill_hinged_legs(
                q,
                base_R,
                feet,
                self._turns,
                self._offsets,
                self._axes,
                self._foot_R_sole,
                self._foot_p_sole,
                self.columns,
            )
        )


def _columns(model: RobotModel, joints: list[tuple[int, ...]]) -> NDArray[np.intp]:
    return np.array([[int(model.pin.joints[j].idx_q) for j in leg] for leg in joints], dtype=np.intp)
