"""The motors' own side of a simulated robot: each gets position, speed, effort and gains of its own."""

from __future__ import annotations

import mujoco
import numpy as np

from kinematics.arrays import Array
from robots.simulated.body.body_model import IMU_SENSORS
from robots.simulated.body.physics import TIMESTEP_S, Physics


class MotorSide:
    """Plays motors with servos of their own: ``tau + kp (q* - q) + kd (dq* - dq)``, 1000 times a second.

    The simulator's own servos are taken out. For who plays a robot on the other side of a wire.
    """

    def __init__(self, physics: Physics, *, hung: bool = False) -> None:
        """Take the motors over.

        Args:
            physics: The world; nobody else commands its robot.
            hung: Whether the robot hangs in a harness that carries it: without weight.
        """
        self._physics = physics
        model = physics.model
        model.actuator_gainprm[:] = 0.0
        model.actuator_gainprm[:, 0] = 1.0
        model.actuator_biastype[:] = mujoco.mjtBias.mjBIAS_NONE
        model.actuator_biasprm[:] = 0.0
        if hung:
            model.opt.gravity[:] = 0.0
        self._count = len(physics.description.joints)
        self._effort = np.zeros(self._count)

    @property
    def q(self) -> Array:
        """Positions of the body's joints, rad, shape (n,)."""
        return np.array(self._physics.data.qpos[self._physics.joint_qpos[: self._count]])

    @property
    def v(self) -> Array:
        """Their speeds, rad/s, shape (n,)."""
        return np.array(self._physics.data.qvel[self._physics.joint_qvel[: self._count]])

    @property
    def effort(self) -> Array:
        """What the motors gave at last, Nm, shape (n,)."""
        return self._effort.copy()

    def imu(self) -> tuple[Array, Array]:
        """Gyro, rad/s, and accelerometer, m/s^2, shape (3,) each; zeros of a robot without an IMU."""
        if self._physics.description.imu is None:
            return np.zeros(3), np.zeros(3)
        data = self._physics.data
        gyro, accelerometer = (np.array(data.sensor(name).data) for name in IMU_SENSORS)
        return gyro, accelerometer

    def step(self, q: Array, v: Array, tau: Array, kp: Array, kd: Array, period_s: float) -> None:
        """Let a period pass under a command, in the order of the body's joints, shape (n,) each.

        Args:
            q, v, tau: Position, rad, speed, rad/s, and effort, Nm.
            kp, kd: Stiffness, Nm/rad, and damping, Nm s/rad.
            period_s: A multiple of the physics step.
        """
        data, n = self._physics.data, self._count
        for _ in range(round(period_s / TIMESTEP_S)):
            data.ctrl[:n] = tau + kp * (q - self.q) + kd * (v - self.v)
            mujoco.mj_step(self._physics.model, data)
        self._effort = np.array(data.actuator_force[:n])
