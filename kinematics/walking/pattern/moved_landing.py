"""Landings that are moved while the foot is in the air: beside the other one to stop, or with a push."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

from kinematics.geometry.planar import PlanarPose
from kinematics.model.robot_description import Hand
from kinematics.model.walking_settings import WalkingSettings
from kinematics.walking.pattern.com_motion import ComSample
from kinematics.walking.pattern.dcm import Point, ZmpStretch
from kinematics.walking.pattern.footsteps import OTHER, Footstep, FootstepPlanner
from kinematics.walking.pattern.sole_points import SolePoints
from kinematics.walking.pattern.steering import Steering
from kinematics.walking.pattern.step_adjustment import farthest_m, legs_reach, missed_by
from kinematics.walking.pattern.swing import Swing
from kinematics.walking.pattern.zmp_route import ZmpRoute

HORIZON = 4
"""Landings ahead: what comes later moves the DCM now by less than 0.1 mm."""

_REDIRECT_S = 0.25
"""A foot that lands sooner than this goes where it was going."""
_QUICK_STOP_INSET_M = 0.045
"""A landing is brought nearer only if the ZMP stays this far inside the sole: what is left is needed to
correct errors. With 0.01 a quick stop from 0.45 m/s backwards rocked the robot onto its edges."""

_CATCH_S = 0.2
"""A foot that lands sooner than this goes where it was going, whatever pushes."""
_CAUGHT_M = 0.05
"""So far beside where it is wanted the DCM may end: two soles bring it back. A landing that moved
by all of it came too wide after a push from aside, and threw the robot to the other side with each step."""
_WORTH_M = 0.015
"""Landings move by no less."""
_CATCH_SHARES = (1.0, 0.75, 0.5, 0.25)
"""Of the distance that a landing would have to move: the first one within reach."""
_CATCH_M_S2 = 10.0
"""More acceleration of the swinging foot than this is not asked for."""


@dataclass(frozen=True, slots=True)
class UnderWay:
    """A step that is under way.

    Attributes:
        swing: The foot in the air; it is redirected when its landing moves.
        since_s: Since its lift-off.
        standing: The other foot.
        feet: Where both stand, or stood last.
        steps: The landings that are planned, its own first.
        now: The plan's CoM and DCM.
    """

    swing: Swing
    since_s: float
    standing: Hand
    feet: Mapping[Hand, PlanarPose]
    steps: list[Footstep]
    now: ComSample


@dataclass(frozen=True, slots=True)
class MovedLanding:
    """What is planned after a landing has moved.

    Attributes:
        steps: The landings.
        stretches: What the ZMP does until the first one.
    """

    steps: list[Footstep]
    stretches: list[ZmpStretch]


class LandingMover:
    """Moves the landing of a step that is under way, if DCM and legs allow it."""

    def __init__(
        self,
        settings: WalkingSettings,
        planner: FootstepPlanner,
        points: SolePoints,
        route: ZmpRoute,
        omega: float,
    ) -> None:
        """Take what stays: the robot's settings, its steps, its soles, the ZMP's way, and 1/s."""
        self._settings, self._planner, self._omega = settings, planner, omega
        self._points, self._route = points, route

    def beside(self, step: UnderWay) -> MovedLanding | None:
        """Bring the foot in the air beside the other one, if the DCM can be held meanwhile."""
        swing = step.swing
        if self._left_s(step) < _REDIRECT_S:
            return None
        side, foot = OTHER[step.standing], step.feet[step.standing]
        beside = self._planner.beside(side, foot)
        after = [Footstep(side, beside, PlanarPose(), PlanarPose.between(foot, beside))]
        before = swing.goal
        swing.redirect(beside, step.since_s)
        zmp = self._leading(step, after)
        if self._points.nearest(zmp, step.standing, foot, _QUICK_STOP_INSET_M) != zmp:
            swing.redirect(before, step.since_s)
            return None
        kept = self._points.nearest(zmp, step.standing, foot, self._settings.zmp_inset_m)
        stretches = self._route.rest_of_swing(swing, step.since_s, kept)
        if not self._reached(step, after, stretches):
            swing.redirect(before, step.since_s)
            return None
        return MovedLanding(after, stretches)

    def caught(
        self, step: UnderWay, error: Point, steering: Steering, odom_T_plan: PlanarPose
    ) -> MovedLanding | None:
        """Land where the DCM is going to be, if the sole that stands cannot bring it to the landing.

        Args:
            step: Under way.
            error: The DCM as measured, less the plan's, m.
            steering: Where to go afterwards.
            odom_T_plan: Where the plan is.
        """
        left_s = self._left_s(step)
        if left_s < _CATCH_S:
            return None
        route, inset_m = self._route, self._settings.zmp_inset_m
        dcm = step.now.dcm[0] + error[0], step.now.dcm[1] + error[1]
        x, y = missed_by(
            lambda zmp: route.rest_of_swing(step.swing, step.since_s, zmp),
            lambda zmp: self._points.nearest(zmp, step.standing, step.feet[step.standing], inset_m),
            dcm,
            route.dcm_at_landing(step.feet, step.steps),
            self._omega,
        )
        far_m = math.hypot(x, y)
        if far_m < _CAUGHT_M:
            return None
        most = min(far_m - _CAUGHT_M, farthest_m(left_s, _CATCH_M_S2)) / far_m
        for k in _CATCH_SHARES:
            moved = self._elsewhere(step, (most * k * x, most * k * y), steering, odom_T_plan)
            if moved is not None:
                return moved
        return None

    def _elsewhere(
        self, step: UnderWay, by: Point, steering: Steering, odom_T_plan: PlanarPose
    ) -> MovedLanding | None:
        """Move the landing, if the legs reach so far; the plan's DCM goes there with it."""
        swing, first, standing = step.swing, step.steps[0], step.feet[step.standing]
        before = swing.goal
        moved = PlanarPose(before.x_m + by[0], before.y_m + by[1], before.yaw_rad)
        landing = self._planner.within_stride(first.side, standing, moved)
        if landing.distance_m(before) < _WORTH_M:
            return None
        body = landing @ first.pose.inverse() @ first.body
        feet = {**step.feet, first.side: landing}
        later = self._planner.plan(first.side, feet, body, steering, first.advance, odom_T_plan, HORIZON - 1)
        steps = [Footstep(first.side, landing, first.advance, body), *later]
        swing.redirect(landing, step.since_s)
        stretches = self._route.rest_of_swing(swing, step.since_s, self._leading(step, steps))
        if not self._reached(step, steps, stretches):
            swing.redirect(before, step.since_s)
            return None
        return MovedLanding(steps, stretches)

    def _reached(self, step: UnderWay, steps: list[Footstep], stretches: list[ZmpStretch]) -> bool:
        """Whether the legs reach the foot that stands and the one in the air, until both carry."""
        on = [*stretches, *self._route.after_swing(step.feet, steps)[:1]]
        return legs_reach(
            on,
            step.now.com,
            step.now.dcm,
            self._omega,
            step.feet[step.standing],
            lambda t_s: step.swing.at(step.since_s + t_s)[0],
            self._settings.stride_reach_m,
        )

    def _left_s(self, step: UnderWay) -> float:
        return self._settings.single_support_s - step.since_s

    def _leading(self, step: UnderWay, steps: list[Footstep]) -> Point:
        return self._route.leading_zmp(step.swing, step.since_s, step.now.dcm, step.feet, steps)
