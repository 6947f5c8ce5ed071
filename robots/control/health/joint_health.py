"""Motors that do not give what they are asked for, joints that do not follow, encoders that slip.

Three redundancies, none of which a touch disturbs:

* a servo's law says what effort it gives for its errors; a motor that gives less is weak or offline;
* a joint whose setpoint moves, and which does not move at all, is stuck; something that the arm touches
  gives way, or was reached on the way, so that the joint has moved for a part of the time;
* the speed is measured on the motor's side and the position on the joint's: where the one does not add
  up to the change of the other, the encoder has slipped.
"""

from __future__ import annotations

from collections import deque

import numpy as np
from numpy.typing import NDArray

from kinematics.robot_description import RobotDescription
from robots.control.health.finding import Ailment, Finding
from robots.interface import JointSetpoint, RobotState

Array = NDArray[np.float64]

_EVERY = 5
_MOTOR_TIME_S = 0.05
"""Efforts are averaged over this: sensor noise of half a percent and touch-downs vanish."""
_GIVEN_SHARE = 0.6
"""A motor that gives less than this of what is asked for is not what it should be."""
_OFFLINE_SHARE = 0.02
"""Of the effort limit: a motor that gives less than this is offline, one that gives more is weak."""
_WINDOW_S = 0.5
_FOLLOWED_SHARE = 0.15
_BEHIND_S = 0.5
"""A joint that stays so far behind for so long is stuck, also when its motor makes it creep: a jammed ankle
that 100 Nm move by 10 mrad/s follows a slow motion by a quarter."""
_FORGET_S = 30.0
"""The sum of speeds forgets with this time constant: noise of 0.002 rad/s adds up to 0.4 mrad."""


class JointHealth:
    """Judges the body's joints, every few control periods; a gripper is judged by what it holds.

    Attributes:
        off_rad: How far each joint was from its setpoint at the last judgement, shape (joints,).
    """

    def __init__(self, description: RobotDescription, period_s: float) -> None:
        names = description.joints
        gains = [description.gains[name] for name in names]
        self._names, self._bodies = names, len(names)
        self._limits = description.health
        self._stiffness = np.array([gain.stiffness for gain in gains])
        self._damping = np.array([gain.damping for gain in gains])
        self._effort = np.array([description.limits[name].effort for name in names])
        # What a hand carries or touches may hold a soft joint back by as much as its setpoint moves.
        load_rad = self._limits.stuck_effort_nm / self._stiffness
        self._stuck_rad = np.maximum(self._limits.stuck_rad, load_rad)
        self._period_s = period_s
        self._share = min(1.0, _EVERY * period_s / _MOTOR_TIME_S)
        n = len(names)
        self._asked, self._given = np.zeros(n), np.zeros(n)
        self._past: deque[tuple[Array, Array]] = deque(maxlen=round(_WINDOW_S / (_EVERY * period_s)))
        self._travel = np.zeros(n)
        self._origin: Array | None = None
        self._v = np.zeros(n)
        self._periods = 0
        self.off_rad = np.zeros(n)
        self._behind_s = np.zeros(n)

    def forget(self) -> None:
        """Begin anew: the encoders count as right, and nothing as stuck."""
        self._origin = None
        self._past.clear()
        self._behind_s[:] = 0.0

    def judge(
        self, state: RobotState, setpoint: JointSetpoint, in_contact: bool = False, room: float = 1.0
    ) -> list[Finding]:
        """Take one period's readings, made while the robot followed a setpoint.

        Args:
            state: The readings.
            setpoint: What was followed.
            in_contact: A hand holds something that may not move: a joint that does not follow is judged by
                how far it stays behind alone.
            room: What motors and followers are judged by is multiplied by this.

        Returns:
            What is wrong now; nothing in the periods between two judgements.
        """
        n = self._bodies
        q, v = state.q[:n], state.v[:n]
        if self._origin is None:
            self._origin, self._v = q.copy(), v
            self._travel[:] = 0.0
        self._travel += (0.5 * self._period_s) * (self._v + v)
        self._v = v
        self._periods += 1
        if self._periods % _EVERY:
            return []
        motors = self._motors(q, v, state.effort[:n], setpoint, room)
        blamed = {finding.part for finding in motors}  # a joint without effort does not follow either
        followers = [
            finding
            for finding in self._followers(q, setpoint, in_contact, room)
            if finding.part not in blamed
        ]
        return [*motors, *followers, *self._encoders(q)]

    def _motors(
        self, q: Array, v: Array, effort: Array, setpoint: JointSetpoint, room: float
    ) -> list[Finding]:
        n = self._bodies
        asked = self._stiffness * (setpoint.q[:n] - q) + self._damping * (setpoint.v[:n] - v)
        asked += setpoint.tau[:n]
        np.clip(asked, -self._effort, self._effort, out=asked)
        self._asked += self._share * (asked - self._asked)
        self._given += self._share * (effort - self._given)
        missing = np.abs(self._asked - self._given)
        bound = np.maximum(
            self._limits.motor_effort_fraction * self._effort, (1.0 - _GIVEN_SHARE) * np.abs(self._asked)
        )
        bound *= room
        found = []
        for i in np.flatnonzero(missing > bound).tolist():
            dead = abs(effort[i]) < _OFFLINE_SHARE * self._effort[i]
            ailment = Ailment.OFFLINE if dead else Ailment.WEAK
            found.append(Finding(ailment, self._names[i], float(missing[i]), float(bound[i])))
        return found

    def _followers(self, q: Array, setpoint: JointSetpoint, in_contact: bool, room: float) -> list[Finding]:
        wanted_now, limits = setpoint.q[: self._bodies], self._limits
        if in_contact:
            self._past.clear()
        self._past.append((wanted_now, q))
        then_wanted, then = self._past[0]
        wanted, followed = np.abs(wanted_now - then_wanted), np.abs(q - then)
        error = self.off_rad = np.abs(wanted_now - q)
        stuck = (wanted > self._stuck_rad) & (followed < _FOLLOWED_SHARE * wanted)
        stuck &= error > 0.5 * room * self._stuck_rad
        stuck |= error > room * limits.tracking_rad
        behind = error > room * self._stuck_rad
        self._behind_s = np.where(behind, self._behind_s + _EVERY * self._period_s, 0.0)
        if not in_contact:
            stuck |= self._behind_s > _BEHIND_S
        return [
            Finding(Ailment.STUCK, self._names[i], float(error[i]), float(self._stuck_rad[i]))
            for i in np.flatnonzero(stuck).tolist()
        ]

    def _encoders(self, q: Array) -> list[Finding]:
        if self._origin is None:
            return []
        slipped = q - self._origin - self._travel
        self._origin += slipped * (_EVERY * self._period_s / _FORGET_S)
        bound = self._limits.encoder_offset_rad
        return [
            Finding(Ailment.ENCODER_OFFSET, self._names[i], float(slipped[i]), bound)
            for i in np.flatnonzero(np.abs(slipped) > bound).tolist()
        ]
