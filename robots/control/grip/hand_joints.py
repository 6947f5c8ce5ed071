"""The driven joints of one gripper among those of the robot, seen as one position."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from kinematics.arrays import Array
from kinematics.model.robot_description import Hand, RobotDescription

_NOISY = 1.25
"""Motors of a hand that has several press with all that they may give; noise reads as a little more."""


@dataclass(frozen=True, slots=True)
class StrokeLimits:
    """Limits of a gripper's position, in its units: no motor of several exceeds its own then."""

    velocity: float
    acceleration: float
    jerk: float


class HandJoints:
    """Between a gripper's position and its joints; of a gripper with one joint both are the same number.

    Attributes:
        names: The driven joints.
        indices: Where they are among the actuated joints, shape (m,).
        lead: Where the first one that moves is.
        single: Whether there is but one.
        inwards: The sign with which each closes, shape (m,); 0 for one that keeps still.
    """

    def __init__(self, description: RobotDescription, hand: Hand) -> None:
        """Find the joints of a gripper.

        Args:
            description: The robot's.
            hand: Which gripper.
        """
        gripper = description.grippers[hand]
        self._gripper = gripper
        self.names = gripper.joints
        self.indices = np.array([description.actuated.index(name) for name in self.names], dtype=np.intp)
        self.lead = description.actuated.index(gripper.joint)
        self.single = not gripper.motors
        closed, opened = np.array(gripper.joints_at(0.0)), np.array(gripper.joints_at(1.0))
        span = opened - closed
        moves = span != 0.0
        self._closed, self._span = closed, span
        self._share = np.where(moves, 1.0, 0.0) / (np.where(moves, span, 1.0) * max(1, int(moves.sum())))
        self.inwards = -np.sign(span)
        at = self.names.index(gripper.joint)
        self._lead_closed, self._lead_span = float(closed[at]), float(span[at])
        limits = [description.limits[name] for name in self.names]
        spans = np.where(moves, np.abs(span), 1e-9)
        self.limits = StrokeLimits(
            *(
                min(float(value) / s for value, s in zip(values, spans.tolist(), strict=True))
                for values in (
                    [one.velocity for one in limits],
                    [one.acceleration for one in limits],
                    [one.jerk for one in limits],
                )
            )
        )
        self.most_effort = _NOISY * np.array([one.effort for one in limits])

    def position(self, q: Array) -> float:
        """The gripper's position, from those of the actuated joints, shape (n,)."""
        if self.single:
            return float(q[self.lead])
        return float(self._share @ (q[self.indices] - self._closed))

    def effort(self, effort: Array) -> float:
        """The effort on the position, from those of the actuated joints, shape (n,): all motors' together."""
        if self.single:
            return float(effort[self.lead])
        return -float(self.inwards @ effort[self.indices])

    def stroke(self, q: float, v: float) -> tuple[float, float]:
        """Position and speed that belong to a setpoint of the first joint that moves."""
        if self.single:
            return q, v
        return (q - self._lead_closed) / self._lead_span, v / self._lead_span

    def setpoint(self, position: float, speed: float) -> tuple[Array, Array]:
        """Positions and speeds of the driven joints, shape (m,), for those of the gripper."""
        if self.single:
            return np.array([position]), np.array([speed])
        return self._closed + position * self._span, speed * self._span

    def write(self, position: float, speed: float, q: Array, v: Array) -> None:
        """Put such a setpoint where it belongs among those of the actuated joints, shape (n,)."""
        if self.single:
            q[self.lead], v[self.lead] = position, speed
        else:
            q[self.indices], v[self.indices] = self._closed + position * self._span, speed * self._span
