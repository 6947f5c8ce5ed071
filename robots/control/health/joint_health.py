"""Motors that do not give what they are asked for, joints that do not follow, encoders that slip.

Three redundancies, none of which a touch disturbs:

* a servo's law says what effort it gives for its errors; a motor that gives less is weak or offline;
* a joint whose setpoint moves, and which does not move at all, is stuck; something that the arm touches
  gives way, or was reached on the way, so that the joint has moved for a part of the time;
* the speed is measured on the motor's side and the position on the joint's: where the one does not add
  up to the change of the other, the encoder has slipped. Over a wire periods pass in which no state comes,
  and two come in others: it is the time between readings that counts.
"""

from __future__ import annotations

import math
from collections import deque

import numpy as np

from kinematics.arrays import Array
from robots.control.health.finding import Ailment, Finding
from robots.control.health.joint_arithmetic import (
    add_travel,
    watch_encoders,
    watch_followers,
    watch_motors,
)
from robots.interface.hardware import RobotData
from robots.interface.robot import JointSetpoint, RobotState

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
_LEGS = ("left_leg", "right_leg")
_BENT_RAD = 0.010
"""Legs farther from their setpoints than this (healthy ones: 5 mrad) tip a sole, and say nothing true about
how the trunk turns: a jammed ankle looked like 18 mrad/s of gyro bias before it was found to be stuck."""
_FORGET_S = 30.0
"""The sum of speeds forgets with this time constant: noise of 0.002 rad/s adds up to 0.4 mrad."""


class JointHealth:
    """Judges the body's joints, every few control periods; a gripper is judged by what it holds.

    Attributes:
        off_rad: How far each joint was from its setpoint at the last judgement, shape (joints,).
        bent: Whether a leg was so far from its setpoint then that it tips a sole.
    """

    def __init__(self, data: RobotData, period_s: float) -> None:
        description, hardware = data.description, data.hardware
        names = description.joints
        gains = [hardware.gains[name] for name in names]
        self._names, self._bodies = names, len(names)
        self._limits = hardware.health
        effort = np.array([description.limits[name].effort for name in names])
        stiffness = np.array([gain.stiffness for gain in gains])
        self._servo = np.array([stiffness, [gain.damping for gain in gains], effort])
        # What a hand carries or touches may hold a soft joint back by as much as its setpoint moves.
        load_rad = self._limits.stuck_effort_nm / stiffness
        self._stuck_rad = np.maximum(self._limits.stuck_rad, load_rad)
        legs = {joint for group in _LEGS for joint in description.groups.get(group, ())}
        self._legs = np.array([name in legs for name in names])
        ankles = {joint for group in _LEGS for joint in description.groups.get(group, ())[-2:]}
        self._ankles = np.array([name in ankles for name in names])
        self._period_s = period_s
        self._share = min(1.0, _EVERY * period_s / _MOTOR_TIME_S)
        n = len(names)
        self._mean = np.zeros((2, n))
        self._missing, self._bound = np.zeros(n), np.zeros(n)
        self._past: deque[tuple[Array, Array]] = deque(maxlen=round(_WINDOW_S / (_EVERY * period_s)))
        self._stuck = np.zeros(n, dtype=np.bool_)
        self._travel, self._slipped, self._v = np.zeros(n), np.zeros(n), np.zeros(n)
        self._origin: Array | None = None
        self._measured_s = 0.0
        self._periods = 0
        self.off_rad, self.bent = np.zeros(n), False
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
        origin = self._origin
        if origin is None:
            origin = self._origin = q.copy()
            self._v[:] = v
            self._travel[:] = 0.0
            self._measured_s = state.stamp_s - state.age_s
        passed_s = state.stamp_s - state.age_s - self._measured_s
        self._measured_s += passed_s
        add_travel(self._travel, self._v, v, 0.5 * passed_s)
        self._periods += 1
        if self._periods % _EVERY:
            return []
        motors = self._motors(q, v, state.effort[:n], setpoint, room)
        blamed = {finding.part for finding in motors}  # a joint without effort does not follow either
        followers = self._followers(q, setpoint, in_contact, room)
        self.bent = bool((self.off_rad[self._legs] > _BENT_RAD).any())
        return [
            *motors,
            *(finding for finding in followers if finding.part not in blamed),
            *self._encoders(q, origin),
        ]

    def _motors(
        self, q: Array, v: Array, effort: Array, setpoint: JointSetpoint, room: float
    ) -> list[Finding]:
        missing, bound = self._missing, self._bound
        if not watch_motors(
            q,
            v,
            effort,
            setpoint.q,
            setpoint.v,
            setpoint.tau,
            self._servo,
            self._share,
            self._limits.motor_effort_fraction,
            1.0 - _GIVEN_SHARE,
            room,
            self._mean,
            missing,
            bound,
        ):
            return []
        found = []
        for i in np.flatnonzero(missing > bound).tolist():
            dead = abs(effort[i]) < _OFFLINE_SHARE * self._servo[2, i]
            ailment = Ailment.OFFLINE if dead else Ailment.WEAK
            found.append(Finding(ailment, self._names[i], float(missing[i]), float(bound[i])))
        return found

    def _followers(self, q: Array, setpoint: JointSetpoint, in_contact: bool, room: float) -> list[Finding]:
        if in_contact:
            self._past.clear()
        self._past.append((setpoint.q, q))
        then_wanted, then = self._past[0]
        if not watch_followers(
            setpoint.q,
            q,
            then_wanted,
            then,
            self._stuck_rad,
            self._limits.tracking_rad,
            _FOLLOWED_SHARE,
            room,
            _EVERY * self._period_s,
            math.inf if in_contact else _BEHIND_S,
            self.off_rad,
            self._behind_s,
            self._stuck,
        ):
            return []
        if room > 1.0:  # ankles give way in steps: only those that are farther off than any of them are stuck
            near = self._ankles & (self.off_rad <= room * self._limits.tracking_rad)
            self._stuck[near] = False
            self._behind_s[near] = 0.0
        return [
            Finding(Ailment.STUCK, self._names[i], float(self.off_rad[i]), float(self._stuck_rad[i]))
            for i in np.flatnonzero(self._stuck).tolist()
        ]

    def _encoders(self, q: Array, origin: Array) -> list[Finding]:
        slipped, bound = self._slipped, self._limits.encoder_offset_rad
        forgotten = _EVERY * self._period_s / _FORGET_S
        if not watch_encoders(q, self._travel, forgotten, bound, origin, slipped):
            return []
        return [
            Finding(Ailment.ENCODER_OFFSET, self._names[i], float(slipped[i]), bound)
            for i in np.flatnonzero(np.abs(slipped) > bound).tolist()
        ]
