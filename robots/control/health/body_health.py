"""Gyro, feet, uprightness, battery and the loop's own pace."""

from __future__ import annotations

import math
from collections import deque

import numpy as np

from kinematics.arrays import Array
from kinematics.geometry.poses import rotation_from_quaternion, vector_from_rotation
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import stance_at
from kinematics.model.support_polygon import SupportPolygon
from robots.control.health.finding import Ailment, Finding
from robots.interface.hardware import HealthLimits
from robots.interface.sensed_state import SensedState

_GYRO_WINDOW_S = 1.0
_GYRO_STEP_S = 0.1
"""Turning is compared over such steps: short enough that the gyro's axes hardly turn on the way."""
_FOOT_TIME_S = 0.1
"""Contact is lost after so long; what is estimated is averaged over it, for its noise is as its bound."""
_PACE_TIME_S = 1.0
_FALLEN_S, _GRAVITY_TIME_S = 0.1, 0.2
"""A base leans for so long until it counts; what the accelerometer feels is averaged over the other."""
_GRAVITY_M_S2 = 9.81


class BodyHealth:
    """Judges what belongs to no joint, once a control period."""

    def __init__(self, model: RobotModel, limits: HealthLimits, period_s: float) -> None:
        description = model.description
        self._limits = limits
        self._soles = description.soles
        self._model, self._imu = model, description.imu
        self._period_s = period_s
        self._step = round(_GYRO_STEP_S / period_s)
        self._gyro_sum, self._periods = np.zeros(3), 0
        self._facing: Array | None = None
        self._excess: deque[Array] = deque(maxlen=round(_GYRO_WINDOW_S / _GYRO_STEP_S))
        self._gyro_bias = 0.0
        self._unloaded_s = [0.0] * len(self._soles)
        self._estimated_n = np.zeros(len(self._soles))
        self._late_share, self._leaning_s = 0.0, 0.0
        self._up = _GRAVITY_M_S2 * model.imu_up
        self._surely_upright = math.cos(0.5 * limits.fallen_rad)

    def forget(self) -> None:
        """Begin anew."""
        self._gyro_sum[:], self._periods, self._facing = 0.0, 0, None
        self._excess.clear()
        self._gyro_bias = 0.0

    def note_late(self, late_s: float) -> None:
        """Tell by how much the present period began too late; 0 in lockstep."""
        late = 1.0 if late_s > self._period_s else 0.0
        self._late_share += min(1.0, self._period_s / _PACE_TIME_S) * (late - self._late_share)

    def judge(
        self, sensed: SensedState, standing: bool, stepping: bool = False, bent: bool = False
    ) -> list[Finding]:
        """Take one period's readings.

        Args:
            sensed: Readings, and the configuration estimated from them.
            standing: Whether both soles are meant to carry.
            stepping: Whether the feet move: the orientation hangs on the gyro then, and cannot judge it.
            bent: Whether a leg is not where it was told to be: what it says about turning is not trusted.
        """
        state, limits, found = sensed.readings, self._limits, []
        if stepping or bent:
            self.forget()
        elif self._imu is not None:
            found += self._gyro(sensed, self._imu)
        if self._soles:
            found += self._feet(sensed, standing)
            found += self._upright(sensed, self._imu) if self._imu is not None else []
        if state.battery < limits.battery_low:
            found.append(Finding(Ailment.BATTERY_LOW, "battery", state.battery, limits.battery_low))
        if self._late_share > limits.late_share:
            found.append(Finding(Ailment.OVERRUNS, "control loop", self._late_share, limits.late_share))
        return found

    def _gyro(self, sensed: SensedState, imu: str) -> list[Finding]:
        self._gyro_sum += sensed.readings.gyro
        self._periods += 1
        if self._periods >= self._step or self._facing is None:
            facing = self._model.frame_pose(sensed.q, imu)[:3, :3]
            if self._facing is not None:
                passed_s = self._periods * self._period_s
                turned = vector_from_rotation(self._facing.T @ facing) / passed_s
                self._excess.append(self._gyro_sum / self._periods - turned)
                if len(self._excess) == self._excess.maxlen:
                    self._gyro_bias = float(np.linalg.norm(np.mean(self._excess, axis=0)))
            self._facing = facing
            self._gyro_sum, self._periods = np.zeros(3), 0
        bound = self._limits.gyro_bias_rad_s
        if self._gyro_bias > bound:
            return [Finding(Ailment.GYRO_BIAS, "gyro", self._gyro_bias, bound)]
        return []

    def _feet(self, sensed: SensedState, standing: bool) -> list[Finding]:
        found, bound = [], self._limits.foot_force_n
        forces = sensed.readings.foot_wrench[:, 2]
        if sensed.readings.feet_estimated:
            bound -= self._limits.foot_error_n
            self._estimated_n += self._period_s / _FOOT_TIME_S * (forces - self._estimated_n)
            forces = self._estimated_n
        for i, sole in enumerate(self._soles):
            force = float(forces[i])
            unloaded = standing and force < bound and not self._stands_on_the_other(sensed.q, i)
            self._unloaded_s[i] = self._unloaded_s[i] + self._period_s if unloaded else 0.0
            if self._unloaded_s[i] > _FOOT_TIME_S:
                found.append(Finding(Ailment.FOOT_CONTACT_LOST, sole.link, force, bound))
        return found

    def _upright(self, sensed: SensedState, imu: str) -> list[Finding]:
        """Whether the base leans so far that the robot has fallen; gravity tells, whatever is believed."""
        share = self._period_s / _GRAVITY_TIME_S
        self._up = up = self._up + share * (sensed.readings.accelerometer - self._up)
        felt = math.sqrt(up.dot(up))
        if felt < 0.5 * _GRAVITY_M_S2 or up.dot(self._model.imu_up) > self._surely_upright * felt:
            self._leaning_s = 0.0
            return []
        base_R = rotation_from_quaternion(sensed.q[3:7])
        base_up = base_R.T @ self._model.frame_pose(sensed.q, imu)[:3, :3] @ up
        bound = self._limits.fallen_rad
        leans_rad = math.acos(float(np.clip(base_up[2] / felt, -1.0, 1.0)))
        self._leaning_s = self._leaning_s + self._period_s if leans_rad > bound else 0.0
        if self._leaning_s <= _FALLEN_S:
            return []
        return [Finding(Ailment.FALLEN, self._model.description.base_link, leans_rad, bound)]

    def _stands_on_the_other(self, q: Array, lifted: int) -> bool:
        """Whether another sole has the whole weight well above it, so that this one need not carry."""
        others = [sole.frame for i, sole in enumerate(self._soles) if i != lifted]
        if not others:
            return False
        polygon = SupportPolygon(stance_at(self._model, q, others), self._soles)
        return polygon.com_margin_m(self._model.com(q)) >= self._model.description.com_margin_m
