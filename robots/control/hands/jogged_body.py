"""Trunk, arms and head while a person jogs them: each word is good for a moment, and silence brakes.

The motion decides every 10 ms, and takes only what it can brake from without touching, tipping or meeting
the end of a range; what slows it down it says. The online checker judges every setpoint after it.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from kinematics.arrays import Array
from kinematics.collision.relaxed_start import relaxed_at
from kinematics.collision.standing_judge import Kept, StandingJudge
from kinematics.following.jog_reference import Jog
from kinematics.following.jog_tracker import TICK_S, JogTracker
from kinematics.model.standing_robot import StandingRobot
from kinematics.motion.sampler import MotionSample
from kinematics.scene.planning_scene import PlanningScene
from kinematics.standing.free_coordinates import free_coordinates
from kinematics.standing.reserves import JOGGING_RESERVE_M
from robots.control.guarded.guarded_motion import MotionBounds
from robots.control.hands.jog_touch import JogTouch
from robots.interface.robot import RobotState

WORD_HOLDS_S = 0.15
"""A word that is not repeated within so long was the last one."""
_DURATION_S = 3600.0
_IDLE_S = 1.0
"""At rest and without a word for so long, it is over: something else may move the body."""


@dataclass(frozen=True, slots=True)
class JogReport:
    """What is told of jogging.

    Attributes:
        held_back: What slows the motion down or stops it, for people; empty when nothing does.
        moving: Whether anything is commanded to move.
    """

    held_back: str
    moving: bool


class JoggedBody:
    """Moves as it is told to, a word at a time; satisfies ``BodyMotion``."""

    def __init__(self, standing: StandingRobot, q: Array, scene: PlanningScene, touch: JogTouch) -> None:
        """Prepare.

        Args:
            standing: The robot where it stands.
            q: The reference, at rest, shape (nq,).
            scene: What is around; it says which pairs may touch.
            touch: What the arms feel beside.
        """
        model = standing.model
        self._model = model
        self.scene = relaxed_at(model, scene, q, JOGGING_RESERVE_M)
        self._touch = touch
        self._tracker = JogTracker(standing, q, _judge(standing, self.scene, q), touch)
        rest = np.zeros(model.nv)
        self.body = MotionSample(self._tracker.q, rest, rest)
        self._queue: list[MotionSample] = []
        self._times: Array | None = None
        self._jog: Jog | None = None
        self._until_s = self._elapsed_s = 0.0
        self._asked_to_finish = False
        self.name = "jog"
        self.bounds = MotionBounds(
            joints=model.joints,
            lower_rad=model.lower_rad,
            upper_rad=model.upper_rad,
            velocity=model.velocity,
            effort=model.effort,
            duration_s=_DURATION_S,
        )

    @property
    def in_contact(self) -> bool:
        """It touches nothing that it may not move."""
        return False

    @property
    def report(self) -> JogReport:
        """How it goes."""
        heard = self._elapsed_s < self._until_s
        return JogReport(self._tracker.held_back if heard else "", not self._tracker.at_rest)

    def steer(self, jog: Jog) -> None:
        """Go on as asked for, for as long as a word is good for."""
        self._jog, self._until_s = jog, self._elapsed_s + WORD_HOLDS_S
        self._asked_to_finish = False

    def brake(self) -> None:
        """Come to rest now, and go on listening."""
        self._until_s = self._elapsed_s

    def finish(self) -> None:
        """Come to rest, and end."""
        self._asked_to_finish = True

    def sample(self, elapsed_s: float, _state: RobotState) -> tuple[Array, Array] | None:
        """Next setpoint of the body's joints, or None once it is over."""
        self._elapsed_s = elapsed_s
        if elapsed_s <= 0.0:
            return self.body.q[7:], self.body.v[6:]
        if self._times is None:  # the second call comes one control period after the first
            count = round(TICK_S / elapsed_s)
            self._times = TICK_S / count * np.arange(1, count + 1, dtype=np.float64)
        if not self._queue:
            self._touch.tick(self.body.q)
            silent = elapsed_s >= self._until_s or self._asked_to_finish
            if silent and self._tracker.at_rest:
                return self._rest(elapsed_s)
            self._queue = self._tracker.tick(None if silent else self._jog, self._times)
        self.body = self._queue.pop(0)
        return self.body.q[7:], self.body.v[6:]

    def _rest(self, elapsed_s: float) -> tuple[Array, Array] | None:
        if self.body.v.any():
            rest = np.zeros(self._model.nv)
            self.body = MotionSample(self.body.q, rest, rest)
        elif self._asked_to_finish or elapsed_s >= self._until_s + _IDLE_S:
            return None
        return self.body.q[7:], self.body.v[6:]


def _judge(standing: StandingRobot, scene: PlanningScene, q: Array) -> StandingJudge:
    """The judge of what lies ahead: a little stricter than the one that comes after."""
    stricter = scene.with_objects(
        replace(item, margin_m=item.margin_m + JOGGING_RESERVE_M) for item in scene.objects.values()
    )
    x = free_coordinates(standing).from_q(q)
    usual = Kept()
    more = Kept(usual.own_m + JOGGING_RESERVE_M, usual.floor_m + JOGGING_RESERVE_M, usual.legs_m)
    judge = StandingJudge(standing, stricter, more)
    return judge if judge.is_free(x, q) else StandingJudge.beginning_at(standing, stricter, x, q)
