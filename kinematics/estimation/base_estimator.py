"""Where the base is: from encoders, the soles that carry, and the IMU.

Frames: ``odom`` has its origin on the floor between the soles at the start, x ahead, z up.

With flat soles the encoders alone give the base. What they cannot see is a foot that tips on its
edge or sinks in, so the tilt comes from a complementary filter: the gyro for what is fast, the
legs' kinematics for what is slow, and the accelerometer, as far as its bias lets one trust it, for
what stays. Heading cannot be had from gravity; it follows the stance feet.

The tilt changes slowly against a control period, so the filter takes its readings in batches; the
pose itself follows from one set of readings and the tilt of its time, whenever somebody asks.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import pinocchio as pin

from kinematics.arrays import Array
from kinematics.errors import KinematicsError
from kinematics.model.standing_robot import StandingRobot

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
        batch: Readings of the IMU that are averaged for one step of the filter: at 500 Hz, 3 make
            167 Hz. The tilt is late by up to ``batch - 1`` readings.
    """

    kinematics_time_s: float = 0.3
    gravity_time_s: float = 1.0
    gravity_share: float = 0.2
    gravity_band_m_s2: float = 0.5
    carrying_force_n: float = 30.0
    batch: int = 3


class BaseEstimator:
    """Estimates the base pose in the odometry frame.

    Attributes:
        carrying: Which soles of the stance carried in the last step of the filter, in its order.
        tilt_rad: How far the base is believed to be turned away from its flat-soled pose: rotation
            vector in the odometry frame's axes, shape (3,). Replaced, never changed in place.
        gravity_tilt_rad: The same as the averaged accelerometer sees it (its z is always 0).
    """

    def __init__(self, robot: StandingRobot, settings: EstimatorSettings | None = None) -> None:
        """Begin with the soles at a known stance.

        Args:
            robot: Where it stands in the odometry frame.
            settings: Time constants; the defaults suit a position-controlled biped.

        Raises:
            KinematicsError: The stance has no sole.
        """
        model, stance = robot.model, robot.stance
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
        self._last: tuple[float, pin.SE3] | None = None
        self._gyro_sum, self._accelerometer_sum, self._summed = np.zeros(3), np.zeros(3), 0
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
    ) -> None:
        """Take one set of readings; the filter makes a step when its batch is full.

        Args:
            stamp_s: Time of the readings.
            joints_rad: Body joints in the order of ``q[7:]``, shape (n,).
            gyro_rad_s: Angular velocity in the IMU's frame, shape (3,).
            accelerometer_m_s2: Specific force in the IMU's frame, shape (3,).
            foot_wrench: Force and torque on each of the robot's soles, sole frame, shape (feet, 6).
        """
        self._gyro_sum += gyro_rad_s
        self._accelerometer_sum += accelerometer_m_s2
        self._summed += 1
        if self._last is not None and self._summed < self._settings.batch:
            return
        loads = self._loads(foot_wrench)
        self.carrying = [load > 0.0 for load in loads]
        flat_soled = self._flat_soled(_shares(loads), self._soles(joints_rad))
        base_T_imu = pin.updateFramePlacement(self._model, self._data, self._imu_id)
        self._step(stamp_s, flat_soled * base_T_imu)
        self._gyro_sum[:] = 0.0
        self._accelerometer_sum[:] = 0.0
        self._summed = 0

    def configuration(self, joints_rad: Array, foot_wrench: Array, tilt_rad: Array) -> Array:
        """Whole configuration from one set of readings, a fresh array, shape (nq,).

        Args:
            joints_rad: Body joints in the order of ``q[7:]``, shape (n,).
            foot_wrench: Force and torque on each of the robot's soles, sole frame, shape (feet, 6).
            tilt_rad: ``tilt_rad`` as it was at the time of the readings, shape (3,).
        """
        weights = _shares(self._loads(foot_wrench))
        flat_soled = self._flat_soled(weights, self._soles(joints_rad))
        # The soles tip where they carry, and take the base with them.
        pairs = zip(weights, self._anchors, strict=True)
        pivot = sum((weight * anchor.translation for weight, anchor in pairs), start=np.zeros(3))
        tip = pin.exp3(tilt_rad)
        odom_T_base = pin.SE3(tip, pivot - tip @ pivot) * flat_soled
        estimate: Array = self._q.copy()
        estimate[:7] = pin.SE3ToXYZQUAT(odom_T_base)
        return estimate

    def _soles(self, joints_rad: Array) -> list[pin.SE3]:
        # The base stays at the identity in here, so that frames come out in the base's own frame.
        self._q[7:] = joints_rad
        pin.forwardKinematics(self._model, self._data, self._q)
        return [pin.updateFramePlacement(self._model, self._data, i) for i in self._sole_ids]

    def _flat_soled(self, weights: list[float], base_T_soles: list[pin.SE3]) -> pin.SE3:
        """Where the base would be with flat soles.

        Soles that disagree (by the encoders' noise) are blended by weight.
        """
        base: pin.SE3 | None = None
        taken = 0.0
        for weight, anchor, base_T_sole in zip(weights, self._anchors, base_T_soles, strict=True):
            if weight <= 0.0:
                continue
            taken += weight
            candidate = anchor * base_T_sole.inverse()
            base = candidate if base is None else pin.SE3.Interpolate(base, candidate, weight / taken)
        return base

    def _loads(self, foot_wrench: Array) -> list[float]:
        """Normal force of each sole of the stance; 0 where it carries nothing."""
        forces = foot_wrench[:, 2].tolist()
        least = self._settings.carrying_force_n
        return [forces[row] if forces[row] >= least else 0.0 for row in self._wrench_rows]

    def _step(self, stamp_s: float, odom_T_imu: pin.SE3) -> None:
        """Advance the tilt by one batch; ``odom_T_imu`` is where the IMU would be with flat soles.

        Plain numbers: calls on arrays of three would take most of the time.
        """
        last, self._last = self._last, (stamp_s, odom_T_imu)
        if last is None or stamp_s <= last[0]:
            return
        settings = self._settings
        dt = stamp_s - last[0]
        rotation = odom_T_imu.rotation
        per_reading = 1.0 / self._summed
        fx, fy, fz = rotation.dot(self._accelerometer_sum).tolist()
        fx, fy, fz = fx * per_reading, fy * per_reading, fz * per_reading
        gx, gy, _ = self.gravity_tilt_rad.tolist()
        if abs(math.sqrt(fx * fx + fy * fy + fz * fz) - _GRAVITY_M_S2) < settings.gravity_band_m_s2:
            # The specific force points up; where the flat-soled pose shows it leaning, the base leans back.
            gain = min(1.0, dt / settings.gravity_time_s)
            gx += gain * (fy / _GRAVITY_M_S2 - gx)
            gy += gain * (-fx / _GRAVITY_M_S2 - gy)
            self.gravity_tilt_rad = np.array((gx, gy, 0.0))
        # What the gyro felt beyond the turn that the joints explain is a turn of the soles.
        unexplained = self._gyro_sum * (dt * per_reading)
        unexplained -= pin.log3(last[1].actInv(odom_T_imu).rotation)
        ux, uy, uz = rotation.dot(unexplained).tolist()
        tx, ty, tz = self.tilt_rad.tolist()
        share = settings.gravity_share if any(self.carrying) else 1.0
        returning = min(1.0, dt / settings.kinematics_time_s)
        tx, ty, tz = tx + ux, ty + uy, tz + uz
        self.tilt_rad = np.array(
            (tx + returning * (share * gx - tx), ty + returning * (share * gy - ty), tz - returning * tz)
        )


def _shares(loads: list[float]) -> list[float]:
    """Share of each sole in the answer: by normal force; all alike when none is felt."""
    total = sum(loads)
    if total <= 0.0:
        return [1.0 / len(loads)] * len(loads)
    return [load / total for load in loads]
