"""The walk itself, in its own plan: phases, landings, and what CoM, DCM and ZMP do meanwhile.

From standing the ZMP goes over to the foot that stands first; then feet swing and land in turn; at the
end they stand side by side and the CoM comes to rest above them. Each phase steers the DCM so that it
arrives where the landings that follow need it, beginning where it is: nothing jumps when plans change.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from enum import Enum

from kinematics.robot_description import Hand, SoleDescription
from kinematics.walking.com_motion import ComMotion, ComSample, SettlingCom, SteeredCom
from kinematics.walking.dcm import Cubic, Point, ZmpStretch, dcm_before, zmp_that_leads
from kinematics.walking.footsteps import OTHER, Footstep, FootstepPlanner
from kinematics.walking.planar import PlanarPose, wrapped
from kinematics.walking.settings import WalkingSettings
from kinematics.walking.steering import Halt, SlippingTurn, Steering, VelocitySteering
from kinematics.walking.step_adjustment import farthest_m, legs_reach, missed_by
from kinematics.walking.swing import Swing

_HORIZON = 4
"""Landings ahead: what comes later moves the DCM now by less than 0.1 mm."""
_SLIP_SHARE = 0.4
"""Of the newest step's twist in the mean that turns are corrected by."""
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


class Phase(Enum):
    """What the feet do."""

    SHIFT = "shift"
    SWING = "swing"
    LAND = "land"
    CLOSE = "close"
    SETTLE = "settle"
    REST = "rest"


@dataclass(frozen=True, slots=True)
class PatternSample:
    """One instant, in the plan's frame.

    Attributes:
        com: CoM, DCM and ZMP.
        feet: Each sole's place.
        lift_m: Height of each sole.
        carrying: The feet that carry.
        phase: What they do.
    """

    com: ComSample
    feet: Mapping[Hand, PlanarPose]
    lift_m: Mapping[Hand, float]
    carrying: tuple[Hand, ...]
    phase: Phase


class WalkingPattern:
    """A walk that goes on until it is told to finish, or its steering has arrived.

    Attributes:
        phase: What the feet do now.
        feet: Where both stand, or stood last.
        odom_T_plan: Where the plan is believed to be; whoever measures may correct it.
        steps: Landings so far.
    """

    def __init__(
        self,
        settings: WalkingSettings,
        soles: Mapping[Hand, SoleDescription],
        feet: Mapping[Hand, PlanarPose],
        com: Point,
        rest_m: Point,
        rest_spacing_m: float,
        omega: float,
        sway_s2: float,
    ) -> None:
        """Stand at rest.

        Args:
            settings: The robot's.
            soles: Its soles.
            feet: Where they stand, in the plan's frame.
            com: Where the CoM is above the floor.
            rest_m: Where it rests, seen from the middle between the feet.
            rest_spacing_m: Between the feet at rest.
            omega: Natural frequency of the pendulum, 1/s.
            sway_s2: How far a swinging foot moves the ZMP for each m/s^2 of its acceleration.
        """
        self.feet: dict[Hand, PlanarPose] = dict(feet)
        self.phase = Phase.REST
        self.odom_T_plan = PlanarPose()
        self.steps = 0
        self._settings, self._soles, self._omega = settings, soles, omega
        self._planner = FootstepPlanner(settings, rest_spacing_m)
        self._rest_m, self._sway_s2 = rest_m, sway_s2
        self._steering: Steering = Halt()
        self._slip_rad = 0.0
        self._before = PlanarPose()
        self._body = self._next_body = PlanarPose.between(feet["left"], feet["right"])
        self._standing: Hand = "left"
        self._swing: Swing | None = None
        self._advance = PlanarPose()
        self._queue: list[ComMotion] = []
        self._since_s = 0.0
        self._swing_s = 0.0
        self._last_landing = False
        self._steps: list[Footstep] = []
        self._now = ComSample(com, com, com, com)
        self._motion: ComMotion = SettlingCom(self._now, com, 1.0, omega)

    def locate(self, odom_T_plan: PlanarPose) -> None:
        """Learn where the plan is, once a step; soles that twist on the floor turn it."""
        slipped_rad = wrapped(odom_T_plan.yaw_rad - self.odom_T_plan.yaw_rad)
        self._slip_rad += _SLIP_SHARE * (slipped_rad - self._slip_rad)
        self.odom_T_plan = odom_T_plan

    def steer(self, steering: Steering) -> None:
        """Go somewhere else, from the next landing on; from rest: start."""
        self._steering = steering
        if self.phase is Phase.REST:
            self._begin()

    def finish(self) -> None:
        """Stop as soon as the feet can be brought side by side; nothing more happens at rest."""
        self._steering = Halt()
        if self.phase is Phase.SHIFT:
            self._close()
        elif self.phase is Phase.SWING:
            self._land_beside()

    def catch(self, error: Point) -> bool:
        """Land where the DCM is going to be, if the sole that stands cannot bring it to the landing.

        Args:
            error: The DCM as measured, less the plan's, m.

        Returns:
            Whether the landing was moved.
        """
        swing, left_s = self._swing, self._settings.single_support_s - self._swing_s
        if self.phase is not Phase.SWING or swing is None or left_s < _CATCH_S:
            return False
        dcm = self._now.dcm[0] + error[0], self._now.dcm[1] + error[1]
        wanted = dcm_before(self._after_swing(self._steps), self._end(self._steps), self._omega)
        inset_m = self._settings.zmp_inset_m
        x, y = missed_by(self._on_one_now, lambda zmp: self._on_sole(zmp, inset_m), dcm, wanted, self._omega)
        far_m = math.hypot(x, y)
        if far_m < _CAUGHT_M:
            return False
        most = min(far_m - _CAUGHT_M, farthest_m(left_s, _CATCH_M_S2)) / far_m
        return any(self._land_elsewhere(swing, (most * k * x, most * k * y)) for k in _CATCH_SHARES)

    @property
    def goal(self) -> PlanarPose | None:
        """Where the foot in the air is going to land."""
        return self._swing.goal if self._swing is not None else None

    def advance(self, period_s: float) -> PatternSample:
        """Go on by a control period."""
        self._since_s += period_s
        self._swing_s += period_s
        while self.phase is not Phase.REST and self._since_s >= self._motion.duration_s - 1e-9:
            self._now = self._motion.at(self._motion.duration_s)
            self._since_s -= self._motion.duration_s
            if self._queue:
                self._motion = self._queue.pop(0)
            else:
                self._next_phase()
        sample = self._motion.at(self._since_s)
        self._now = sample
        feet = dict(self.feet)
        lift_m: dict[Hand, float] = {"left": 0.0, "right": 0.0}
        carrying: tuple[Hand, ...] = ("left", "right")
        if self.phase is Phase.SWING and self._swing is not None:
            side = OTHER[self._standing]
            feet[side], lift_m[side] = self._swing.at(self._swing_s)
            carrying = (self._standing,)
        return PatternSample(sample, feet, lift_m, carrying, self.phase)

    # ---------------------------------------------------------------- phases

    def _next_phase(self) -> None:
        if self.phase is Phase.SWING and self._swing is not None:
            side = OTHER[self._standing]
            self.feet[side] = self._swing.goal
            self._before, self._standing, self._swing = self._advance, side, None
            self._body = self._next_body
            self.steps += 1
            if not self._last_landing and self._plan():
                self._land()
            else:  # the DCM comes to rest between the feet: no further step can be made before that
                self._close()
        elif self.phase in (Phase.SHIFT, Phase.LAND):
            self._lift()
        elif self.phase is Phase.CLOSE:
            self._settle()
        else:
            rest = self._motion.at(self._motion.duration_s)
            self._motion, self._since_s = SettlingCom(rest, rest.com, 1.0, self._omega), 0.0
            self.phase = Phase.REST
            self._before = PlanarPose()
            self._begin()

    def _begin(self) -> None:
        side = self._planner.first_side(self._steering, self.feet, self.odom_T_plan)
        self._standing = OTHER[side]
        steps = self._plan()
        if not steps:
            return
        zmp = self._over(self._standing, self.feet[self._standing])
        first = self._on_one(zmp, self.feet[steps[0].side], steps[0].pose)
        goal = dcm_before([*first, *self._after_swing(steps)], self._end(steps), self._omega)
        self.phase = Phase.SHIFT
        self._bend(goal, zmp, self._settings.first_shift_s)

    def _lift(self) -> None:
        steps = self._plan()
        if not steps:
            self._close()
            return
        side = OTHER[self._standing]
        self._steps = steps
        self._advance, self._next_body = steps[0].advance, steps[0].body
        swing_s = self._settings.single_support_s
        self._swing = Swing(self.feet[side], steps[0].pose, self._settings.lift_m, swing_s)
        self.phase, self._swing_s = Phase.SWING, 0.0
        self._last_landing = len(steps) == 1
        self._balance_on_one(steps)

    def _land(self) -> None:
        zmp = self._over(self._standing, self.feet[self._standing])
        self.phase = Phase.LAND
        self._go(ZmpStretch(self._settings.double_support_s, self._now.zmp, zmp))

    def _close(self) -> None:
        rest = self._resting_com()
        self.phase = Phase.CLOSE
        self._swing = None
        self._bend(rest, rest, self._settings.closing_s)

    def _settle(self) -> None:
        self.phase, self._since_s = Phase.SETTLE, 0.0
        self._motion = SettlingCom(self._now, self._resting_com(), self._settings.settle_s, self._omega)

    def _land_beside(self) -> None:
        """Bring the foot in the air beside the other one, if the DCM can be held meanwhile."""
        swing, left_s = self._swing, self._settings.single_support_s - self._swing_s
        if swing is None or left_s < _REDIRECT_S:
            return
        side = OTHER[self._standing]
        beside = self._planner.beside(side, self.feet[self._standing])
        body = PlanarPose.between(self.feet[self._standing], beside)
        after = [Footstep(side, beside, PlanarPose(), body)]
        before = swing.goal
        swing.redirect(beside, self._swing_s)
        zmp = self._steering_zmp(after)
        if self._on_sole(zmp, _QUICK_STOP_INSET_M) != zmp:
            swing.redirect(before, self._swing_s)
            return
        self._steps = after
        self._advance, self._next_body = PlanarPose(), body
        self._last_landing = True
        self._balance_on_one(after)

    def _land_elsewhere(self, swing: Swing, by: Point) -> bool:
        """Move the landing, if the legs reach so far; the plan's DCM goes there with it."""
        first, standing = self._steps[0], self.feet[self._standing]
        before = swing.goal
        moved = PlanarPose(before.x_m + by[0], before.y_m + by[1], before.yaw_rad)
        landing = self._planner.within_stride(first.side, standing, moved)
        if landing.distance_m(before) < _WORTH_M:
            return False
        body = landing @ first.pose.inverse() @ first.body
        feet = {**self.feet, first.side: landing}
        later = self._planner.plan(
            first.side, feet, body, self._steering, first.advance, self.odom_T_plan, _HORIZON - 1
        )
        steps = [Footstep(first.side, landing, first.advance, body), *later]
        swing.redirect(landing, self._swing_s)
        stretches = self._on_one_now(self._steering_zmp(steps))
        left_s = sum(stretch.duration_s for stretch in stretches)
        reach_m = self._settings.stride_reach_m
        on = [*stretches, *self._after_swing(steps)[:1]]
        com, dcm = self._now.com, self._now.dcm
        if not legs_reach(on, com, dcm, self._omega, [standing], landing, left_s, reach_m):
            swing.redirect(before, self._swing_s)
            return False
        self._steps, self._next_body = steps, body
        self._last_landing = len(steps) == 1
        self._go(*stretches)
        return True

    # ---------------------------------------------------------------- the DCM's way

    def _balance_on_one(self, steps: list[Footstep]) -> None:
        self._go(*self._on_one_now(self._on_sole(self._steering_zmp(steps), self._settings.zmp_inset_m)))

    def _steering_zmp(self, steps: list[Footstep]) -> Point:
        """Where the ZMP must stay during the rest of the swing for what follows."""
        goal = dcm_before(self._after_swing(steps), self._end(steps), self._omega)
        return zmp_that_leads(self._on_one_now, self._now.dcm, goal, self._omega)

    def _on_one_now(self, zmp: Point) -> list[ZmpStretch]:
        """The rest of the swing that is under way."""
        if self._swing is None:
            return []
        moving_s, acceleration = self._swing.acceleration_from(self._swing_s)
        still_s = self._settings.single_support_s - self._swing_s - moving_s
        return self._swaying(zmp, moving_s, acceleration, still_s)

    def _on_one(self, zmp: Point, start: PlanarPose, goal: PlanarPose) -> list[ZmpStretch]:
        """A whole swing."""
        s = self._settings
        moving_s, acceleration = Swing(start, goal, s.lift_m, s.single_support_s).acceleration_from(0.0)
        return self._swaying(zmp, moving_s, acceleration, s.single_support_s - moving_s)

    def _swaying(
        self, zmp: Point, moving_s: float, acceleration: tuple[Cubic, Cubic], still_s: float
    ) -> list[ZmpStretch]:
        k = self._sway_s2
        (a, b, c, d), (e, f, g, h) = acceleration
        sway = ((k * a, k * b, k * c, k * d), (k * e, k * f, k * g, k * h))
        return [ZmpStretch(moving_s, zmp, zmp, sway), ZmpStretch(still_s, zmp, zmp)]

    def _go(self, *stretches: ZmpStretch) -> None:
        self._since_s = 0.0
        com, dcm = self._now.com, self._now.dcm
        motions = []
        for stretch in stretches:
            motion = SteeredCom(stretch, com, dcm, self._omega)
            end = motion.at(stretch.duration_s)
            com, dcm = end.com, end.dcm
            motions.append(motion)
        self._motion, self._queue = motions[0], list(motions[1:])

    def _bend(self, goal: Point, zmp: Point, duration_s: float) -> None:
        """Take the ZMP somewhere, bent half-way so that the DCM arrives where it is wanted."""
        start, half_s = self._now.zmp, 0.5 * duration_s

        def through(knot: Point) -> list[ZmpStretch]:
            return [ZmpStretch(half_s, start, knot), ZmpStretch(half_s, knot, zmp)]

        self._go(*through(zmp_that_leads(through, self._now.dcm, goal, self._omega)))

    def _after_swing(self, steps: list[Footstep]) -> list[ZmpStretch]:
        """What the ZMP does after the swing that is under way or next."""
        s = self._settings
        feet = dict(self.feet)
        stretches: list[ZmpStretch] = []
        for k, step in enumerate(steps):
            start = feet[step.side]
            if k > 0:
                stretches += self._on_one(
                    self._over(OTHER[step.side], feet[OTHER[step.side]]), start, step.pose
                )
            feet[step.side] = step.pose
            old = self._over(OTHER[step.side], feet[OTHER[step.side]])
            new = self._over(step.side, step.pose)
            if k == len(steps) - 1:
                stretches.append(ZmpStretch(s.closing_s, old, self._resting_over(feet)))
            else:
                stretches.append(ZmpStretch(s.double_support_s, old, new))
        return stretches

    def _end(self, steps: list[Footstep]) -> Point:
        feet = dict(self.feet)
        for step in steps:
            feet[step.side] = step.pose
        return self._resting_over(feet)

    def _plan(self) -> list[Footstep]:
        steering = self._steering
        if isinstance(steering, VelocitySteering) and steering.angular_rad_s != 0.0:
            steering = SlippingTurn(steering, self._slip_rad)
        return self._planner.plan(
            self._standing, self.feet, self._body, steering, self._before, self.odom_T_plan, _HORIZON
        )

    # ---------------------------------------------------------------- places

    def _resting_com(self) -> Point:
        return self._resting_over(self.feet)

    def _resting_over(self, feet: Mapping[Hand, PlanarPose]) -> Point:
        pose = PlanarPose.between(feet["left"], feet["right"]) @ PlanarPose(*self._rest_m)
        return pose.x_m, pose.y_m

    def _over(self, side: Hand, foot: PlanarPose) -> Point:
        """Where the ZMP is when a foot stands alone: the middle of its sole."""
        sole = self._soles[side]
        pose = foot @ PlanarPose(0.5 * sum(sole.x_m), 0.5 * sum(sole.y_m))
        return pose.x_m, pose.y_m

    def _on_sole(self, zmp: Point, inset: float) -> Point:
        """The point of the standing foot's sole, less an inset, nearest to a ZMP."""
        foot, sole = self.feet[self._standing], self._soles[self._standing]
        seen = foot.to(PlanarPose(*zmp))
        x = min(max(seen.x_m, sole.x_m[0] + inset), sole.x_m[1] - inset)
        y = min(max(seen.y_m, sole.y_m[0] + inset), sole.y_m[1] - inset)
        if x == seen.x_m and y == seen.y_m:
            return zmp
        pose = foot @ PlanarPose(x, y)
        return pose.x_m, pose.y_m
