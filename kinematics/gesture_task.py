"""What planning a gesture goes by: where things are at a posture, and what is asked of one."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from kinematics import poses
from kinematics.arm_posture import Residual, arm_posture
from kinematics.gaze import gaze_joints
from kinematics.gesture_requests import GestureRequest
from kinematics.requests import MovePlan, NoPlan
from kinematics.robot_description import Hand
from kinematics.robot_model import RobotModel

Array = NDArray[np.float64]

STARTS = 12
# Residual that a posture may keep: a centimetre, or half a degree.
ENOUGH = 0.02
# How far beside home random starts are.
SPREAD_RAD = 0.6


@dataclass(frozen=True, slots=True)
class Wish:
    """What a posture is to be like.

    Attributes:
        residual: What should be zero.
        look_m: Where the robot looks and turns its trunk to, shape (3,).
        good: Whether a posture will do.
        goodness: What ``good`` asks, in words.
        enough: Residual that it may keep.
        starts: How often a search begins at random.
        spread_rad: How far beside home it begins.
    """

    residual: Residual
    look_m: Array
    good: Callable[[Array], bool]
    goodness: str
    enough: float = ENOUGH
    starts: int = STARTS
    spread_rad: float = SPREAD_RAD


class GestureTask(ABC):
    """The state of one gesture's planning; a subclass knows how the robot gets to a posture.

    Attributes:
        arm: Joints of the arm.
        outwards: 1 for the left hand, -1 for the right one: the sign of its side.
    """

    def __init__(
        self, model: RobotModel, q_start: Array, request: GestureRequest, hand: Hand, seed: int
    ) -> None:
        groups = model.description.groups
        self._model, self._hand, self._q_start = model, hand, q_start
        self._stance = request.stance
        self._rng = np.random.default_rng(seed)
        self._data, self._placed_at = model.pin.createData(), b""
        self.arm = groups[f"{hand}_arm"]
        self.outwards = 1.0 if hand == "left" else -1.0
        self._turning = tuple(joint for joint in groups["torso"] if _is_vertical(model, joint))
        self._shoulder_id = model.pin.getJointId(self.arm[1])
        self._elbow_id = model.pin.getJointId(self.arm[3])
        self._chest_id = int(model.pin.parents[model.pin.getJointId(self.arm[0])])
        self._tcp_id = model.frame_id(model.description.tcp_frames[hand])
        self._home = model.home_over(request.stance)
        self._chest_home = self._placed(self._home).oMi[self._chest_id].rotation.copy()

    # where things are at a configuration

    def shoulder(self, q: Array) -> Array:
        """Of the arm's second joint, shape (3,)."""
        return np.array(self._placed(q).oMi[self._shoulder_id].translation)

    def elbow(self, q: Array) -> Array:
        """Of the arm's fourth joint, shape (3,)."""
        return np.array(self._placed(q).oMi[self._elbow_id].translation)

    def tcp(self, q: Array) -> poses.Transform:
        """``world_T_tcp``."""
        data = self._placed(q)
        return np.array(pin.updateFramePlacement(self._model.pin, data, self._tcp_id).homogeneous)

    def heading(self, q: Array) -> float:
        """Where the chest faces: its turn about the vertical from where it faces at home, rad."""
        turn = self._placed(q).oMi[self._chest_id].rotation @ self._chest_home.T
        return poses.yaw_of(turn) + poses.yaw_of(poses.rotation_from_quaternion(self._home[3:7]))

    def bearing(self, q: Array, point: Array) -> float:
        """Direction of a point from the chest, rad."""
        x, y = (point - self._placed(q).oMi[self._chest_id].translation)[:2]
        return float(np.arctan2(y, x))

    def turned_past(self, q: Array, point: Array) -> float:
        """How far the chest is turned past a point, rad."""
        angle = self.heading(q) - self.bearing(q, point)
        return float((angle + np.pi) % (2.0 * np.pi) - np.pi)

    def length_m(self, q: Array) -> float:
        """From shoulder to elbow to TCP."""
        shoulder, elbow, tcp = self.shoulder(q), self.elbow(q), self.tcp(q)[:3, 3]
        return float(np.linalg.norm(elbow - shoulder) + np.linalg.norm(tcp - elbow))

    def _placed(self, q: Array) -> pin.Data:
        if q.tobytes() != self._placed_at:
            pin.forwardKinematics(self._model.pin, self._data, q)
            self._placed_at = q.tobytes()
        return self._data

    # planning

    @abstractmethod
    def reach(self, name: str, wish: Wish) -> MovePlan | NoPlan:
        """Plan to a posture that is as wished for."""

    @abstractmethod
    def swing(self, postures: Sequence[Array]) -> MovePlan | NoPlan:
        """Plan to go back and forth through postures of the arm, shape (nq,) each, from the first one."""

    @abstractmethod
    def room_for(self, sway_m: float) -> Callable[[Array], bool]:
        """Whether a configuration keeps so much more than their margins from all movable things."""

    @property
    def _joints(self) -> tuple[str, ...]:
        """Those that a gesture moves."""
        return (*self.arm, *self._turning)

    def _postures(self, wish: Wish, reasons: Counter[str]) -> Iterator[Array]:
        """Postures as wished for, looking there, shape (nq,); why others are none is counted."""
        columns = 7 + self._model.indices(self._joints)
        for q_seed in self._starts(columns, wish):
            found = arm_posture(self._model, q_seed, self._joints, wish.residual, self._home[columns])
            if found.error > wish.enough:
                reasons["out of reach"] += 1
                continue
            if not wish.good(found.q):
                reasons[f"not {wish.goodness}"] += 1
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
        turning = 7 + self._model.indices(self._turning)
        q[turning] -= self.turned_past(q, wish.look_m) / max(len(turning), 1)
        yield q
        for _ in range(wish.starts):
            other = q.copy()
            other[columns] += self._rng.uniform(-wish.spread_rad, wish.spread_rad, len(columns))
            yield other


def _is_vertical(model: RobotModel, joint: str) -> bool:
    """Whether a joint turns about the vertical at home."""
    data = model.pin.createData()
    pin.computeJointJacobians(model.pin, data, model.q_home)
    index = model.pin.getJointId(joint)
    axis = pin.getJointJacobian(model.pin, data, index, pin.ReferenceFrame.WORLD)[3:, :]
    own = axis[:, int(model.pin.joints[index].idx_v)]
    return bool(abs(own[2]) > 0.99)
