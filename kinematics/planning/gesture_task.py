"""What planning a gesture goes by: where things are at a posture, and what is asked of one."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array
from kinematics.ik.arm_frames import ArmFrames, arm_kinematics, arm_share
from kinematics.ik.arm_posture import Residual, arm_posture
from kinematics.ik.gaze import gaze_joints
from kinematics.model.robot_description import Hand
from kinematics.model.robot_model import RobotModel
from kinematics.model.standing_robot import StandingRobot
from kinematics.requests.gesture import GestureRequest
from kinematics.requests.move import MovePlan
from kinematics.requests.step import NoPlan

STARTS = 12
# Residual that a posture may keep: a centimetre, or half a degree.
ENOUGH = 0.02
# How far beside home random starts are.
SPREAD_RAD = 0.6


@dataclass(frozen=True, slots=True)
class Wish:
    """What the posture of a gesture is to be like, for the search of it.

    Attributes:
        residual: What should be zero, from the places of the arm's parts.
        look_m: Where the robot looks and turns its trunk to, shape (3,).
        good: Whether a posture will do.
        goodness: What ``good`` asks, in words.
        enough: Norm of the residual at which a posture is taken.
        starts: How often the search begins anew, at random.
        spread_rad: How far from the home posture each joint may be where it begins.
        has_room: Whether a configuration, shape (nq,), keeps away from things; None leaves that to the way.
    """

    residual: Residual
    look_m: Array
    good: Callable[[ArmFrames], bool]
    goodness: str
    enough: float = ENOUGH
    starts: int = STARTS
    spread_rad: float = SPREAD_RAD
    has_room: Callable[[Array], bool] | None = None


class GestureTask(ABC):
    """The state of one gesture's planning; a subclass knows how the robot gets to a posture.

    Attributes:
        arm: The arm that makes the gesture.
        outwards: 1 for the left hand, -1 for the right one: the sign of its side.
        share: What a short arm leaves of the measures of a gesture.
    """

    def __init__(
        self, model: RobotModel, q_start: Array, request: GestureRequest, hand: Hand, seed: int
    ) -> None:
        self._model, self._hand, self._q_start = model, hand, q_start
        self._robot = StandingRobot.of(model, request.stance)
        self._rng = np.random.default_rng(seed)
        self.arm = arm_kinematics(model, hand)
        self.share = arm_share(model, hand)
        self.outwards = 1.0 if hand == "left" else -1.0
        self._home = self._robot.q_home

    @abstractmethod
    def reach(self, name: str, wish: Wish) -> MovePlan | NoPlan:
        """Plan to a posture that is as wished for."""

    @abstractmethod
    def swing(self, postures: Sequence[Array]) -> MovePlan | NoPlan:
        """Plan to go back and forth through postures of the arm, shape (nq,) each, from the first one."""

    @abstractmethod
    def room_for(self, sway_m: float) -> Callable[[Array], bool]:
        """Whether a configuration keeps so much more than their margins from all movable things."""

    def _postures(self, wish: Wish, reasons: Counter[str]) -> Iterator[Array]:
        """Postures as wished for, looking there, shape (nq,); why others are none is counted."""
        columns = self.arm.columns
        for q_seed in self._starts(columns, wish):
            found = arm_posture(self._model, self.arm, q_seed, wish.residual, self._home[columns])
            if found.error > wish.enough:
                reasons["out of reach"] += 1
                continue
            if not wish.good(self.arm.at(found.q)):
                reasons[f"not {wish.goodness}"] += 1
                continue
            if wish.has_room is not None and not wish.has_room(found.q):
                reasons["too near to something"] += 1
                continue
            goal = found.q.copy()
            for joint, angle in gaze_joints(self._model, goal, wish.look_m).items():
                goal[7 + self._model.joint_index(joint)] = angle
            yield goal

    def _none(self, reasons: Counter[str]) -> NoPlan:
        return NoPlan(f"no posture of the {self._hand} arm for that was found", reasons)

    def _starts(self, columns: NDArray[np.intp], wish: Wish) -> Iterator[Array]:
        """From home with the trunk turned, the other arm where it is, then random ones about that."""
        q = self._home.copy()
        other_arm = self._model.group("left_arm" if self._hand == "right" else "right_arm")
        q[7 + other_arm] = self._q_start[7 + other_arm]
        turning = 7 + self._model.indices(self.arm.turning)
        q[turning] -= self.arm.at(q).turned_past_rad(wish.look_m)[0] / max(len(turning), 1)
        yield q
        for _ in range(wish.starts):
            other = q.copy()
            other[columns] += self._rng.uniform(-wish.spread_rad, wish.spread_rad, len(columns))
            yield other
