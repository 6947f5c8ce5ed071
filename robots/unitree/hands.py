"""A hand on the wire: a Dex3 has topics of its own, whose messages have neither check sums nor numbers."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from kinematics.arrays import Array
from kinematics.model.robot_description import Hand
from robots.interface.hardware import RobotData
from robots.interface.robot import JointSetpoint
from robots.unitree.commands import TAKE_UP_S, TakeUp
from robots.unitree.layout import HAND_COMMAND, HAND_STATE, empty
from robots.unitree.motors import hand_motors_of
from robots.unitree.watch import LATE_S, SILENT_S, Trouble, Wire, WireFinding

_ENABLED, _TIMED = 1 << 4, 1 << 7
"""Of a motor's mode beside its number: it follows commands, and lets go when none come any more."""
_CODE = 0
"""The word of a hand motor's ``reserve`` that has its error code; ``motorstate`` is not used there."""


class HandReadings(NamedTuple):
    """What the motors of a hand tell, in the order of its joints, shape (n,) each; as of ``RobotState``."""

    q: Array
    v: Array
    effort: Array
    temperature_c: Array
    codes: Array


class WiredHand:
    """One hand: what it is told, what it senses, and what is wrong with it.

    A motor never gives more than its effort: the position that it is told is no farther from where it is than
    its effort bends its servo.

    Attributes:
        columns: Where its joints are among the robot's actuated ones, shape (n,).
        heard: Whether a state has come yet.
    """

    def __init__(
        self, data: RobotData, hand: Hand, wire: Wire, now_s: float, take_up_s: float = TAKE_UP_S
    ) -> None:
        """Begin to wait for the hand's states.

        Args:
            data: The robot's.
            hand: Which of its hands.
            wire: Carries the hand's messages.
            now_s: The time.
            take_up_s: For so long its motors are taken up.

        Raises:
            DescriptionError: A joint has no motor in a Dex3.
        """
        description = data.description
        self._names = description.grippers[hand].joints
        self._motors = hand_motors_of(self._names, hand)
        self.columns = np.array([description.actuated.index(name) for name in self._names], dtype=np.intp)
        gains = [data.hardware.gains[name] for name in self._names]
        self._stiffness = np.array([gain.stiffness for gain in gains])
        self._damping = np.array([gain.damping for gain in gains])
        self._effort = np.array([description.limits[name].effort for name in self._names])
        self._hand, self._wire, self._take_up = hand, wire, TakeUp(take_up_s)
        self._heard_s = now_s
        self._message = empty(HAND_COMMAND)
        self._state = empty(HAND_STATE)
        self.heard = False

    @property
    def share(self) -> float:
        """How far its motors are taken up, 0 to 1."""
        return self._take_up.share

    def hear(self, now_s: float) -> None:
        """Take what has come."""
        for state in self._wire.received():
            self._state, self._heard_s, self.heard = state, now_s, True

    def findings(self, now_s: float, others_heard: bool) -> list[WireFinding]:
        """What is wrong with this hand now.

        Args:
            now_s: The time.
            others_heard: Whether the body is heard; else it is not the hand that is silent.
        """
        found, age_s = [], now_s - self._heard_s
        for bound_s, trouble in ((SILENT_S, Trouble.HAND_SILENT), (LATE_S, Trouble.LATE)):
            if others_heard and age_s > bound_s:
                told = f"no state of the {self._hand} hand for more than {bound_s:g} s"
                found.append(WireFinding(trouble, told))
                break
        codes = self.sensed().codes
        found += [
            WireFinding(Trouble.MOTOR_ERROR, f"{self._names[k]}, code {int(codes[k])}")
            for k in np.flatnonzero(codes).tolist()
        ]
        return found

    def sensed(self) -> HandReadings:
        """What the newest state tells."""
        motor = self._state["motor"][self._motors]
        q, v, effort = (motor[key].astype(np.float64) for key in ("q", "dq", "tau_est"))
        heat, codes = motor["temperature"].max(axis=1), motor["reserve"][:, _CODE]
        return HandReadings(q, v, effort, heat.astype(np.float64), codes.astype(np.float64))

    def follow(self, setpoint: JointSetpoint, now_s: float, period_s: float) -> None:
        """Send what the hand's joints shall do, taken up from where they are; damping while it is silent."""
        if now_s - self._heard_s > SILENT_S:
            self.damp()
            return
        measured = self.sensed().q
        start, blend = self._take_up.go_on(measured, period_s)
        stiffness, limit = blend * self._stiffness, self._effort
        tau = np.clip(blend * setpoint.tau[self.columns], -limit, limit)
        wanted = start + blend * (setpoint.q[self.columns] - start)
        room = np.divide(limit, stiffness, out=np.zeros_like(limit), where=stiffness > 0.0)
        q = np.clip(wanted, measured - room, measured + room)
        self._send(q, blend * setpoint.v[self.columns], tau, stiffness)

    def damp(self) -> None:
        """Send damping alone; what comes after it is taken up anew."""
        self._take_up.let_go()
        nothing = np.zeros(len(self._names))
        self._send(self.sensed().q, nothing, nothing, nothing)

    def _send(self, q: Array, v: Array, tau: Array, kp: Array) -> None:
        motor = self._message["motor"]
        for key, values in (("q", q), ("dq", v), ("tau", tau), ("kp", kp), ("kd", self._damping)):
            motor[key][self._motors] = values
        motor["mode"][self._motors] = self._motors + (_ENABLED | _TIMED)
        self._wire.send(self._message.copy())
