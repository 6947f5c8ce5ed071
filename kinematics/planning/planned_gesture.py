"""How a robot gets to the posture of a gesture: past what is around, in balance, in good time."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Sequence

from kinematics.arrays import Array
from kinematics.collision.wide_berth import widened
from kinematics.model.robot_description import Hand
from kinematics.model.robot_model import RobotModel
from kinematics.motion.curves import Curve, RoundedPolyline
from kinematics.planning.gesture_task import GestureTask, Wish
from kinematics.planning.held_lean import MOST_LEAN_RAD, least_leaning
from kinematics.planning.planning_task import PlanningTask
from kinematics.requests.gesture import GestureRequest
from kinematics.requests.move import MovePlan
from kinematics.requests.step import NoPlan
from kinematics.standing.reserves import MOVING_RESERVE_M as RESERVE_M
from kinematics.timing.curve_timing import Pace

GESTURE_PACE = Pace(velocity=0.5, acceleration=0.7)
SWING_PACE = Pace(velocity=0.7, acceleration=0.9)
# Of the corners of a hand's way to and fro.
_ROUNDED = 0.06
# Ways that are compared by how far they lean what is held.
_MOST_WAYS = 4


class PlannedGesture(GestureTask):
    """A gesture whose postures are judged like any goal, and reached by the path planner."""

    def __init__(
        self, model: RobotModel, q_start: Array, request: GestureRequest, hand: Hand, seed: int
    ) -> None:
        super().__init__(model, q_start, request, hand, seed)
        self._task = PlanningTask(model, request, RESERVE_M, RESERVE_M)

    def reach(self, name: str, wish: Wish) -> MovePlan | NoPlan:
        """Plan to a posture that is as wished for, and free."""
        reasons: Counter[str] = Counter()
        task = self._task
        ways: list[tuple[float, Curve]] = []
        moving = [task.space.index(joint) for joint in self.arm.joints]
        for goal in self._postures(wish, reasons):
            x_goal = task.space.from_q(goal)
            if not task.planner.is_free(x_goal):
                reasons["collision or lost balance"] += 1
                continue
            curve = task.planner.plan(task.x_start, x_goal, moving, self._rng)
            if curve is None:
                reasons["no path"] += 1
                continue
            ways.append(least_leaning(task.planner, self._model, task.space, curve, task.scene))
            if ways[-1][0] <= MOST_LEAN_RAD or len(ways) >= _MOST_WAYS:
                break
        if not ways:
            return self._none(reasons)
        return self._timed(name, min(ways, key=lambda way: way[0])[1], GESTURE_PACE)

    def swing(self, postures: Sequence[Array]) -> MovePlan | NoPlan:
        """Plan to go back and forth, if nothing is in the way."""
        curve = RoundedPolyline(self._task.rows(postures), self._task.space.weights, _ROUNDED)
        if not self._task.planner.curve_is_free(curve):
            return NoPlan("the raised hand has no room to swing", {"collision": 1})
        return self._timed("swing", curve, SWING_PACE)

    def room_for(self, sway_m: float) -> Callable[[Array], bool]:
        """Whether a configuration keeps so much more than their margins from all movable things."""
        task = self._task
        wide = widened(task.scene, sway_m)
        if wide is task.scene:
            return lambda _: True
        judge = task.planner_in(wide).judge
        return lambda q: judge.points_are_free(task.space.from_q(q)[None, :])

    def _timed(self, name: str, curve: Curve, pace: Pace) -> MovePlan | NoPlan:
        """Give a free curve its time."""
        step = self._task.first_step(name, curve, pace)
        if step is None:
            return NoPlan("the legs cannot follow the motion", {"legs cannot follow": 1})
        return MovePlan(step)
