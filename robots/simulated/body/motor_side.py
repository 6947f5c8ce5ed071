"""The motors' own side of a simulated robot: each gets position, speed, effort and gains of its own."""

from __future__ import annotations

import mujoco
import numpy as np

from kinematics.arrays import Array
from robots.simulated.body.body_model import IMU_SENSORS
from robots.simulated.body.physics import TIMESTEP_S, Physics

_HELD_N_M, _EASED_NS_M = 20_000.0, 1_500.0
_HELD_NM, _EASED_NMS = 2_000.0, 100.0
"""Of a harness: stiffness and damping against shifts and turns; a robot of 35 kg sinks by 17 mm in it."""


class MotorSide:
    """Plays motors with servos of their own: ``tau + kp (q* - q) + kd (dq* - dq)``, 1000 times a second.

    The simulator's own servos are taken out. For who plays a robot on the other side of a wire.
    """

    def __init__(self, physics: Physics, *, hung: bool = False, held: bool = False) -> None:
        """Take the motors over.

        Args:
            physics: The world; nobody else commands its robot.
            hung: Whether the robot is without weight.
            held: Whether a harness keeps the base where it is, like a stiff spring, whatever the legs do.
        """
        self._physics = physics
        model = physics.model
        model.actuator_gainprm[:] = 0.0
        model.actuator_gainprm[:, 0] = 1.0
        model.actuator_biastype[:] = mujoco.mjtBias.mjBIAS_NONE
        model.actuator_biasprm[:] = 0.0
        if hung:
            model.opt.gravity[:] = 0.0
        self._count = len(physics.description.actuated)
        self._effort, self._v = np.zeros(self._count), np.zeros(self._count)
        self._base = physics.model.body(physics.description.base_link).id if held else None
        self._held_at = np.array(physics.data.qpos[:7])

    @property
    def q(self) -> Array:
        """Positions of the actuated joints, those of hands last, rad, shape (n,)."""
        return np.array(self._physics.data.qpos[self._physics.joint_qpos[: self._count]])

    @property
    def v(self) -> Array:
        """Their speeds as a mean over the last period, rad/s, shape (n,): what encoders have moved.

        At an instant a light joint has settled since its command, and is one percent too slow.
        """
        return self._v.copy()

    @property
    def effort(self) -> Array:
        """What the motors gave over the last period, as a mean, Nm, shape (n,)."""
        return self._effort.copy()

    def imu(self) -> tuple[Array, Array]:
        """Gyro, rad/s, and accelerometer, m/s^2, shape (3,) each; zeros of a robot without an IMU."""
        if self._physics.description.imu is None:
            return np.zeros(3), np.zeros(3)
        data = self._physics.data
        gyro, accelerometer = (np.array(data.sensor(name).data) for name in IMU_SENSORS)
        return gyro, accelerometer

    def step(self, q: Array, v: Array, tau: Array, kp: Array, kd: Array, period_s: float) -> None:
        """Let a period pass under a command, in the order of the actuated joints, shape (n,) each.

        Args:
            q, v, tau: Position, rad, speed, rad/s, and effort, Nm.
            kp, kd: Stiffness, Nm/rad, and damping, Nm s/rad.
            period_s: A multiple of the physics step.
        """
        data, n, steps = self._physics.data, self._count, round(period_s / TIMESTEP_S)
        effort, began, speeds = np.zeros(n), self.q, self._physics.joint_qvel[:n]
        for _ in range(steps):
            data.ctrl[:n] = tau + kp * (q - self.q) + kd * (v - data.qvel[speeds])
            if self._base is not None:
                data.xfrc_applied[self._base] = self._harness()
            mujoco.mj_step(self._physics.model, data)
            effort += data.actuator_force[:n]
        self._effort, self._v = effort / steps, (self.q - began) / period_s

    def _harness(self) -> Array:
        """Force and moment of the harness on the base in the world, N and Nm, shape (6,)."""
        data, turn = self._physics.data, np.zeros(3)
        mujoco.mju_subQuat(turn, self._held_at[3:], data.qpos[3:7])
        turning = np.zeros(3)
        mujoco.mju_rotVecQuat(turning, turn * _HELD_NM - _EASED_NMS * data.qvel[3:6], data.qpos[3:7])
        pull = _HELD_N_M * (self._held_at[:3] - data.qpos[:3]) - _EASED_NS_M * data.qvel[:3]
        return np.concatenate([pull, turning])
