"""The ZMP's way over landings that are planned, and the DCM that it needs at its beginning."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from kinematics.geometry.planar import PlanarPose
from kinematics.model.robot_description import Hand
from kinematics.model.walking_settings import WalkingSettings
from kinematics.walking.pattern.dcm import Cubic, Point, ZmpStretch, dcm_before, zmp_that_leads
from kinematics.walking.pattern.footsteps import OTHER, Footstep
from kinematics.walking.pattern.sole_points import SolePoints
from kinematics.walking.pattern.swing import Swing


class ZmpRoute:
    """Plans where the ZMP goes: from one foot to the next, and between both after the last landing."""

    def __init__(self, settings: WalkingSettings, points: SolePoints, omega: float, sway_s2: float) -> None:
        """Take what stays.

        Args:
            settings: The robot's.
            points: Of its soles.
            omega: Natural frequency of the pendulum, 1/s.
            sway_s2: How far a swinging foot moves the ZMP for each m/s^2 of its acceleration.
        """
        self._settings, self._points, self._omega, self._sway_s2 = settings, points, omega, sway_s2

    def swing(self, zmp: Point, start: PlanarPose, goal: PlanarPose) -> list[ZmpStretch]:
        """A whole swing, with the ZMP at one point."""
        s = self._settings
        moving_s, acceleration = Swing(start, goal, s.lift_m, s.single_support_s).acceleration_from(0.0)
        return self._swaying(zmp, moving_s, acceleration, s.single_support_s - moving_s)

    def rest_of_swing(self, swing: Swing, since_s: float, zmp: Point) -> list[ZmpStretch]:
        """A swing that is under way for so long, with the ZMP at one point from now on."""
        moving_s, acceleration = swing.acceleration_from(since_s)
        still_s = self._settings.single_support_s - since_s - moving_s
        return self._swaying(zmp, moving_s, acceleration, still_s)

    def after_swing(self, feet: Mapping[Hand, PlanarPose], steps: Sequence[Footstep]) -> list[ZmpStretch]:
        """What the ZMP does from the first landing on.

        Args:
            feet: Where they stand before it.
            steps: The landings.
        """
        s, points = self._settings, self._points
        standing = dict(feet)
        stretches: list[ZmpStretch] = []
        for k, step in enumerate(steps):
            start, other = standing[step.side], OTHER[step.side]
            if k > 0:
                stretches += self.swing(points.middle(other, standing[other]), start, step.pose)
            standing[step.side] = step.pose
            old = points.middle(other, standing[other])
            new = points.middle(step.side, step.pose)
            if k == len(steps) - 1:
                stretches.append(ZmpStretch(s.closing_s, old, points.resting(standing)))
            else:
                stretches.append(ZmpStretch(s.double_support_s, old, new))
        return stretches

    def end(self, feet: Mapping[Hand, PlanarPose], steps: Sequence[Footstep]) -> Point:
        """Where it comes to rest."""
        standing = dict(feet)
        for step in steps:
            standing[step.side] = step.pose
        return self._points.resting(standing)

    def dcm_at_landing(self, feet: Mapping[Hand, PlanarPose], steps: Sequence[Footstep]) -> Point:
        """Which DCM the first landing needs."""
        return dcm_before(self.after_swing(feet, steps), self.end(feet, steps), self._omega)

    def leading_zmp(
        self,
        swing: Swing,
        since_s: float,
        dcm: Point,
        feet: Mapping[Hand, PlanarPose],
        steps: Sequence[Footstep],
    ) -> Point:
        """Where the ZMP must stay during the rest of a swing for the landings.

        Args:
            swing: Under way.
            since_s: For so long.
            dcm: Now.
            feet: Where they stand, or stood last.
            steps: The landings, that of the swing first.
        """
        goal = self.dcm_at_landing(feet, steps)
        return zmp_that_leads(lambda zmp: self.rest_of_swing(swing, since_s, zmp), dcm, goal, self._omega)

    def _swaying(
        self, zmp: Point, moving_s: float, acceleration: tuple[Cubic, Cubic], still_s: float
    ) -> list[ZmpStretch]:
        k = self._sway_s2
        (a, b, c, d), (e, f, g, h) = acceleration
        sway = ((k * a, k * b, k * c, k * d), (k * e, k * f, k * g, k * h))
        return [ZmpStretch(moving_s, zmp, zmp, sway), ZmpStretch(still_s, zmp, zmp)]
