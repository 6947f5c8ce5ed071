"""Where the base is: estimated over soles, or known from its mount."""

from __future__ import annotations

from typing import Protocol

import numpy as np

from kinematics.arrays import Array
from kinematics.estimation.base_estimator import BaseEstimator
from kinematics.model.standing_robot import StandingRobot


class BaseEstimate(Protocol):
    """Gives whole configurations from the readings of a robot that stays where it is.

    Attributes:
        tilt_rad: How far the base is believed to be turned away from where its stance or its mount has it:
            rotation vector in the odometry frame's axes, shape (3,).
    """

    tilt_rad: Array

    def update(
        self,
        stamp_s: float,
        joints_rad: Array,
        gyro_rad_s: Array,
        accelerometer_m_s2: Array,
        foot_wrench: Array,
    ) -> None:
        """Take one set of readings; see ``BaseEstimator``."""
        ...

    def configuration(self, joints_rad: Array, foot_wrench: Array, tilt_rad: Array) -> Array:
        """Whole configuration from one set of readings, a fresh array, shape (nq,)."""
        ...


class MountedBase:
    """The base of a welded robot is at its mount, whatever is sensed."""

    def __init__(self, robot: StandingRobot) -> None:
        """Note where the mount is in the odometry frame."""
        self._at = robot.model.q_home[:7].copy()
        self.tilt_rad = np.zeros(3)

    def update(
        self,
        stamp_s: float,
        joints_rad: Array,
        gyro_rad_s: Array,
        accelerometer_m_s2: Array,
        foot_wrench: Array,
    ) -> None:
        """Bolts need no filter."""

    def configuration(
        self,
        joints_rad: Array,
        foot_wrench: Array,  # noqa: ARG002
        tilt_rad: Array,  # noqa: ARG002
    ) -> Array:
        """The mount with the joints as they are read, a fresh array, shape (nq,)."""
        return np.concatenate([self._at, joints_rad])


def base_estimate(robot: StandingRobot) -> BaseEstimate:
    """What tells where the base of a robot is, by what holds it up.

    Raises:
        KinematicsError: It is not welded, and stands on no sole.
    """
    return MountedBase(robot) if robot.model.description.welded else BaseEstimator(robot)
