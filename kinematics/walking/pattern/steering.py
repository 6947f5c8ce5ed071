"""What decides how far the body goes with the next step: a velocity, or a path."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Protocol

from kinematics.geometry.planar import PlanarPose, wrapped
from kinematics.model.walking_settings import WalkingSettings

_STILL = 1e-6
_ARRIVED_M = 0.006
_ARRIVED_RAD = 0.008
_NEAR_M = 0.35
"""Nearer than this to the goal, the body goes straight for its pose, sideways if need be."""
_AHEAD_M = 0.4
"""The body heads for the point of the path so far ahead."""
PACE = 0.75
"""Share of the longest step that a path is walked with."""
_TURN_PACE = 0.5
"""Share of the widest turn: soles slip in wider ones."""
_LAST_PACE = 0.5
"""The same for the last steps, which may go in any direction."""


class Steering(Protocol):
    """Decides how far the body goes with each step."""

    def advance(self, body: PlanarPose, before: PlanarPose) -> PlanarPose | None:
        """How far to go next, in the body's frame; None to stop.

        Args:
            body: Where the body is, in the odometry frame.
            before: How far it went with the step before; nowhere from standing.
        """
        ...


_MOST_STEPS = 500
_BETWEEN = 4


def foreseen(steering: Steering, body: PlanarPose) -> list[PlanarPose]:
    """Where the body comes by if each step goes as it is told, from standing on, four places a step."""
    places, before = [body], PlanarPose()
    for _ in range(_MOST_STEPS):
        step = steering.advance(body, before)
        if step is None:
            break
        for k in range(1, _BETWEEN + 1):
            share = k / _BETWEEN
            places.append(body @ PlanarPose(share * step.x_m, share * step.y_m, share * step.yaw_rad))
        body, before = body @ step, step
    return places


class Halt:
    """The steering of a robot that shall stand: it goes nowhere."""

    def advance(self, body: PlanarPose, before: PlanarPose) -> PlanarPose | None:  # noqa: ARG002
        """Stop."""
        return None


_QUICK_SWING, _QUICK_LANDING, _QUICK_CLOSING, _QUICK_SETTLING = 0.84, 0.85, 0.9, 0.67
"""Of the usual times. Told to stop just after a foot has left the floor, a walk of TALOS rests 1.7 s later,
not 2.1; the strides of 0.3 m/s are short enough for a swing of 0.42 s."""


def quickened(settings: WalkingSettings) -> WalkingSettings:
    """Settings of a walk in quicker, shorter steps, which stands sooner after it was told to stop.

    Args:
        settings: The robot's.
    """
    return replace(
        settings,
        single_support_s=_QUICK_SWING * settings.single_support_s,
        double_support_s=_QUICK_LANDING * settings.double_support_s,
        closing_s=_QUICK_CLOSING * settings.closing_s,
        settle_s=_QUICK_SETTLING * settings.settle_s,
    )


@dataclass(frozen=True, slots=True)
class VelocitySteering:
    """Go on at a velocity, reached by and by; a velocity of zero stops.

    Attributes:
        settings: The robot's.
        linear_m_s, angular_rad_s: Forwards, and to the left.
        quick: Whether by ``quickened`` steps; a walk that sets out with such steps keeps to them.
    """

    settings: WalkingSettings
    linear_m_s: float
    angular_rad_s: float
    quick: bool = False

    def advance(self, body: PlanarPose, before: PlanarPose) -> PlanarPose | None:  # noqa: ARG002
        """A step nearer to the velocity that is wanted."""
        s = quickened(self.settings) if self.quick else self.settings
        step_s = s.step_s
        if abs(self.linear_m_s) < _STILL and abs(self.angular_rad_s) < _STILL:
            return None
        x = _towards(before.x_m, self.linear_m_s * step_s, s.acceleration_m_s2 * step_s**2)
        yaw = _towards(before.yaw_rad, self.angular_rad_s * step_s, s.turn_acceleration_rad_s2 * step_s**2)
        # The middle of the chord, so that equal steps lie on a circle.
        x = min(max(x, -s.backward_m), s.forward_m)
        yaw = min(max(yaw, -s.turn_rad), s.turn_rad)
        return PlanarPose(x * math.cos(0.5 * yaw), x * math.sin(0.5 * yaw), yaw)


@dataclass(frozen=True, slots=True)
class TurnSteering:
    """Turn on the spot to a heading, the way round that the speed says; less than half a turn is left.

    Attributes:
        settings: The robot's.
        angular_rad_s: The speed, to the left.
        heading_rad: Where to, in the odometry frame.
    """

    settings: WalkingSettings
    angular_rad_s: float
    heading_rad: float

    def advance(self, body: PlanarPose, before: PlanarPose) -> PlanarPose | None:
        """A step of that speed, or what is left."""
        way = math.copysign(1.0, self.angular_rad_s)
        left_rad = way * wrapped(self.heading_rad - body.yaw_rad)
        step = VelocitySteering(self.settings, 0.0, self.angular_rad_s).advance(body, before)
        if step is None or left_rad < _ARRIVED_RAD:
            return None
        return PlanarPose(yaw_rad=way * min(abs(step.yaw_rad), left_rad))


@dataclass(frozen=True, slots=True)
class SlippingTurn:
    """A velocity, reached although soles twist on the floor while the body turns.

    Attributes:
        wanted: The velocity.
        slip_rad: How far the soles have twisted of late with each step, to the left; so much less is planned.
    """

    wanted: VelocitySteering | TurnSteering
    slip_rad: float

    def advance(self, body: PlanarPose, before: PlanarPose) -> PlanarPose | None:
        """The step that, with the slip, is the wanted one."""
        step = self.wanted.advance(body, PlanarPose(before.x_m, before.y_m, before.yaw_rad + self.slip_rad))
        if step is None:
            return None
        return PlanarPose(step.x_m, step.y_m, step.yaw_rad - self.slip_rad)


@dataclass(frozen=True, slots=True)
class StretchSteering:
    """Go a distance straight on, or back, and stop there.

    Attributes:
        settings: The robot's.
        start: Where it begins, in the odometry frame.
        linear_m_s: The speed, negative to go back.
        distance_m: How far.
    """

    settings: WalkingSettings
    start: PlanarPose
    linear_m_s: float
    distance_m: float

    def advance(self, body: PlanarPose, before: PlanarPose) -> PlanarPose | None:
        """A step of that speed, or what is left."""
        seen = self.start.to(body)
        ahead = math.copysign(1.0, self.linear_m_s)
        left_m = self.distance_m - ahead * seen.x_m
        if left_m < _ARRIVED_M:
            return None
        step = VelocitySteering(self.settings, self.linear_m_s, 0.0).advance(body, before)
        if step is None:
            return None
        turn = min(max(-seen.yaw_rad, -0.1), 0.1)  # keep to the line
        return PlanarPose(ahead * min(abs(step.x_m), left_m), 0.0, turn)


class PathSteering:
    """Follow a path and stop at its end, with the heading that is wanted there.

    Attributes:
        path: Poses in the odometry frame.
        goal: The last of them.
        pace: Share of the longest step that it is walked with.
    """

    def __init__(self, settings: WalkingSettings, path: Sequence[PlanarPose], pace: float = PACE) -> None:
        """Follow poses in the odometry frame; headings of all but the last one are not used."""
        self._settings, self.pace = settings, pace
        self.path = tuple(path)
        self.goal = self.path[-1]

    def advance(self, body: PlanarPose, before: PlanarPose) -> PlanarPose | None:
        """A step along the path."""
        left = body.to(self.goal)
        distance_m = math.hypot(left.x_m, left.y_m)
        if distance_m < _ARRIVED_M and abs(left.yaw_rad) < _ARRIVED_RAD:
            return None
        carrot, to_go_m = self._carrot(body)
        if min(to_go_m, distance_m) < _NEAR_M:  # a path may come by its end earlier on
            return self._straight_to(left)
        s = self._settings
        seen = body.to(carrot)
        heading = math.atan2(seen.y_m, seen.x_m)
        widest = _TURN_PACE * s.turn_rad
        yaw = min(max(heading, -widest), widest)
        if abs(heading) > 0.6:  # turn first, go then
            return PlanarPose(0.0, 0.0, yaw)
        longest_m = min(self.pace * s.forward_m, before.x_m + s.acceleration_m_s2 * s.step_s**2)
        x = min(longest_m * math.cos(heading), to_go_m)
        return PlanarPose(x * math.cos(0.5 * yaw), x * math.sin(0.5 * yaw), yaw)

    def _straight_to(self, left: PlanarPose) -> PlanarPose:
        """An equal share of what is left, in steps that are short enough."""
        s = self._settings
        most_x = _LAST_PACE * (s.forward_m if left.x_m > 0.0 else s.backward_m)
        steps = max(
            abs(left.x_m) / most_x,
            abs(left.y_m) / (_LAST_PACE * s.sideways_m),
            abs(left.yaw_rad) / (_TURN_PACE * s.turn_rad),
            1.0,
        )
        share = 1.0 / math.ceil(steps)
        return PlanarPose(share * left.x_m, share * left.y_m, share * left.yaw_rad)

    def _carrot(self, body: PlanarPose) -> tuple[PlanarPose, float]:
        """A point of the path some way ahead of the place nearest to the body, and the way from there on.

        Returns:
            The point, and the length of the path from the nearest place to its end.
        """
        path = self.path
        if len(path) == 1:
            return path[0], body.distance_m(path[0])
        best = (math.inf, 0, 0.0)
        for k in range(len(path) - 1):
            distance_m, share = _nearest_on(path[k], path[k + 1], body)
            if distance_m < best[0] - 1e-9:
                best = (distance_m, k, share)
        _, k, share = best
        lengths = [path[i].distance_m(path[i + 1]) for i in range(len(path) - 1)]
        to_go_m = (1.0 - share) * lengths[k] + sum(lengths[k + 1 :])
        ahead_m = _AHEAD_M + share * lengths[k]
        while k < len(lengths) - 1 and ahead_m > lengths[k]:
            ahead_m -= lengths[k]
            k += 1
        along = min(1.0, ahead_m / max(lengths[k], 1e-9))
        a, b = path[k], path[k + 1]
        point = PlanarPose(a.x_m + along * (b.x_m - a.x_m), a.y_m + along * (b.y_m - a.y_m))
        return point, max(to_go_m, best[0] if to_go_m < 1e-9 else to_go_m)


def _towards(value: float, goal: float, most: float) -> float:
    return value + min(max(goal - value, -most), most)


def _nearest_on(a: PlanarPose, b: PlanarPose, point: PlanarPose) -> tuple[float, float]:
    """Distance of a point from a line, and the share of the line at the foot."""
    dx, dy = b.x_m - a.x_m, b.y_m - a.y_m
    length = dx * dx + dy * dy
    share = 0.0
    if length > 0.0:
        share = min(max(((point.x_m - a.x_m) * dx + (point.y_m - a.y_m) * dy) / length, 0.0), 1.0)
    return math.hypot(a.x_m + share * dx - point.x_m, a.y_m + share * dy - point.y_m), share
