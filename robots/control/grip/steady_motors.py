"""Setpoints of a hand's motors while it presses: as near to its fingers as pressing lets them be."""

from __future__ import annotations

import math

import numpy as np

from kinematics.arrays import Array
from robots.control.grip.hand_joints import HandJoints
from robots.control.grip.joint_tracker import JointTracker
from robots.interface.hardware import RobotData

_PRESSES = 0.85
"""Share of its effort with which a motor holds on. What moves its finger by a little then meets the servo's
stiffness and damping; with all of its effort it would meet neither, and what is held would sway."""
_LOOSE = 0.3
"""A setpoint that rests follows a finger that has moved by more than this share of its servo's bend,"""
_MET = 0.01
"""and one that moves comes as near as this."""
_CREPT, _CREEPS_RAD_S = 0.4, 0.03
"""What a finger that has moved by no more than the first, in shares of that bend, is followed with: what is
pressed creeps, and a setpoint that goes there at once takes its finger along by 5 mrad within 0.1 s."""
_BACK_RAD = 1e-6
"""Nearer than this to the hand's position a motor is there."""

_State = tuple[tuple[float, float, float, bool], ...]


class SteadyMotors:
    """How far each motor's setpoint is from where the hand's position has it, and how that changes.

    A hand presses by setpoints at the end of its fingers' way, where every motor gives all that it may. Once
    it does, each setpoint comes back to its finger, but for what bends the servo by its share of the effort.

    Attributes:
        shift: What is added to each motor's position, rad, shape (m,).
        speed: By which that changes, rad/s, shape (m,).
        moving: Whether a setpoint is on its way.
        shifted: Whether a motor is elsewhere than the hand's position has it.
    """

    def __init__(self, data: RobotData, joints: HandJoints, period_s: float) -> None:
        """Begin without any shift.

        Args:
            data: The robot's.
            joints: Of a hand.
            period_s: The control period.
        """
        description, names = data.description, joints.names
        limits = [description.limits[name] for name in names]
        stiffness = np.array([data.hardware.gains[name].stiffness for name in names])
        effort = np.array([limit.effort for limit in limits])
        self._inwards, bends = joints.inwards, effort / stiffness
        self._pressed = _PRESSES * joints.inwards * bends
        self._bends = bends.tolist()
        self._trackers = tuple(
            JointTracker(0.0, limit.velocity, limit.acceleration, period_s, limit.jerk) for limit in limits
        )
        self._creeps = [False] * len(names)
        self._committed: _State = tuple((0.0, 0.0, 0.0, False) for _ in names)
        self._proposed = False
        self.shift, self.speed = np.zeros(len(names)), np.zeros(len(names))
        self.moving = self.shifted = False

    def come_to(self, fingers: Array, ends: Array) -> None:
        """Advance one period towards where pressing fingers are.

        Args:
            fingers: Where the joints are, rad, shape (m,).
            ends: Where the hand's position has them, rad, shape (m,).
        """
        wanted = fingers + self._pressed - ends
        # nothing is pressed by a setpoint beyond the end
        self._advance(np.where(self._inwards * wanted < 0.0, wanted, 0.0))

    def go_back(self) -> None:
        """Advance one period towards no shift."""
        if self.shifted:
            self._advance(np.zeros(len(self._trackers)))

    def commit(self) -> None:
        """What was proposed is what the robot follows now."""
        if self._proposed:
            self._committed = tuple(
                (one.q_rad, one.v_rad_s, one.a_rad_s2, creeps)
                for one, creeps in zip(self._trackers, self._creeps, strict=True)
            )
            self._proposed = False

    def revert(self) -> None:
        """Go back to what the robot follows: the rest was refused."""
        for k, (tracker, state) in enumerate(zip(self._trackers, self._committed, strict=True)):
            tracker.q_rad, tracker.v_rad_s, tracker.a_rad_s2, self._creeps[k] = state
        self._proposed = False
        self._tell()

    def halt(self) -> None:
        """Rest at the last shift that the robot follows."""
        for tracker, (at, _, _, _) in zip(self._trackers, self._committed, strict=True):
            tracker.q_rad, tracker.v_rad_s, tracker.a_rad_s2 = at, 0.0, 0.0
        self._proposed = True
        self.commit()
        self._tell()

    def _advance(self, wanted: Array) -> None:
        self._proposed = True
        for k, (tracker, target) in enumerate(zip(self._trackers, wanted.tolist(), strict=True)):
            moving, bend = tracker.moving, self._bends[k]
            off = abs(target - (tracker.rest_rad if moving else tracker.q_rad))
            if target == 0.0 or off > _CREPT * bend:
                self._creeps[k] = False
            elif not moving:
                self._creeps[k] = True
            if target == 0.0 or off > (_MET if moving else _LOOSE) * bend:
                tracker.step_towards(target, _CREEPS_RAD_S if self._creeps[k] else math.inf)
            else:
                tracker.step_to_rest()
        self._tell()

    def _tell(self) -> None:
        for k, tracker in enumerate(self._trackers):
            self.shift[k], self.speed[k] = tracker.q_rad, tracker.v_rad_s
        self.moving = any(tracker.moving for tracker in self._trackers)
        self.shifted = self.moving or bool(np.abs(self.shift).max() > _BACK_RAD)
