"""Motors and sensors that go wrong on purpose."""

from __future__ import annotations

import numpy as np

from robots.simulated.body.physics import Physics
from robots.simulated.body.simulated_robot import SimulatedRobot
from robots.simulated.faults.world_faults import FaultInjector

LOCK_RAD = 1e-4
"""A jammed joint still moves by this."""
LOCK_DAMPING = 1e4
"""Nm s/rad: a jammed joint that its motor pushes with 100 Nm creeps by 10 mrad/s inside that range."""
DRIFT_STEPS = 50


class BodyFaults:
    """Breaks parts of the simulated body; each fault lasts until the world ends."""

    def __init__(self, physics: Physics, robot: SimulatedRobot, injector: FaultInjector) -> None:
        self._physics, self._robot, self._injector = physics, robot, injector
        self._joints = robot.description.actuated

    def jam(self, joint: str) -> None:
        """Let a joint stay where it is, whatever its motor does."""
        model, data = self._physics.model, self._physics.data
        i = self._index(joint)
        j = int(model.dof_jntid[self._physics.joint_qvel[i]])
        q = float(data.qpos[self._physics.joint_qpos[i]])
        model.jnt_limited[j] = 1
        model.jnt_range[j] = (q - LOCK_RAD, q + LOCK_RAD)
        model.dof_damping[self._physics.joint_qvel[i]] = LOCK_DAMPING

    def cut_power(self, joint: str) -> None:
        """Let a motor give nothing any more."""
        self.weaken(joint, 0.0)

    def weaken(self, joint: str, share: float) -> None:
        """Let a motor give no more than a share of its effort limit."""
        limit = self._robot.description.limits[joint].effort * share
        self._physics.model.actuator_forcerange[self._index(joint)] = (-limit, limit)

    def offset_encoder(self, joint: str, offset_rad: float, over_s: float = 0.5) -> None:
        """Let an encoder drift away by an offset, which the servo follows."""
        i, start_s = self._index(joint), float(self._physics.data.time)
        before = float(self._robot.encoder_offset[i])

        def drift(share: float) -> None:
            self._robot.encoder_offset[i] = before + share * offset_rad

        for step in range(1, DRIFT_STEPS + 1):
            share = step / DRIFT_STEPS
            self._injector.at(start_s + share * over_s, lambda share=share: drift(share))  # type: ignore[misc]

    def bias_gyro(self, bias_rad_s: tuple[float, float, float]) -> None:
        """Let the gyro read too much about its own axes."""
        self._robot.gyro_bias = np.asarray(bias_rad_s, dtype=np.float64)

    def delay_sensors(self, periods: int) -> None:
        """Let the sensors come so many control periods late."""
        self._robot.delay_readings(periods)

    def set_battery(self, share: float) -> None:
        """Let the battery have a share of its charge."""
        self._robot.battery = share

    def _index(self, joint: str) -> int:
        return self._joints.index(joint)
