"""Where the base is: from encoders, the soles that carry, and the IMU.

Frames: ``odom`` has its origin on the floor between the soles at the start, x ahead, z up.

With flat soles the encoders alone give the base. What they cannot see is a foot that tips on its
edge or sinks in, so the tilt comes from a complementary filter: the gyro for what is fast, the
legs' kinematics for what is slow, and the accelerometer, as far as its bias lets one trust it, for
what stays. Heading cannot be had from gravity; it follows the stance feet.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from kinematics.errors import KinematicsError
from kinematics.robot_model import RobotModel
from kinematics.trajectory import Stance

Array = NDArray[np.float64]

_GRAVITY_M_S2 = 9.81


@dataclass(frozen=True, slots=True)
class EstimatorSettings:
    """Time constants, shares and thresholds.

    Attributes:
        kinematics_time_s: The tilt returns to the flat-soled one with this time constant. A gyro
            bias leaves an error of bias times this; a tip of the foot is seen for about as long.
        gravity_time_s: The accelerometer's tilt is averaged over this: 0.02 m/s^2 of white noise
            at 500 Hz become 0.1 mrad.
        gravity_share: How much of the averaged accelerometer tilt is believed while a sole carries:
            the variance of the flat-sole assumption (1 mrad) over the sum with that of an
            accelerometer's bias (2 mrad). With no sole carrying it is believed fully.
        gravity_band_m_s2: Specific force may differ by this from 1 g and still be taken for gravity.
        carrying_force_n: A sole with less normal force than this carries nothing.
    """

    kinematics_time_s: float = 0.3
    gravity_time_s: float = 1.0
    gravity_share: float = 0.2
    gravity_band_m_s2: float = 0.5
    carrying_force_n: float = 30.0


class BaseEstimator:
    """Estimates the base pose in the odometry frame, one update a control period.

    Attributes:
        carrying: Which soles of the stance carried in the last update, in its order.
        tilt_rad: How far the base is believed to be turned away from its flat-soled pose: rotation
            vector in the odometry frame's axes, shape (3,).
        gravity_tilt_rad: The same as the averaged accelerometer sees it (its z is always 0).
    """

    def __init__(self, model: RobotModel, stance: Stance, settings: EstimatorSettings | None = None) -> None:
        """Begin with the soles at a known stance.

        Args:
            model: The robot.
            stance: Where its soles stand in the odometry frame.
            settings: Time constants; the defaults suit a position-controlled biped.

        Raises:
            KinematicsError: The stance has no sole.
        """
        if not stance.soles:
            raise KinematicsError("the base cannot be estimated without a sole on the floor")
        self._settings = settings or EstimatorSettings()
        self._model = model.pin
        self._data = model.pin.createData()
        described = [sole.frame for sole in model.description.soles]
        self._wrench_rows = [described.index(frame) for frame, _ in stance.soles]
        self._sole_ids = [model.frame_id(frame) for frame, _ in stance.soles]
        self._anchors = [pin.SE3(pose) for _, pose in stance.soles]
        self._imu_id = model.frame_id(model.description.imu_link)
        self._q = pin.neutral(model.pin)
        self._last: tuple[float, Array] | None = None
        self.carrying = [True] * len(stance.soles)
        self.tilt_rad = np.zeros(3)
        self.gravity_tilt_rad = np.zeros(3)

    def update(
        self,
        stamp_s: float,
        joints_rad: Array,
        gyro_rad_s: Array,
        accelerometer_m_s2: Array,
        foot_wrench: Array,
    ) -> Array:
        """Take one set of readings and return the estimated configuration, a fresh array, shape (nq,).

        Args:
            stamp_s: Time of the readings.
            joints_rad: Body joints in the order of ``q[7:]``, shape (n,).
            gyro_rad_s: Angular velocity in the IMU's frame, shape (3,).
            accelerometer_m_s2: Specific force in the IMU's frame, shape (3,).
            foot_wrench: Force and torque on each of the robot's soles, sole frame, shape (feet, 6).
        """
        # The base stays at the identity in here, so that frames come out in the base's own frame.
        q = self._q
        q[7:] = joints_rad
        pin.forwardKinematics(self._model, self._data, q)
        base_T_soles = [pin.updateFramePlacement(self._model, self._data, i) for i in self._sole_ids]
        base_R_imu = pin.updateFramePlacement(self._model, self._data, self._imu_id).rotation
        weights = self._weights(foot_wrench)
        flat_soled, pivot = self._flat_soled(weights, base_T_soles)
        self._advance_tilt(stamp_s, flat_soled.rotation @ base_R_imu, gyro_rad_s, accelerometer_m_s2)
        # The soles tip where they carry, and take the base with them.
        tip = pin.exp3(self.tilt_rad)
        odom_T_base = pin.SE3(tip, pivot - tip @ pivot) * flat_soled
        estimate: Array = q.copy()
        estimate[:7] = pin.SE3ToXYZQUAT(odom_T_base)
        return estimate

    def _flat_soled(self, weights: list[float], base_T_soles: list[pin.SE3]) -> tuple[pin.SE3, Array]:
        """Where the base would be with flat soles, and the point between the soles that carries.

        Soles that disagree (by the encoders' noise) are blended by weight.
        """
        base: pin.SE3 | None = None
        pivot = np.zeros(3)
        taken = 0.0
        for weight, anchor, base_T_sole in zip(weights, self._anchors, base_T_soles, strict=True):
            if weight <= 0.0:
                continue
            taken += weight
            pivot += weight * anchor.translation
            candidate = anchor * base_T_sole.inverse()
            base = candidate if base is None else pin.SE3.Interpolate(base, candidate, weight / taken)
        return base, pivot

    def _weights(self, foot_wrench: Array) -> list[float]:
        """Share of each sole in the answer: by normal force; all alike when none is felt."""
        forces = foot_wrench[:, 2].tolist()
        least = self._settings.carrying_force_n
        loads = [forces[row] if forces[row] >= least else 0.0 for row in self._wrench_rows]
        self.carrying = [load > 0.0 for load in loads]
        total = sum(loads)
        if total <= 0.0:
            return [1.0 / len(loads)] * len(loads)
        return [load / total for load in loads]

    def _advance_tilt(
        self, stamp_s: float, odom_R_imu: Array, gyro_rad_s: Array, accelerometer_m_s2: Array
    ) -> None:
        """Advance the tilt; ``odom_R_imu`` is where the IMU would be if the soles were flat."""
        last, self._last = self._last, (stamp_s, odom_R_imu)
        if last is None or stamp_s <= last[0]:
            return
        settings = self._settings
        dt = stamp_s - last[0]
        force = odom_R_imu @ accelerometer_m_s2
        fx, fy, fz = force.tolist()
        if abs(math.sqrt(fx * fx + fy * fy + fz * fz) - _GRAVITY_M_S2) < settings.gravity_band_m_s2:
            # The specific force points up; where the flat-soled pose shows it leaning, the base leans back.
            seen = np.array([fy, -fx, 0.0]) / _GRAVITY_M_S2
            self.gravity_tilt_rad = self.gravity_tilt_rad + min(1.0, dt / settings.gravity_time_s) * (
                seen - self.gravity_tilt_rad
            )
        # What the gyro felt beyond the turn that the joints explain is a turn of the soles.
        unexplained = odom_R_imu @ (gyro_rad_s * dt - pin.log3(last[1].T @ odom_R_imu))
        share = settings.gravity_share if any(self.carrying) else 1.0
        tilt = self.tilt_rad + unexplained
        returning = min(1.0, dt / settings.kinematics_time_s)
        self.tilt_rad = tilt + returning * (share * self.gravity_tilt_rad - tilt)
