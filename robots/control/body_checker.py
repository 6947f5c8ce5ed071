"""Judges whole-body setpoints as they are made: feet, limits, balance, self-collision, scene."""

from __future__ import annotations

import numpy as np

from kinematics.free_coordinates import free_coordinates
from kinematics.robot_model import RobotModel
from kinematics.scene import PlanningScene
from kinematics.stance import SupportPolygon
from kinematics.trajectory import Stance
from kinematics.trajectory_sampler import MotionSample
from kinematics.validity import Validity, validity
from robots.control.body_motion import BodyMotion
from robots.control.refusal import Limit, Refusal

RESERVE_M = 0.004
"""Kept between the robot's own links, where the motion begins with so much: it brakes within that, and what
comes to rest in collision is not planned for again."""

_LEGS_RAD = 1e-3
"""Legs may be so far from where base and stance put them: more would move a sole by a millimetre."""


class BodyChecker:
    """Watches one whole-body motion while it runs; its scene may change as it goes."""

    def __init__(self, model: RobotModel, stance: Stance, motion: BodyMotion) -> None:
        self._model, self._stance, self._motion = model, stance, motion
        self._space = free_coordinates(model, stance)
        self._polygon = SupportPolygon(stance, model.description.soles)
        self._scene: PlanningScene | None = None
        self._judge: Validity | None = None
        self._reserve_m: float | None = None

    def judge(self) -> Refusal | None:
        """Judge the motion's last sample."""
        scene, body = self._motion.scene, self._motion.body
        x = self._space.from_q(body.q)[None, :]
        if not np.isfinite(x).all():
            return Refusal(Limit.NOT_FINITE, "base", 0.0, 0.0)
        if self._judge is None or scene is not self._scene:
            self._scene, self._judge = scene, self._judge_of(scene, x)
        if self._judge.points_are_free(x):
            return self._stance_refusal(body, x)
        return self._explain(x, body)

    def _judge_of(
        self, scene: PlanningScene, x: np.ndarray[tuple[int, int], np.dtype[np.float64]]
    ) -> Validity:
        """With the reserve, unless the first sample of all has none."""
        if self._reserve_m is None:
            kept = validity(self._model, self._stance, scene, self_margin_m=RESERVE_M)
            self._reserve_m = RESERVE_M if kept.points_are_free(x) else 0.0
            if self._reserve_m > 0.0:
                return kept
        return validity(self._model, self._stance, scene, self_margin_m=self._reserve_m)

    def _stance_refusal(
        self, body: MotionSample, x: np.ndarray[tuple[int, int], np.dtype[np.float64]]
    ) -> Refusal | None:
        gap = np.abs(self._space.to_q(x)[0][0, 7:] - body.q[7:])
        worst = int(np.argmax(gap))
        if gap[worst] <= _LEGS_RAD:
            return None
        return Refusal(Limit.STANCE, self._model.joints[worst], float(gap[worst]), _LEGS_RAD)

    def _explain(self, x: np.ndarray[tuple[int, int], np.dtype[np.float64]], body: MotionSample) -> Refusal:
        ask = getattr(self._judge, "polyline_refusal", None)
        found = None if ask is None else ask(np.vstack([x, x]))
        if found is not None and found.pair is not None:
            return Refusal(Limit.COLLISION, " and ".join(found.pair), 0.0, 0.0)
        margin_m = self._polygon.com_margin_m(self._model.com(body.q))
        if margin_m < self._model.description.com_margin_m + 0.01:
            return Refusal(Limit.BALANCE, "centre of mass", margin_m, self._model.description.com_margin_m)
        reason = "posture" if found is None else found.reason
        return Refusal(Limit.COLLISION if found is None else Limit.STANCE, reason, 0.0, 0.0)
