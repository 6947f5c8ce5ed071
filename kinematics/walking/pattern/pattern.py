"""The walk itself, in its own plan: phases, landings, and what CoM, DCM and ZMP do meanwhile.

From standing the ZMP goes over to the foot that stands first; then feet swing and land in turn; at the
end they stand side by side and the CoM comes to rest above them. Each phase steers the DCM so that it
arrives where the landings that follow need it, beginning where it is: nothing jumps when plans change.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from kinematics.geometry.planar import PlanarPose, wrapped
from kinematics.model.robot_description import Hand, SoleDescription
from kinematics.model.walking_settings import WalkingSettings
from kinematics.walking.pattern.com_motion import ComMotion, ComSample, SettlingCom, SteeredCom
from kinematics.walking.pattern.dcm import Point, ZmpStretch, dcm_before, zmp_that_leads
from kinematics.walking.pattern.footsteps import OTHER, Footstep, FootstepPlanner
from kinematics.walking.pattern.moved_landing import HORIZON, LandingMover, MovedLanding, UnderWay
from kinematics.walking.pattern.pattern_sample import PatternSample, Phase
from kinematics.walking.pattern.sole_points import SolePoints
from kinematics.walking.pattern.steering import Halt, SlippingTurn, Steering, TurnSteering, VelocitySteering
from kinematics.walking.pattern.step_on import SHIFT_S, SteppingOn, stepping_on
from kinematics.walking.pattern.swing import Swing
from kinematics.walking.pattern.zmp_route import ZmpRoute

_TIPS_INSET_M = 0.01
"""Nothing nearer to the edge of both soles can be held: the ZMP goes no farther out."""
_SLIP_SHARE = 0.4
"""Of the newest step's twist in the mean that turns are corrected by."""


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
        self._settings, self._omega = settings, omega
        self._planner = FootstepPlanner(settings, rest_spacing_m)
        self._points = SolePoints(soles, rest_m)
        self._route = ZmpRoute(settings, self._points, omega, sway_s2)
        self._mover = LandingMover(settings, self._planner, self._points, self._route, omega)
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
            self._begin(self._settings.first_shift_s)

    def finish(self) -> None:
        """Stop as soon as the feet can be brought side by side; nothing more happens at rest."""
        if isinstance(self._steering, SteppingOn):  # to stop in the middle of that is to fall
            self._steering = replace(self._steering, then=Halt())
            return
        self._steering = Halt()
        if self.phase is Phase.SHIFT:
            self._close()
        elif (step := self._under_way()) is not None:
            self._move_landing(self._mover.beside(step))

    def catch(self, error: Point) -> bool:
        """Land where the DCM is going to be, if the sole that stands cannot bring it to the landing.

        Args:
            error: The DCM as measured, less the plan's, m.

        Returns:
            Whether the landing was moved.
        """
        step = self._under_way()
        if step is None:
            return False
        return self._move_landing(self._mover.caught(step, error, self._steering, self.odom_T_plan))

    def step_on(self, error: Point) -> bool:
        """At the end of a walk: step towards where the DCM is, if both soles cannot hold it there.

        Args:
            error: The DCM as measured, less the plan's, m.

        Returns:
            Whether the walk goes on.
        """
        if self.phase not in (Phase.CLOSE, Phase.SETTLE):
            return False
        dcm = self._now.dcm[0] + error[0], self._now.dcm[1] + error[1]
        if self._points.held_by_both(dcm, self.feet, _TIPS_INSET_M):
            return False
        middle, rest = (
            PlanarPose.between(self.feet["left"], self.feet["right"]),
            self._points.resting(self.feet),
        )
        seen, at_rest = middle.to(PlanarPose(*dcm)), middle.to(PlanarPose(*rest))
        beyond = seen.x_m - at_rest.x_m, seen.y_m - at_rest.y_m
        self._body, self._before = middle, PlanarPose()
        self._steering = stepping_on(self._settings, self.odom_T_plan @ middle, beyond, self._steering)
        return self._begin(SHIFT_S)

    @property
    def goal(self) -> PlanarPose | None:
        """Where the foot in the air is going to land."""
        return self._swing.goal if self._swing is not None else None

    @property
    def landings(self) -> list[tuple[Hand, PlanarPose]]:
        """The landings that are planned next, in the odometry frame: which foot, and where; none at rest."""
        ahead = {Phase.SWING: self._steps, Phase.LAND: self._steps[1:]}.get(self.phase, [])
        return [(step.side, self.odom_T_plan @ step.pose) for step in ahead]

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
            self._begin(self._settings.first_shift_s)

    def _begin(self, shift_s: float) -> bool:
        """Set out, if there is anywhere to go; whether there is."""
        side = self._planner.first_side(self._steering, self.feet, self.odom_T_plan)
        self._standing = OTHER[side]
        steps = self._plan()
        if not steps:
            return False
        zmp, route = self._points.middle(self._standing, self.feet[self._standing]), self._route
        first = route.swing(zmp, self.feet[steps[0].side], steps[0].pose)
        after = route.after_swing(self.feet, steps)
        goal = dcm_before([*first, *after], route.end(self.feet, steps), self._omega)
        self.phase = Phase.SHIFT
        self._bend(goal, zmp, shift_s)
        return True

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
        standing = self.feet[self._standing]
        zmp = self._route.leading_zmp(self._swing, 0.0, self._now.dcm, self.feet, steps)
        kept = self._points.nearest(zmp, self._standing, standing, self._settings.zmp_inset_m)
        self._go(*self._route.rest_of_swing(self._swing, 0.0, kept))

    def _land(self) -> None:
        zmp = self._points.middle(self._standing, self.feet[self._standing])
        self.phase = Phase.LAND
        self._go(ZmpStretch(self._settings.double_support_s, self._now.zmp, zmp))

    def _close(self) -> None:
        rest = self._points.resting(self.feet)
        self.phase = Phase.CLOSE
        self._swing = None
        self._bend(rest, rest, self._settings.closing_s)

    def _settle(self) -> None:
        self.phase, self._since_s = Phase.SETTLE, 0.0
        rest = self._points.resting(self.feet)
        self._motion = SettlingCom(self._now, rest, self._settings.settle_s, self._omega)

    def _under_way(self) -> UnderWay | None:
        """The step whose foot is in the air."""
        if self.phase is not Phase.SWING or self._swing is None:
            return None
        return UnderWay(self._swing, self._swing_s, self._standing, self.feet, self._steps, self._now)

    def _move_landing(self, moved: MovedLanding | None) -> bool:
        """Go on with another landing; whether there is one."""
        if moved is None:
            return False
        self._steps = moved.steps
        self._advance, self._next_body = moved.steps[0].advance, moved.steps[0].body
        self._last_landing = len(moved.steps) == 1
        self._go(*moved.stretches)
        return True

    # ---------------------------------------------------------------- the DCM's way

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

    def _plan(self) -> list[Footstep]:
        steering = self._steering
        if isinstance(steering, VelocitySteering | TurnSteering) and steering.angular_rad_s != 0.0:
            steering = SlippingTurn(steering, self._slip_rad)
        return self._planner.plan(
            self._standing, self.feet, self._body, steering, self._before, self.odom_T_plan, HORIZON
        )
