"""Where the feet land."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from kinematics.geometry.planar import PlanarPose
from kinematics.model.robot_description import Hand
from kinematics.model.walking_settings import WalkingSettings
from kinematics.walking.pattern.steering import Steering

Feet = Mapping[Hand, PlanarPose]

OTHER: Mapping[Hand, Hand] = {"left": "right", "right": "left"}
_LEFTWARDS: Mapping[Hand, float] = {"left": 1.0, "right": -1.0}
_CLOSED_M = 0.008
_CLOSED_RAD = 0.012
"""Feet that stand so near to their places beside each other need no closing step."""


@dataclass(frozen=True, slots=True)
class Footstep:
    """One landing of a foot.

    Attributes:
        side: Which foot.
        pose: Where its sole lands, in the plan's frame.
        advance: How far the body goes with this step, in its own frame before it.
        body: Where the body is after it, in the plan's frame.
    """

    side: Hand
    pose: PlanarPose
    advance: PlanarPose
    body: PlanarPose


class FootstepPlanner:
    """Makes landings of a steering, each within reach of the foot that stands."""

    def __init__(self, settings: WalkingSettings, rest_spacing_m: float) -> None:
        """Plan for a robot.

        Args:
            settings: Its reach.
            rest_spacing_m: Between its feet when it stands.
        """
        self._settings = settings
        self._rest_m = rest_spacing_m

    def foot_under(self, side: Hand, body: PlanarPose, last: bool) -> PlanarPose:
        """Where a foot stands when the body is here: nearer to the middle where it is going to rest."""
        spacing_m = self._rest_m if last else self._settings.spacing_m
        return body @ PlanarPose(0.0, 0.5 * _LEFTWARDS[side] * spacing_m)

    def beside(self, side: Hand, foot: PlanarPose) -> PlanarPose:
        """Where a foot rests beside the other one."""
        return foot @ PlanarPose(0.0, _LEFTWARDS[side] * self._rest_m)

    def within_stride(self, side: Hand, standing: PlanarPose, landing: PlanarPose) -> PlanarPose:
        """The landing, moved to where the foot can still go when it has to catch the body."""
        s = self._settings
        seen = standing.to(landing)
        x = min(max(seen.x_m, -s.stride_backward_m), s.stride_forward_m)
        across = min(max(_LEFTWARDS[side] * seen.y_m, s.narrowest_m), s.stride_widest_m)
        return standing @ PlanarPose(x, _LEFTWARDS[side] * across, seen.yaw_rad)

    def first_side(self, steering: Steering, feet: Feet, odom_T_plan: PlanarPose) -> Hand:
        """Which foot steps first: the one on the side of the turn."""
        body = odom_T_plan @ PlanarPose.between(feet["left"], feet["right"])
        advance = steering.advance(body, PlanarPose())
        if advance is None:
            return "right"
        return "left" if advance.yaw_rad > 1e-3 or advance.y_m > 1e-3 else "right"

    def plan(
        self,
        standing: Hand,
        feet: Feet,
        body: PlanarPose,
        steering: Steering,
        before: PlanarPose,
        odom_T_plan: PlanarPose,
        horizon: int,
    ) -> list[Footstep]:
        """Landings that follow, ending with the feet side by side.

        Args:
            standing: The foot that stands while the first of them swings.
            feet: Where both stand, or stood last.
            body: Where the body is when the standing foot carries it.
            steering: Where to go.
            before: How far the body went with the step before.
            odom_T_plan: Where the plan's frame is in the odometry frame.
            horizon: How many steps to look ahead.

        Returns:
            Nothing, when the feet stand side by side and there is nowhere to go.
        """
        steps: list[Footstep] = []
        side, foot = standing, feet[standing]
        behind = feet[OTHER[standing]]
        advance = steering.advance(odom_T_plan @ body, before)
        for _ in range(horizon):
            if advance is None:
                break
            body = body @ advance
            then = steering.advance(odom_T_plan @ body, advance)
            wanted = self.foot_under(OTHER[side], body, last=then is None)
            landing = self._within_reach(OTHER[side], foot, wanted)
            # a foot that could not go so far takes the body less far as well
            body = landing @ wanted.inverse() @ body
            behind, side, foot = foot, OTHER[side], landing
            steps.append(Footstep(side, landing, advance, body))
            advance = then
        closing = self.beside(OTHER[side], foot)
        off = closing.to(behind)
        if not steps and abs(off.x_m) + abs(off.y_m) < _CLOSED_M and abs(off.yaw_rad) < _CLOSED_RAD:
            return steps
        steps.append(Footstep(OTHER[side], closing, PlanarPose(), PlanarPose.between(foot, closing)))
        return steps

    def _within_reach(self, side: Hand, standing: PlanarPose, landing: PlanarPose) -> PlanarPose:
        """The landing, moved to where the foot can go without touching the one that stands."""
        seen = standing.to(landing)
        across = _LEFTWARDS[side] * seen.y_m
        limited = min(max(across, min(self._settings.narrowest_m, self._rest_m)), self._settings.widest_m)
        return standing @ PlanarPose(seen.x_m, _LEFTWARDS[side] * limited, seen.yaw_rad)
