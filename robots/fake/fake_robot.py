"""A body without physics: it is at once where it is told to be."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from kinematics.arrays import Array
from kinematics.model.robot_description import RobotDescription
from kinematics.model.robot_model import RobotModel
from robots.clock import Clock
from robots.errors import SetpointRefusedError
from robots.interface.hardware import Hardware
from robots.interface.robot import JointSetpoint, RobotState

_GRAVITY_M_S2 = 9.81
_WEIGHT_N = 900.0


class FakeRobot:
    """A kinematic robot that tracks perfectly; implements ``robots.interface.robot.Robot``.

    Attributes:
        stuck: Names of joints that do not move any more.
        effort: What the effort sensors read, Nm, shape (n,); another array is set by whoever plays the world.
    """

    def __init__(self, model: RobotModel, hardware: Hardware, clock: Clock) -> None:
        """Stand at home, hands open."""
        description = model.description
        self.stuck: set[str] = set()
        self.effort: Array = np.zeros(len(description.actuated))
        self._description, self._hardware = description, hardware
        self._clock = clock
        self._q = np.array([description.home[name] for name in description.actuated])
        self._v = np.zeros_like(self._q)
        feet = len(description.soles)
        self._accelerometer = _GRAVITY_M_S2 * model.imu_up
        self._wrench = np.tile([0.0, 0.0, _WEIGHT_N / max(feet, 1), 0.0, 0.0, 0.0], (feet, 1))

    @property
    def description(self) -> RobotDescription:
        """The robot's data."""
        return self._description

    @property
    def hardware(self) -> Hardware:
        """What it would be made of."""
        return self._hardware

    @property
    def joints(self) -> Array:
        """Where they are, rad, shape (n,), not to be written to: another array whenever they were moved."""
        return self._q

    def read(self) -> RobotState:
        """Perfect readings of a robot that stands on both feet."""
        return self.readings()()

    def readings(self) -> Callable[[], RobotState]:
        """Tells what is read at this instant, also later."""
        stamp_s, q, v, effort = self._clock.now_s(), self._q, self._v, self.effort
        return lambda: RobotState(
            stamp_s=stamp_s,
            q=q.copy(),
            v=v.copy(),
            effort=effort.copy(),
            gyro=np.zeros(3),
            accelerometer=self._accelerometer.copy(),
            foot_wrench=self._wrench.copy(),
        )

    def command(self, setpoint: JointSetpoint) -> None:
        """Be where the setpoint says, but for joints that are stuck.

        Raises:
            SetpointRefusedError: The setpoint has the wrong shape, or is not finite.
        """
        if setpoint.q.shape != self._q.shape or not np.isfinite(setpoint.q).all():
            raise SetpointRefusedError(f"a setpoint needs {len(self._q)} finite positions")
        self.be_at(setpoint.q, setpoint.v)

    def be_at(self, q: Array, v: Array | None = None) -> None:
        """Put all joints that are not stuck at ``q``, rad, with speeds ``v``, rad/s, shape (n,) each."""
        self._v = np.zeros_like(self._q) if v is None else v.copy()
        if not self.stuck:
            self._q = q.copy()
            return
        held = np.array([name in self.stuck for name in self._description.actuated])
        self._q = np.where(held, self._q, q)
        self._v[held] = 0.0

    def advance(self, period_s: float) -> None:
        """Nothing to do: there is no physics."""
