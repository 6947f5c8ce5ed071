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
        self._own, self._arms_only, self._take_up_s = own, arms_only, take_up_s
        self._stiffness, self._damping = stiffness, damping
        self._message = empty(LOW_COMMAND)
        self._start: Array | None = None
        self._share = 0.0

    @property
    def share(self) -> float:
        """How far motors are taken up, 0 to 1; under ``arm_sdk`` this is its weight."""
        return self._share

    def follow(self, setpoint: JointSetpoint, measured: Array, period_s: float, machine: int) -> Record:
        """A message that follows a setpoint, taken up from where the joints are.

        Args:
            setpoint: Joints in the robot's order, at least n.
            measured: Where the joints are, shape (n,), rad.
            period_s: Time since the last message.
            machine: The mode that the robot told of itself.
        """
        n = len(self._motors)
        if self._start is None:
            self._start, self._share = measured.copy(), 0.0
        self._share = min(1.0, self._share + period_s / self._take_up_s)
        blend = self._share * self._share * (3.0 - 2.0 * self._share)
        q = self._start + blend * (setpoint.q[:n] - self._start)
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
        self._start, self._share = None, 0.0
        nothing = np.zeros(len(self._motors))
        return self._fill(measured, nothing, nothing, nothing, self._damping, machine)

    def _fill(self, q: Array, v: Array, tau: Array, kp: Array, kd: Array, machine: int) -> Record:
        message, motor = self._message, self._message["motor"]
        message["mode_pr"], message["mode_machine"] = 0, machine
        for key, values in (("q", q), ("dq", v), ("tau", tau), ("kp", kp), ("kd", kd)):
            motor[key][self._motors] = np.where(self._own, values, 0.0)
        motor["mode"][self._motors] = np.where(self._own, _ENABLED, 0)
        if self._arms_only:
            motor["q"][ARM_WEIGHT] = self._share
        seal(message)
        return message.copy()
