"""A hand that holds something which goes its own way: it leads along a path and yields across it.

The force on the hand is estimated from the arm's efforts. Along the path it is bounded: the motion slows
down as it grows and counts as stuck when it stands. Across the path and along the bar the hand gives way
(admittance), so that errors of where a hinge is believed to be do not become forces.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Literal

import numpy as np

from kinematics.arrays import Array
from kinematics.estimation.hand_force import HandForce
from kinematics.following.hand_tracker import TICK_S, HandGoal, HandTracker
from kinematics.following.opening_motion import (
    BREAK_FREE_N,
    HELD_SPIN,
    MOVING_N,
    SPIN_FADES,
    com_shift_m,
    guarded_scene,
    most_pull_n,
    scene_at,
    speed_along,
    turn_along,
)
from kinematics.model.robot_description import Hand
from kinematics.model.standing_robot import StandingRobot
from kinematics.motion.sampler import MotionSample
from kinematics.scene.opening_path import OpeningPath
from kinematics.scene.planning_scene import PlanningScene
from robots.control.grip.hand_joints import HandJoints
from robots.control.guarded.guarded_motion import MotionBounds
from robots.control.hands.yield_settings import USUAL, Outcome, YieldReport, YieldSettings
from robots.interface.gripper_reading import read_gripper
from robots.interface.hardware import GripSettings
from robots.interface.robot import RobotState

_Phase = Literal["lean", "lead", "back", "ease", "settle", "rest"]


class YieldingHand:
    """Leads a held handle along its path; satisfies ``BodyMotion``.

    With ``s_to`` equal to ``s_from`` it stays and yields, until ``finish`` is called: while a gripper
    closes on a bar that is not quite where it was thought to be.

    Attributes:
        report: What was felt so far.
    """

    def __init__(
        self,
        standing: StandingRobot,
        hand: Hand,
        q: Array,
        scene: PlanningScene,
        parts: Sequence[str],
        path: OpeningPath,
        s_from: float,
        s_to: float,
        *,
        grip: GripSettings,
        bias: Array | None = None,
        stop_from: float | None = None,
        holding: bool = True,
        settings: YieldSettings = USUAL,
    ) -> None:
        """Prepare.

        Args:
            standing: The robot where it stands.
            hand: The hand that holds the handle.
            q: The reference, at rest, shape (nq,).
            scene: What is around at ``s_from``; the hand may touch what its ``allowed`` says.
            parts: What of the scene moves with the handle.
            path: Of the TCP: ``path.at(s_from)`` is where it is.
            s_from, s_to: Where along it to lead.
            grip: What the gripper feels when it holds something.
            bias: Of the force estimate; measured at the start when left out.
            stop_from: What stands still nearer to ``s_to`` than this has met its stop, and is not stuck.
            holding: Whether the hand holds something that it can lose.
            settings: How it yields.
        """
        self._holding = holding
        self._stop_from = stop_from
        model = standing.model
        self._standing, self._model = standing, model
        self._path, self._settings = path, settings
        self._tracker = HandTracker(standing, hand, q)
        self._force = HandForce(model, hand, model.description.joint_viscosity_nms_rad)
        self._gripper, self._grip = model.description.grippers[hand], grip
        self._turn = turn_along(path, model.description, hand, holding)
        self._fingers = HandJoints(model.description, hand)
        self._parts = tuple(dict.fromkeys(parts))
        self._scene_from, self._s_from, self._s_to = guarded_scene(scene), s_from, s_to
        self.scene, self._scene_s = self._scene_from, s_from
        self._way = math.copysign(1.0, s_to - s_from) if s_to != s_from else 0.0
        self._opening = self._way > 0.0
        self._most_n = settings.force_limit_n
        if self._way:
            point = path.at(s_from)
            bears_n = most_pull_n(standing, self._way * point.outward, float(point.position_m[2]))
            self._most_n = min(self._most_n, bears_n)
        self._leading = self._way != 0.0
        self._s, self._speed = s_from, 0.0
        self._rotation = self._tracker.tcp_rotation.copy()
        self._give = np.zeros(3)
        self._spin = HELD_SPIN
        self._bias = bias
        self._early: list[Array] = []
        self._felt = np.zeros(6)
        self._peak_force_n = self._peak_pull_n = 0.0
        self._outcome: Outcome = "running"
        self._phase: _Phase = "lean" if self._opening else "lead"
        self._phase_s = self._slow_s = self._empty_s = 0.0
        self._asked_to_finish = False
        self._eased_from = s_from
        self._met_stop = False
        self._times: Array | None = None
        rest = np.zeros(model.nv)
        self.body = MotionSample(self._tracker.q, rest, rest)
        self._queue: list[MotionSample] = []
        self._efforts: list[Array] = []
        self._joints: list[Array] = []
        self.name = f"lead the {hand} hand" if self._leading else f"yield with the {hand} hand"
        n = len(model.joints)
        way_s = 0.0 if not self._leading else abs(s_to - s_from) / (settings.close_share * speed_along(path))
        self.bounds = MotionBounds(
            joints=model.joints,
            lower_rad=model.lower_rad,
            upper_rad=model.upper_rad,
            velocity=np.minimum(model.velocity, np.full(n, _FASTEST_RAD_S)),
            effort=model.effort,
            duration_s=way_s + 15.0,
        )

    @property
    def in_contact(self) -> bool:
        """It is made for contact."""
        return True

    @property
    def report(self) -> YieldReport:
        """What was felt so far."""
        bias = np.zeros(6) if self._bias is None else self._bias
        return YieldReport(self._outcome, self._s, self._peak_force_n, self._peak_pull_n, bias)

    def finish(self) -> None:
        """Come to rest where the hand is."""
        self._asked_to_finish = True

    def sample(self, elapsed_s: float, state: RobotState) -> tuple[Array, Array] | None:
        """Next setpoint of the body's joints, or None when it has come to rest."""
        if elapsed_s <= 0.0:
            return self.body.q[7:], self.body.v[6:]
        if self._times is None:  # the second call comes one control period after the first
            count = round(TICK_S / elapsed_s)
            self._times = TICK_S / count * np.arange(1, count + 1, dtype=np.float64)
        n = len(self._model.joints)
        self._efforts.append(state.effort[:n])
        self._joints.append(state.q[:n])
        if not self._queue:
            if self._phase == "rest" and self._tracker.at_rest:
                if self.body.v.any():
                    rest = np.zeros(self._model.nv)
                    self.body = MotionSample(self.body.q, rest, rest)
                    return self.body.q[7:], self.body.v[6:]
                return None
            self._feel(state)
            self._queue = self._tracker.tick(self._goal(), self._times)
            self._efforts, self._joints = [], []
        self.body = self._queue.pop(0)
        return self.body.q[7:], self.body.v[6:]

    def _feel(self, state: RobotState) -> None:
        """Estimate the force from what was measured during the last tick."""
        q = self.body.q.copy()
        q[7:] = np.mean(self._joints, axis=0)
        wrench = self._force.estimate(q, self.body.v, self.body.a, np.mean(self._efforts, axis=0))
        if self._bias is None:
            self._early.append(wrench)
            if len(self._early) < self._settings.bias_ticks:
                return
            self._bias = np.mean(self._early, axis=0)
        self._felt = self._felt + self._settings.force_share * (wrench - self._bias - self._felt)
        self._peak_force_n = max(self._peak_force_n, float(np.linalg.norm(self._felt[:3])))
        reading = read_gripper(
            self._gripper,
            self._grip,
            self._fingers.position(state.q),
            self._fingers.effort(state.effort),
        )
        self._empty_s = 0.0 if reading.holding else self._empty_s + TICK_S

    def _goal(self) -> HandGoal | None:
        """Decide where the hand goes in the next tick."""
        self._phase_s += TICK_S
        point = self._path.at(self._s)
        if self._phase == "rest":
            return None
        if self._leading:
            self._lead(point.outward)
            point = self._path.at(self._s)
        elif self._asked_to_finish and self._phase != "settle":
            self._outcome = "arrived"
            self._enter("settle")
        if self._phase == "settle" and self._phase_s > self._settings.settle_s:
            self._enter("rest")
            return None
        self._yield_across(point.outward, point.across)
        if self._leading and self._phase == "lead":
            self._spin = max(self._turn.weight, self._spin * SPIN_FADES)
        self._move_scene()
        pull_n = 0.0
        if self._opening and self._outcome == "running":
            pull_n = BREAK_FREE_N if self._phase == "lean" or not self._gives_way else MOVING_N
        at_z_m = float(point.position_m[2])
        return HandGoal(
            position_m=point.position_m + self._give,
            rotation=self._turn.rotation(self._path, self._rotation, self._s_from, self._s),
            spin_weight=self._spin,
            spin_axis=self._path.bar_axis,
            com_shift_m=com_shift_m(self._standing, point.outward, at_z_m, pull_n),
        )

    @property
    def _gives_way(self) -> bool:
        """Whether the handle has moved by more than what an arm gives under load."""
        start = self._path.at(self._s_from).position_m
        return float(np.linalg.norm(self._tracker.tcp_m - start)) > _MOVED_M

    def _lead(self, outward: Array) -> None:
        settings = self._settings
        against_n = -self._way * float(self._felt[:3] @ outward)
        if self._phase == "lean" and self._phase_s > settings.lean_s:
            self._enter("lead")
        if self._phase == "lead":
            self._peak_pull_n = max(self._peak_pull_n, against_n)
            self._advance(self._s_to, self._way, against_n)
            if self._holding and self._empty_s > settings.lost_s:
                self._end("lost", "settle")
            elif self._s == self._s_to:
                self._end("arrived", "ease" if self._stop_from is not None else "settle")
            elif self._slow_s > settings.stuck_s:
                self._met_stop = self._at_stop
                self._end(*(("arrived", "ease") if self._at_stop else ("stuck", "back")))
        elif self._phase == "back":
            self._advance(self._s_from, -self._way, 0.0)
            if self._s == self._s_from:
                self._enter("settle")
        elif self._phase == "ease":
            back_m = abs(self._s - self._eased_from) * self._path.lever_m
            far_enough = back_m >= settings.ease_m or not self._met_stop
            if (against_n < settings.eased_n and far_enough) or back_m > _MOST_EASED_M:
                self._enter("settle")
            else:
                self._advance(self._s_from, -self._way, 0.0)

    @property
    def _at_stop(self) -> bool:
        return self._stop_from is not None and self._way * (self._s - self._stop_from) >= 0.0

    def _advance(self, target: float, way: float, against_n: float) -> None:
        """Go on along the path, more slowly the larger the force against it."""
        settings, full = self._settings, speed_along(self._path)
        left = max(way * (target - self._s), 0.0)
        near_closed = not self._opening and self._s * self._path.lever_m < _LAST_PIECE_M
        held_fast = self._phase == "lead" and self._opening and not self._gives_way
        wanted = full * (settings.close_share if near_closed or held_fast else 1.0)
        wanted = min(wanted, math.sqrt(2.0 * settings.acceleration * full * left) + 0.02 * full)
        most, slow = self._most_n, settings.slow_share
        if self._at_stop:
            most = min(most, settings.stop_force_n)
        if against_n > slow * most:
            wanted *= max(0.0, 1.0 - (against_n - slow * most) / ((1.0 - slow) * most))
        change = wanted - self._speed
        change = min(
            max(change, -settings.deceleration * full * TICK_S), settings.acceleration * full * TICK_S
        )
        self._speed = max(0.0, self._speed + change)
        step = self._speed * TICK_S
        self._s = target if step >= left else self._s + way * step
        slow_now = self._speed < settings.stuck_speed_share * full and self._phase_s > 1.0
        self._slow_s = self._slow_s + TICK_S if slow_now else 0.0

    def _end(self, outcome: Outcome, phase: _Phase) -> None:
        self._outcome = outcome
        self._enter(phase)

    def _enter(self, phase: _Phase) -> None:
        self._phase, self._phase_s, self._speed = phase, 0.0, 0.0
        self._eased_from = self._s

    def _yield_across(self, outward: Array, across: Array) -> None:
        settings = self._settings
        # Fingers that close push the hand off what is behind the bar; along the way only the way leads.
        axes = (across, np.cross(outward, across)) if self._leading else np.eye(3)
        for axis in axes:
            force_n = float(self._felt[:3] @ axis)
            beyond_n = math.copysign(max(abs(force_n) - settings.deadband_n, 0.0), force_n)
            speed = min(max(beyond_n / settings.give_ns_m, -settings.give_m_s), settings.give_m_s)
            self._give = self._give + speed * TICK_S * axis

    def _move_scene(self) -> None:
        """Let the online checker know where the door is, a few times along the way."""
        if abs(self._s - self._scene_s) * self._path.lever_m > _SCENE_STEP_M:
            self.scene = scene_at(self._scene_from, self._parts, self._path, self._s_from, self._s)
            self._scene_s = self._s


_FASTEST_RAD_S = 2.0
"""Arms stay below 1 rad/s by themselves; nearly straight knees are quicker."""
_MOVED_M = 0.035
"""Less than this is what an arm gives at the limit of the force."""
_MOST_EASED_M = 0.04
_LAST_PIECE_M = 0.10
"""Over the last of the way a door is closed slowly: it must not slam."""
_SCENE_STEP_M = 0.04
"""The door moves so far from one scene of the online checker to the next."""
