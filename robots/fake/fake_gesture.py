"""Gestures of the fake robot: straight through their postures, whatever stands there."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Sequence

import numpy as np

from kinematics.arrays import Array
from kinematics.model.robot_description import Hand
from kinematics.model.robot_model import RobotModel
from kinematics.motion.trajectory import Trajectory
from kinematics.planning.gesture_task import GestureTask, Wish
from kinematics.requests.gesture import GestureRequest
from kinematics.requests.move import MovePlan
from kinematics.requests.step import NoPlan, PlannedStep

# So many of each stretch: what looks where a hand passes looks at rows of its trajectory.
_ROWS = 12


class FakeGesture(GestureTask):
    """Plans gestures for the fake robot: true postures, no balance, no obstacles, 1 s for each stretch."""

    def __init__(
        self, model: RobotModel, q_start: Array, request: GestureRequest, hand: Hand, seed: int
    ) -> None:
        super().__init__(model, q_start, request, hand, seed)
        self._scene = request.scene

    def reach(self, name: str, wish: Wish) -> MovePlan | NoPlan:
        """To the first posture that is as wished for."""
        reasons: Counter[str] = Counter()
        goal = next(self._postures(wish, reasons), None)
        return self._none(reasons) if goal is None else self._through(name, [self._q_start, goal])

    def swing(self, postures: Sequence[Array]) -> MovePlan:
        """Back and forth."""
        return self._through("swing", postures)

    def room_for(self, sway_m: float) -> Callable[[Array], bool]:
        """There is room everywhere."""
        del sway_m
        return lambda _: True

    def _through(self, name: str, postures: Sequence[Array]) -> MovePlan:
        ends_s = np.arange(len(postures))
        t_s = np.linspace(0.0, ends_s[-1], _ROWS * ends_s[-1] + 1)
        q = np.column_stack([np.interp(t_s, ends_s, column) for column in np.transpose(postures)])
        v = np.zeros((len(q), self._model.nv))
        trajectory = Trajectory(self._model.joints, self._robot.stance, t_s, q, v)
        return MovePlan(PlannedStep(name, trajectory, self._scene))
