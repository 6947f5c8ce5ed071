"""The way of the foot that is in the air."""

from __future__ import annotations

from kinematics.geometry.planar import PlanarPose, wrapped
from kinematics.geometry.quintic import Quintic
from kinematics.walking.pattern.dcm import NO_SWAY, Cubic

DOWN_EARLY_S = 0.02
"""It is above its place this long before it carries."""


class Swing:
    """A foot on its way; its goal may move while it is under way."""

    def __init__(self, start: PlanarPose, goal: PlanarPose, lift_m: float, duration_s: float) -> None:
        """Lift off at rest.

        Args:
            start, goal: Where it stood, where it is to land.
            lift_m: Height of the arc.
            duration_s: Time in the air.
        """
        self._lift_m = lift_m
        self._duration_s = duration_s
        self._since_s = 0.0
        goal = _near(start, goal)
        self._axes = tuple(
            Quintic.to_rest(a, 0.0, 0.0, b, duration_s - DOWN_EARLY_S)
            for a, b in zip(_numbers(start), _numbers(goal), strict=True)
        )
        self.goal = goal

    def redirect(self, goal: PlanarPose, now_s: float) -> None:
        """Land somewhere else.

        Args:
            goal: Where.
            now_s: Time since the lift-off; from where the foot is then it goes on smoothly.
        """
        left_s = max(self._duration_s - DOWN_EARLY_S - now_s, 0.05)
        states = [axis.at(now_s - self._since_s) for axis in self._axes]
        self.goal = _near(PlanarPose(*(state[0] for state in states)), goal)
        self._axes = tuple(
            Quintic.to_rest(x, v, a, b, left_s)
            for (x, v, a), b in zip(states, _numbers(self.goal), strict=True)
        )
        self._since_s = now_s

    def acceleration_from(self, now_s: float) -> tuple[float, tuple[Cubic, Cubic]]:
        """How long the foot still moves over the floor, and its acceleration meanwhile, m/s^2."""
        since_s = now_s - self._since_s
        x, y, _ = self._axes
        left_s = x.duration_s - since_s
        if left_s <= 0.0:
            return 0.0, NO_SWAY
        return left_s, (x.acceleration_from(since_s), y.acceleration_from(since_s))

    def at(self, t_s: float) -> tuple[PlanarPose, float]:
        """Place and height at a time since the lift-off."""
        x, y, yaw = (axis.at(t_s - self._since_s)[0] for axis in self._axes)
        share = min(max(t_s / self._duration_s, 0.0), 1.0)
        # Velocity and acceleration vanish at both ends.
        height_m = self._lift_m * (4.0 * share * (1.0 - share)) ** 3
        return PlanarPose(x, y, yaw), height_m


def _numbers(pose: PlanarPose) -> tuple[float, float, float]:
    return pose.x_m, pose.y_m, pose.yaw_rad


def _near(start: PlanarPose, goal: PlanarPose) -> PlanarPose:
    """The goal with the heading that is reached the short way."""
    return PlanarPose(goal.x_m, goal.y_m, start.yaw_rad + wrapped(goal.yaw_rad - start.yaw_rad))
