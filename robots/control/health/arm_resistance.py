"""What holds a joint of an arm back: something within the joint, or something that the arm touches.

A touch of hand or forearm is felt by several joints, for a force on a link turns all joints before it. A
bearing or gear that jams is felt by its own motor alone, and does not give way at all: the effort rises while
the joint stays where it is. So an arm's jam is known from a few newton metres on, long before the joint is
far from its setpoint, and a hand that is pressed hard is not taken for one. Where a hand meets what does not
give way, a joint may stay where it is and feel more than twice what the others feel: then it counts whether
theirs explain its own.
"""

from __future__ import annotations

import numpy as np

from kinematics.arrays import Array
from kinematics.estimation.hand_touch import HandTouch
from kinematics.model.robot_description import Hand
from kinematics.model.robot_model import RobotModel
from robots.control.health.finding import Ailment, Finding
from robots.control.health.resistance_arithmetic import average_resistance, find_jammed
from robots.interface.hardware import Hardware
from robots.interface.robot import JointSetpoint, RobotState

_EVERY = 5
_TIME_S = 0.05
"""Both averages' time constant: noise of half a percent of the limit becomes 0.2 Nm at a shoulder."""
_BOUND_SHARE = 0.7
"""Of the effort that means contact: a jam should be known as such before it counts as one."""
_FROZEN_RAD = 0.0006
"""What an averaged encoder may show of a joint that is jammed; a hand against a wall moves a shoulder by
several times as much before 5 Nm are reached, for the rest of the arm gives way."""
_FELT_SHARE = 0.4
"""Seen: 0.2 at most of a jam (what coupling a jammed joint takes away), 1.5 and more of a pressed hand."""
_FORETOLD_SHARE = 0.5
"""A joint whose torque is foretold by the others to this share is pressed from outside; seen: 0.8 to 1.1."""
_PRESSED_S = 0.5
"""Followers are judged by as long: a wrist that was bent by a hit is back later than the rest of its arm."""


class _Arm:
    """One arm's joints, and since when each has not moved."""

    def __init__(self, model: RobotModel, hand: Hand, allowed_nm: Array) -> None:
        self.joints = model.group(f"{hand}_arm")
        self.bound = _BOUND_SHARE * allowed_nm[self.joints]
        self.touch = HandTouch(model, hand)
        self.anchor = np.full(len(self.joints), np.inf)
        self.least, self.most = np.zeros(len(self.joints)), np.zeros(len(self.joints))


class ArmResistance:
    """Judges the arms' joints, every few control periods; joints without a contact effort are not judged."""

    def __init__(self, model: RobotModel, hardware: Hardware, period_s: float) -> None:
        description = model.description
        self._model = model
        names, allowed = description.joints, hardware.contact_effort_nm
        allowed_nm = np.array([allowed.get(name, np.inf) for name in names])
        self._names = names
        self._stiffness = np.array([hardware.gains[name].stiffness for name in names])
        self._viscous = description.joint_viscosity_nms_rad
        self._arms = [
            _Arm(model, hand, allowed_nm)
            for hand in description.tcp_frames
            if f"{hand}_arm" in description.groups
        ]
        self._share = min(1.0, _EVERY * period_s / _TIME_S)
        self._outside, self._mean_q = np.zeros(len(names)), np.zeros(len(names))
        self._bound_rad = _BOUND_SHARE * allowed_nm / self._stiffness
        self._periods = 0
        self._remembered = round(_PRESSED_S / period_s)
        self._pressed = np.full(len(names), -self._remembered - 1)

    def forget(self) -> None:
        """Begin anew: whatever has not moved so far may have been held."""
        for arm in self._arms:
            arm.anchor[:] = np.inf
        self._pressed[:] = self._periods - self._remembered - 1

    def judge(self, state: RobotState, setpoint: JointSetpoint, room: float = 1.0) -> list[Finding]:
        """Take one period's readings, made while the robot followed a setpoint.

        Args:
            state: The readings.
            setpoint: What was followed.
            room: Bounds are multiplied by this.

        Returns:
            Joints that are jammed; nothing in the periods between two judgements.
        """
        self._periods += 1
        if self._periods % _EVERY:
            return []
        n = len(self._names)
        q, outside = state.q[:n], self._outside
        if self._periods == _EVERY:
            self._mean_q[:] = q
        average_resistance(
            q,
            state.v[:n],
            state.effort[:n],
            setpoint.tau,
            self._viscous,
            self._share,
            outside,
            self._mean_q,
        )
        off = setpoint.q[:n] - q
        found = []
        for arm in self._arms:
            j = find_jammed(
                arm.joints,
                arm.bound,
                outside,
                self._mean_q,
                off,
                _FROZEN_RAD,
                _FELT_SHARE,
                room,
                arm.anchor,
                arm.least,
                arm.most,
            )
            if j >= 0 and not self._is_foretold(arm, self._at(state), j):
                bound_rad = float(self._bound_rad[j])
                found.append(Finding(Ailment.STUCK, self._names[j], abs(float(off[j])), bound_rad))
        return found

    def touched(self, part: str, q: Array) -> bool:
        """Whether a joint is held back by something that presses on the hand of its arm, or just was.

        Args:
            part: Name of the joint.
            q: Estimated configuration, shape (nq,).
        """
        j = self._names.index(part)
        if any(self._is_foretold(arm, q, j) for arm in self._arms if j in arm.joints):
            self._pressed[j] = self._periods
        return bool(self._periods - self._pressed[j] <= self._remembered)

    def _is_foretold(self, arm: _Arm, q: Array, j: int) -> bool:
        """Whether what the arm's other joints feel explains the torque of one of them."""
        outside = float(self._outside[j])
        return outside != 0.0 and arm.touch.foretold_nm(q, self._outside, j) / outside >= _FORETOLD_SHARE

    def _at(self, state: RobotState) -> Array:
        """The joints as they were read; where the base is does not matter to what presses on a hand."""
        q = self._model.q_home.copy()
        q[len(q) - len(self._names) :] = state.q[: len(self._names)]
        return q
