"""What planning a gesture goes by: where things are at a posture, and how one is reached."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Sequence

import numpy as np
from numpy.typing import NDArray

from kinematics.arm_frames import ArmFrames, arm_kinematics
from kinematics.arm_posture import Residual, arm_posture
from kinematics.balanced_timing import time_in_balance
from kinematics.curves import Curve
from kinematics.free_coordinates import FreeCoordinates, free_coordinates
from kinematics.gaze import gaze_joints
from kinematics.gesture_requests import (
    GestureRequest,
)
from kinematics.lead_in import lead_in
from kinematics.path_planner import PathPlanner
from kinematics.requests import MovePlan, NoPlan, PlannedStep
from kinematics.robot_description import Hand
from kinematics.robot_model import RobotModel
from kinematics.scene import PlanningScene
from kinematics.start_state import relaxed_at
from kinematics.timing import Pace
from kinematics.validity import validity
from kinematics.wide_berth import widened

Array = NDArray[np.float64]

GESTURE_PACE = Pace(velocity=0.5, acceleration=0.7)
# Kept in reserve against the checker, which judges with the scene's own margins.
RESERVE_M = 0.003
STARTS = 12
# Residual that a posture may keep: a centimetre, or half a degree.
ENOUGH = 0.02
# How far beside home random starts are.
SPREAD_RAD = 0.6


class GestureTask:
    """The state of one gesture's planning.

    Attributes:
        arm: Of the hand.
        outwards: 1 for the left hand, -1 for the right one: the sign of its side.
        space: The free coordinates.
        scene: The scene, with margins that the start keeps.
        planner: Of paths in that scene.
    """

    def __init__(
        self, model: RobotModel, q_start: Array, request: GestureRequest, hand: Hand, seed: int
    ) -> None:
        self._model, self._hand, self._q_start = model, hand, q_start
        self._stance = request.stance
        self._rng = np.random.default_rng(seed)
        self.arm = arm_kinematics(model, hand)
        self.outwards = 1.0 if hand == "left" else -1.0
        self._home = model.home_over(request.stance)
        self.space: FreeCoordinates = free_coordinates(model, request.stance)
        self.scene: PlanningScene = relaxed_at(model, request.scene, q_start, RESERVE_M)
        self.planner = PathPlanner(
            model, self.space, validity(model, request.stance, self.scene, RESERVE_M, RESERVE_M)
        )

    def reach(
        self,
        name: str,
        residual: Residual,
        look_m: Array,
        good: Callable[[ArmFrames], bool],
        goodness: str,
        enough: float = ENOUGH,
        starts: int = STARTS,
        spread_rad: float = SPREAD_RAD,
        has_room: Callable[[Array], bool] | None = None,
    ) -> MovePlan | NoPlan:
        """Plan to a posture with a small residual that is ``good``, roomy and free, looking at a point."""
        reasons: Counter[str] = Counter()
        columns = self.arm.columns
        for q_seed in self._starts(columns, look_m, starts, spread_rad):
            found = arm_posture(self._model, self.arm, q_seed, residual, self._home[columns])
            if found.error > enough:
                reasons["out of reach"] += 1
                continue
            if not good(self.arm.at(found.q)):
                reasons[f"not {goodness}"] += 1
                continue
            if has_room is not None and not has_room(found.q):
                reasons["too near to something"] += 1
                continue
            goal = found.q.copy()
            for joint, angle in gaze_joints(self._model, goal, look_m).items():
                goal[7 + self._model.joint_index(joint)] = angle
            x_start, x_goal = self.space.from_q(self._q_start), self.space.from_q(goal)
            if not self.planner.is_free(x_goal):
                reasons["collision or lost balance"] += 1
                continue
            curve = self.planner.plan(x_start, x_goal, self._moving(self.arm.joints), self._rng)
            if curve is None:
                reasons["no path"] += 1
                continue
            return self.timed(name, curve, GESTURE_PACE)
        return NoPlan(f"no posture of the {self._hand} arm for that was found", reasons)

    def room_for(self, sway_m: float) -> Callable[[Array], bool]:
        """Whether a configuration keeps so much more than their margins from all movable things."""
        wide = widened(self.scene, sway_m)
        if wide is self.scene:
            return lambda _: True
        judge = validity(self._model, self._stance, wide, RESERVE_M, RESERVE_M)
        return lambda q: judge.points_are_free(self.space.from_q(q)[None, :])

    def timed(self, name: str, curve: Curve, pace: Pace) -> MovePlan | NoPlan:
        """Give a free curve its time."""
        trajectory = time_in_balance(self._model, self.space, self._stance, curve, pace)
        if trajectory is None:
            return NoPlan("the legs cannot follow the motion", {"legs cannot follow": 1})
        trajectory = lead_in(trajectory, self._q_start, self._model.acceleration)
        return MovePlan(PlannedStep(name, trajectory, self.scene))

    def _starts(
        self, columns: NDArray[np.intp], look_m: Array, count: int, spread_rad: float
    ) -> Iterator[Array]:
        """From home with the trunk turned, the other arm where it is, then random ones about that."""
        q = self._home.copy()
        other_arm = self._model.group("left_arm" if self._hand == "right" else "right_arm")
        q[7 + other_arm] = self._q_start[7 + other_arm]
        turning = 7 + self._model.indices(self.arm.turning)
        q[turning] -= self.arm.at(q).turned_past_rad(look_m)[0] / max(len(turning), 1)
        yield q
        for _ in range(count):
            other = q.copy()
            other[columns] += self._rng.uniform(-spread_rad, spread_rad, len(columns))
            yield other

    def _moving(self, joints: Sequence[str]) -> list[int]:
        return [self.space.index(joint) for joint in joints]
