"""Judges whole-body setpoints as they are made: feet, limits, balance, self-collision, floor, scene."""

from __future__ import annotations

import numpy as np

from kinematics.arrays import Array
from kinematics.collision.standing_judge import StandingJudge
from kinematics.model.standing_robot import StandingRobot
from kinematics.motion.sampler import MotionSample
from kinematics.scene.planning_scene import PlanningScene
from kinematics.standing.free_coordinates import free_coordinates
from kinematics.standing.reserves import COM_RESERVE_M
from robots.control.gate.refusal import Limit, Refusal
from robots.control.guarded.guarded_motion import BodyMotion

_LEGS_RAD = 1e-3
"""Legs may be so far from where base and stance put them: more would move a sole by a millimetre."""


class BodyChecker:
    """Watches one whole-body motion while it runs; its scene may change as it goes."""

    def __init__(self, standing: StandingRobot, motion: BodyMotion) -> None:
        self._standing, self._model, self._motion = standing, standing.model, motion
        self._space = free_coordinates(standing)
        self._scene: PlanningScene | None = None
        self._judge: StandingJudge | None = None

    def judge(self) -> Refusal | None:
        """Judge the motion's last sample."""
        scene, body = self._motion.scene, self._motion.body
        if not np.isfinite(body.q).all():
            return self._not_finite(body.q)
        x = self._space.from_q(body.q)
        if self._judge is None or scene is not self._scene:
            self._scene, self._judge = scene, self._judge_of(scene, x, body.q)
        if self._judge.is_free(x, body.q):
            return self._stance_refusal(self._judge, body, x)
        return self._explain(self._judge, x, body)

    def _judge_of(self, scene: PlanningScene, x: Array, q: Array) -> StandingJudge:
        """What was kept at the first sample of all is kept in every scene."""
        if self._judge is None:
            return StandingJudge.beginning_at(self._standing, scene, x, q)
        return StandingJudge(self._standing, scene, self._judge.kept)

    def _stance_refusal(self, judge: StandingJudge, body: MotionSample, x: Array) -> Refusal | None:
        placed = judge.configuration(x)
        if placed is None:
            return _no_reach()
        gap = np.abs(placed[7:] - body.q[7:])
        worst = int(np.argmax(gap))
        if gap[worst] <= _LEGS_RAD:
            return None
        return Refusal(Limit.STANCE, self._model.joints[worst], float(gap[worst]), _LEGS_RAD)

    def _not_finite(self, q: Array) -> Refusal:
        place = int(np.argmin(np.isfinite(q)))
        part = "base" if place < 7 else self._model.joints[place - 7]
        return Refusal(Limit.NOT_FINITE, part, float(q[place]), 0.0)

    def _explain(self, judge: StandingJudge, x: Array, body: MotionSample) -> Refusal | None:
        """What the judge itself found, with the numbers that it is judged by."""
        found = judge.not_free(x, body.q)
        if found is None:  # asked again, the same judge sees a pair within a micrometre of its margin apart
            return self._stance_refusal(judge, body, x)
        if found.pair is not None:
            return Refusal(Limit.COLLISION, " and ".join(found.pair), 0.0, 0.0)
        placed = judge.configuration(x)
        if placed is None:
            return _no_reach()
        if found.reason == "balance":
            margin_m = self._standing.polygon.com_margin_m(self._model.com(placed))
            least_m = self._model.description.com_margin_m + COM_RESERVE_M
            return Refusal(Limit.BALANCE, "centre of mass", margin_m, least_m)
        return self._limit_refusal(placed)

    def _limit_refusal(self, q: Array) -> Refusal:
        margin = self._model.description.planning_margin_rad
        lower, upper = self._model.lower_rad + margin, self._model.upper_rad - margin
        worst = int(np.argmax(np.maximum(lower - q[7:], q[7:] - upper)))
        value = float(q[7 + worst])
        bound = float(lower[worst] if value < lower[worst] else upper[worst])
        return Refusal(Limit.POSITION, self._model.joints[worst], value, bound)


def _no_reach() -> Refusal:
    return Refusal(Limit.REACH, "a leg, whose foot could not stay where it stands", 0.0, 0.0)
