"""What goes out over the wire: setpoints with gains, taken up gently, or damping."""

from __future__ import annotations

import numpy as np

from kinematics.arrays import Array
from robots.interface.robot import JointSetpoint
from robots.unitree.layout import LOW_COMMAND, Record, empty, seal
from robots.unitree.motors import ARM_WEIGHT, LEGS, Motors

TAKE_UP_S = 2.0
"""For so long stiffness and effort rise when motors are taken up, and the way from where they are to the
setpoint is gone."""
_ENABLED = 1


class TakeUp:
    """How motors are taken up from where they are: stiffness, effort and way rise together.

    Attributes:
        share: How far, 0 to 1.
    """

    def __init__(self, for_s: float = TAKE_UP_S) -> None:
        """Begin with motors that nobody holds; they are taken up within ``for_s``."""
        self._for_s = for_s
        self._start: Array | None = None
        self.share = 0.0

    def go_on(self, measured: Array, period_s: float) -> tuple[Array, float]:
        """Where the motors were, rad, shape (n,), and what share of the setpoint counts now."""
        if self._start is None:
            self._start, self.share = measured.copy(), 0.0
        self.share = min(1.0, self.share + period_s / self._for_s)
        return self._start, self.share * self.share * (3.0 - 2.0 * self.share)

    def let_go(self) -> None:
        """What comes next is taken up anew."""
        self._start, self.share = None, 0.0


class LowCommands:
    """Makes the messages of one robot.

    Motors that the robot does not have, or that are not its own under ``arm_sdk``, stay disabled.
    """

    def __init__(
        self,
        motors: Motors,
        stiffness: Array,
        damping: Array,
        *,
        arms_only: bool,
        take_up_s: float = TAKE_UP_S,
    ) -> None:
        """Take a robot's gains.

        Args:
            motors: The motor of each joint, shape (n,).
            stiffness, damping: Of the motors' own servos, Nm/rad and Nm s/rad, shape (n,).
            arms_only: Arms and waist alone, by ``arm_sdk``; the legs stay the maker's.
            take_up_s: For so long motors are taken up.
        """
        self._motors = motors
        own = np.ones(len(motors), dtype=np.bool_)
        if arms_only:
            own = ~np.isin(motors, list(LEGS))
        self._own, self._arms_only, self._take_up = own, arms_only, TakeUp(take_up_s)
        self._stiffness, self._damping = stiffness, damping
        self._message = empty(LOW_COMMAND)

    @property
    def share(self) -> float:
        """How far motors are taken up, 0 to 1; under ``arm_sdk`` this is its weight."""
        return self._take_up.share

    def follow(self, setpoint: JointSetpoint, measured: Array, period_s: float, machine: int) -> Record:
        """A message that follows a setpoint, taken up from where the joints are.

        Args:
            setpoint: Joints in the robot's order, at least n.
            measured: Where the joints are, shape (n,), rad.
            period_s: Time since the last message.
            machine: The mode that the robot told of itself.
        """
        n = len(self._motors)
        start, blend = self._take_up.go_on(measured, period_s)
        q = start + blend * (setpoint.q[:n] - start)
        return self._fill(
            q,
            blend * setpoint.v[:n],
            blend * setpoint.tau[:n],
            blend * self._stiffness,
            self._damping,
            machine,
        )

    def damp(self, measured: Array, machine: int) -> Record:
        """A message that only damps; what comes after it is taken up anew."""
        self._take_up.let_go()
        nothing = np.zeros(len(self._motors))
        return self._fill(measured, nothing, nothing, nothing, self._damping, machine)

    def _fill(self, q: Array, v: Array, tau: Array, kp: Array, kd: Array, machine: int) -> Record:
        message, motor = self._message, self._message["motor"]
        message["mode_pr"], message["mode_machine"] = 0, machine
        for key, values in (("q", q), ("dq", v), ("tau", tau), ("kp", kp), ("kd", kd)):
            motor[key][self._motors] = np.where(self._own, values, 0.0)
        motor["mode"][self._motors] = np.where(self._own, _ENABLED, 0)
        if self._arms_only:
            motor["q"][ARM_WEIGHT] = self.share
        seal(message)
        return message.copy()
