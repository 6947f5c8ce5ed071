"""How a robot gets to the posture of a gesture: past what is around, in balance, in good time."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Sequence

import numpy as np

from kinematics.arrays import Array
from kinematics.collision.relaxed_start import relaxed_at, start_concessions
from kinematics.collision.validity import validity
from kinematics.collision.wide_berth import widened
from kinematics.model.robot_description import Hand
from kinematics.model.robot_model import RobotModel
from kinematics.motion.curves import Curve, RoundedPolyline
from kinematics.motion.lead_in import lead_in
from kinematics.planning.gesture_task import GestureTask, Wish
from kinematics.planning.path_planner import PathPlanner
from kinematics.requests.gesture import GestureRequest
from kinematics.requests.move import MovePlan
from kinematics.requests.step import NoPlan, PlannedStep
from kinematics.scene.planning_scene import PlanningScene
from kinematics.standing.free_coordinates import FreeCoordinates, free_coordinates
from kinematics.standing.reserves import MOVING_RESERVE_M as RESERVE_M
from kinematics.timing.balanced_timing import time_in_balance
from kinematics.timing.curve_timing import Pace

GESTURE_PACE = Pace(velocity=0.5, acceleration=0.7)
SWING_PACE = Pace(velocity=0.7, acceleration=0.9)
# Of the corners of a hand's way to and fro.
_ROUNDED = 0.06


class PlannedGesture(GestureTask):
    """A gesture whose postures are judged like any goal, and reached by the path planner.

    Attributes:
        space: The free coordinates.
        scene: The scene, with margins that the start keeps.
        planner: Of paths in that scene.
    """

    def __init__(
        self, model: RobotModel, q_start: Array, request: GestureRequest, hand: Hand, seed: int
    ) -> None:
        super().__init__(model, q_start, request, hand, seed)
        self.space: FreeCoordinates = free_coordinates(self._robot)
        self._given = request.scene
        self.scene: PlanningScene = relaxed_at(model, request.scene, q_start, RESERVE_M)
        self.planner = PathPlanner(model, self.space, validity(self._robot, self.scene, RESERVE_M, RESERVE_M))

    def reach(self, name: str, wish: Wish) -> MovePlan | NoPlan:
        """Plan to a posture that is as wished for, and free."""
        reasons: Counter[str] = Counter()
        moving = [self.space.index(joint) for joint in self.arm.joints]
        for goal in self._postures(wish, reasons):
            x_start, x_goal = self.space.start(self._q_start), self.space.from_q(goal)
            if not self.planner.is_free(x_goal):
                reasons["collision or lost balance"] += 1
                continue
            curve = self.planner.plan(x_start, x_goal, moving, self._rng)
            if curve is None:
                reasons["no path"] += 1
                continue
            return self._timed(name, curve, GESTURE_PACE)
        return self._none(reasons)

    def swing(self, postures: Sequence[Array]) -> MovePlan | NoPlan:
        """Plan to go back and forth, if nothing is in the way."""
        points = np.array([self.space.from_q(q) for q in postures])
        curve = RoundedPolyline(points, self.space.weights, _ROUNDED)
        if not self.planner.curve_is_free(curve):
            return NoPlan("the raised hand has no room to swing", {"collision": 1})
        return self._timed("swing", curve, SWING_PACE)

    def room_for(self, sway_m: float) -> Callable[[Array], bool]:
        """Whether a configuration keeps so much more than their margins from all movable things."""
        wide = widened(self.scene, sway_m)
        if wide is self.scene:
            return lambda _: True
        judge = validity(self._robot, wide, RESERVE_M, RESERVE_M)
        return lambda q: judge.points_are_free(self.space.from_q(q)[None, :])

    def _timed(self, name: str, curve: Curve, pace: Pace) -> MovePlan | NoPlan:
        """Give a free curve its time."""
        trajectory = time_in_balance(self._robot, curve, pace)
        if trajectory is None:
            return NoPlan("the legs cannot follow the motion", {"legs cannot follow": 1})
        trajectory = lead_in(trajectory, self._q_start, self._model.acceleration)
        near = start_concessions(self._model, self._given, self.scene, self._q_start, name)
        return MovePlan(PlannedStep(name, trajectory, self._given, near))
