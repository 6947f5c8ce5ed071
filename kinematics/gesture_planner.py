"""Plan gestures: raise a hand and wave, point at something, offer what is held.

A gesture is a posture of one arm and the trunk's turn that meets a few conditions; it is searched from
several starts, judged like any goal, and reached by the path planner. The robot looks where it means.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Sequence

import numpy as np
import pinocchio as pin
from numpy.typing import NDArray

from kinematics import poses
from kinematics.arm_posture import Residual, arm_posture
from kinematics.balanced_timing import time_in_balance
from kinematics.curves import Curve, RoundedPolyline
from kinematics.free_coordinates import FreeCoordinates, free_coordinates
from kinematics.gaze import gaze_joints
from kinematics.gesture_requests import (
    CarryRequest,
    GestureRequest,
    OfferRequest,
    PointRequest,
    RaiseHandRequest,
    SwingRequest,
)
from kinematics.lead_in import lead_in
from kinematics.path_planner import PathPlanner
from kinematics.pointing import beside_ray_m
from kinematics.requests import MovePlan, NoPlan, PlannedStep
from kinematics.robot_description import Hand
from kinematics.robot_model import RobotModel
from kinematics.scene import PlanningScene
from kinematics.start_state import relaxed_at
from kinematics.timing import Pace
from kinematics.validity import validity

Array = NDArray[np.float64]

GESTURE_PACE = Pace(velocity=0.5, acceleration=0.7)
SWING_PACE = Pace(velocity=0.7, acceleration=0.9)
# Kept in reserve against the checker, which judges with the scene's own margins.
RESERVE_M = 0.003
# Where a waving hand is, from its shoulder: ahead, outwards, up. Elbow bent, beside the head.
WAVING_M = (0.24, 0.20, 0.27)
# Where an offered object is, from the shoulder: ahead, inwards, down. Within a person's easy grasp.
OFFER_M = (0.50, 0.06, 0.22)
# Between an offered object and the person's axis, at least: an arm's length of room.
OFFER_ROOM_M = 0.55
# Cosine of the angle between the fingers' closing and the way to the person, at most: what is pulled
# straight at a finger does not come out of the open hand.
BESIDE_FINGERS = 0.5
# Of the whole arm, how far a pointing hand is stretched.
STRETCHED = 0.85
# Where a carried object is, from the shoulder: ahead, inwards, down.
CARRY_M = (0.36, 0.05, 0.26)
CARRY_TILT_RAD = 0.02
# Where a robot that carries something looks, from the middle of its feet: ahead, aside, and height.
CARRY_LOOK_M = np.array([2.0, 0.0, 0.6])
# A pointing hand stays this far from what it points at.
POINT_ROOM_M = 0.15
STARTS = 12
# Ways to point, tried with each hand in turn: the hand so far above the line from the shoulder, and the
# number of starts. Above a table there is more room for an arm that is held high.
POINT_WAYS = ((0.0, 1), (0.12, 2), (0.24, 2), (0.0, STARTS))
# Residual that a posture may keep: a centimetre, or half a degree.
ENOUGH = 0.02
# A posture that turns the trunk less than this past its target is facing it.
FACING_RAD = 0.2
_SPREAD_RAD = 0.6
_UP = np.array([0.0, 0.0, 1.0])


class GesturePlanner:
    """Answers gesture requests for one robot."""

    def __init__(self, model: RobotModel) -> None:
        self._model = model

    def plan(self, request: GestureRequest) -> MovePlan | NoPlan:
        """Plan one gesture, or say honestly why there is none."""
        if isinstance(request, RaiseHandRequest):
            return self._raise(request)
        if isinstance(request, SwingRequest):
            return self._swing(request)
        if isinstance(request, PointRequest):
            return self._point(request)
        if isinstance(request, CarryRequest):
            return self._carry(request)
        return self._offer(request)

    def _raise(self, request: RaiseHandRequest) -> MovePlan | NoPlan:
        task = _Gesture(self._model, request.q_start, request, request.hand, request.seed)
        target = np.array(request.towards_m)
        ahead, aside, up = WAVING_M

        def residual(q: Array) -> Array:
            turn = poses.rotation_z(task.bearing(q, target))
            place = task.shoulder(q) + turn @ (ahead, task.outwards * aside, up)
            tcp = task.tcp(q)
            return np.concatenate(
                [tcp[:3, 3] - place, 0.3 * _unlike(tcp[:3, 0], _UP), [0.5 * task.turned_past(q, target)]]
            )

        return task.reach(
            "raise", residual, target, lambda q: abs(task.turned_past(q, target)) <= FACING_RAD, "facing it"
        )

    def _swing(self, request: SwingRequest) -> MovePlan | NoPlan:
        task = _Gesture(self._model, request.q_start, request, request.hand, 0)
        q = request.q_start
        start = task.tcp(q)
        across = poses.rotation_z(task.heading(q)) @ (0.0, 0.5 * request.width_m, 0.0)
        ends = []
        for side in (1.0, -1.0):
            place = start[:3, 3] + side * across

            def residual(q: Array, place: Array = place) -> Array:
                tcp = task.tcp(q)
                return np.concatenate([tcp[:3, 3] - place, 0.05 * _unlike(tcp[:3, 0], _UP)])

            found = arm_posture(self._model, q, task.arm, residual, q[7 + self._model.indices(task.arm)])
            if float(np.linalg.norm(task.tcp(found.q)[:3, 3] - place)) > ENOUGH:
                return NoPlan("the raised hand has no room to swing", {"out of reach": 1})
            ends.append(task.space.from_q(found.q))
        x = task.space.from_q(q)
        points = [x, *(ends[k % 2] for k in range(request.swings + 1)), x]
        curve = RoundedPolyline(np.array(points), task.space.weights, 0.06)
        if not task.planner.curve_is_free(curve):
            return NoPlan("the raised hand has no room to swing", {"collision": 1})
        return task.timed("swing", curve, SWING_PACE)

    def _point(self, request: PointRequest) -> MovePlan | NoPlan:
        target = np.array(request.target_m)
        tasks = [
            _Gesture(self._model, request.q_start, request, hand, request.seed) for hand in request.hands
        ]
        tasks.sort(key=lambda task: float(np.linalg.norm(task.shoulder(request.q_start) - target)))
        answer: MovePlan | NoPlan = NoPlan("no hand may be used", {})
        # the other hand before many postures of the first
        for task, above_m, starts in [(task, *way) for way in POINT_WAYS for task in tasks]:

            def residual(q: Array, task: _Gesture = task, above_m: float = above_m) -> Array:
                tcp, elbow, shoulder = task.tcp(q), task.elbow(q), task.shoulder(q)
                towards = target - shoulder
                far = float(np.linalg.norm(towards))
                reach = max(min(STRETCHED * task.length_m(q), far - POINT_ROOM_M), 0.2)
                return np.concatenate(
                    [
                        _unlike(tcp[:3, 3] - elbow, target - elbow),
                        0.5 * _unlike(tcp[:3, 0], target - tcp[:3, 3]),
                        0.15 * (tcp[:3, 3] - shoulder - reach * towards / far - above_m * _UP),
                    ]
                )

            def meets(q: Array, task: _Gesture = task) -> bool:
                return beside_ray_m(task.elbow(q), task.tcp(q)[:3, 3], target) <= 2.0 * ENOUGH

            answer = task.reach("point", residual, target, meets, "pointing at it", 0.1, starts)
            if isinstance(answer, MovePlan):
                break
        return answer

    def _offer(self, request: OfferRequest) -> MovePlan | NoPlan:
        body = request.scene.attached[request.held]
        frames = self._model.description.tcp_frames
        hand = next(hand for hand, frame in frames.items() if frame == body.frame)
        task = _Gesture(self._model, request.q_start, request, hand, request.seed)
        person = np.array(request.person_m)
        ahead, inwards, down = OFFER_M

        def residual(q: Array) -> Array:
            shoulder, bearing = task.shoulder(q), task.bearing(q, person)
            far = float(np.linalg.norm((person - shoulder)[:2]))
            turn = poses.rotation_z(bearing)
            place = shoulder + turn @ (min(ahead, far - OFFER_ROOM_M), -task.outwards * inwards, -down)
            tcp = task.tcp(q)
            item = tcp @ body.frame_T_object
            return np.concatenate(
                [
                    item[:3, 3] - place,
                    0.5 * _unlike(item[:3, 2], _UP),
                    0.03 * _unlike(tcp[:3, 0], turn[:, 0]),
                    [0.06 * float(tcp[:3, 1] @ turn[:, 0])],
                ]
            )

        def upright(q: Array) -> bool:
            return bool((task.tcp(q) @ body.frame_T_object)[2, 2] >= np.cos(0.05))

        def out_of_the_way(q: Array) -> bool:
            towards = poses.rotation_z(task.bearing(q, person))[:, 0]
            return upright(q) and abs(float(task.tcp(q)[:3, 1] @ towards)) <= BESIDE_FINGERS

        for good, goodness in ((out_of_the_way, "with the fingers out of the way"), (upright, "upright")):
            answer = task.reach("offer", residual, person, good, goodness, enough=0.12)
            if isinstance(answer, MovePlan):
                break
        return answer

    def _carry(self, request: CarryRequest) -> MovePlan | NoPlan:
        body = request.scene.attached[request.held]
        frames = self._model.description.tcp_frames
        hand = next(hand for hand, frame in frames.items() if frame == body.frame)
        task = _Gesture(self._model, request.q_start, request, hand, request.seed)
        home = self._model.home_over(request.stance)
        facing = poses.rotation_z(poses.yaw_of(poses.rotation_from_quaternion(home[3:7])))
        ahead, inwards, down = CARRY_M
        watched = home[:3] + facing @ CARRY_LOOK_M
        watched[2] = CARRY_LOOK_M[2]

        def residual(q: Array) -> Array:
            place = task.shoulder(q) + facing @ (ahead, -task.outwards * inwards, -down)
            tcp = task.tcp(q)
            item = tcp @ body.frame_T_object
            return np.concatenate(
                [
                    0.2 * (item[:3, 3] - place),
                    _unlike(item[:3, 2], _UP),
                    0.02 * _unlike(tcp[:3, 0], facing[:, 0]),
                    [0.5 * task.turned_past(q, watched)],
                ]
            )

        def upright(q: Array) -> bool:
            return bool((task.tcp(q) @ body.frame_T_object)[2, 2] >= np.cos(CARRY_TILT_RAD))

        return task.reach("carry", residual, watched, upright, "upright", enough=0.08)


class _Gesture:
    """The state of one gesture's planning.

    Attributes:
        arm: Joints of the arm.
        outwards: 1 for the left hand, -1 for the right one: the sign of its side.
        space: The free coordinates.
        scene: The scene, with margins that the start keeps.
        planner: Of paths in that scene.
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
        self.space: FreeCoordinates = free_coordinates(model, request.stance)
        self.scene: PlanningScene = relaxed_at(model, request.scene, q_start, RESERVE_M)
        self.planner = PathPlanner(
            model, self.space, validity(model, request.stance, self.scene, RESERVE_M, RESERVE_M)
        )

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

    def reach(
        self,
        name: str,
        residual: Residual,
        look_m: Array,
        good: Callable[[Array], bool],
        goodness: str,
        enough: float = ENOUGH,
        starts: int = STARTS,
    ) -> MovePlan | NoPlan:
        """Plan to a posture with a small residual that is ``good`` and free, looking at a point."""
        reasons: Counter[str] = Counter()
        joints = (*self.arm, *self._turning)
        columns = 7 + self._model.indices(joints)
        for q_seed in self._starts(columns, look_m, starts):
            found = arm_posture(self._model, q_seed, joints, residual, self._home[columns])
            if found.error > enough:
                reasons["out of reach"] += 1
                continue
            if not good(found.q):
                reasons[f"not {goodness}"] += 1
                continue
            goal = found.q.copy()
            for joint, angle in gaze_joints(self._model, goal, look_m).items():
                goal[7 + self._model.joint_index(joint)] = angle
            x_start, x_goal = self.space.from_q(self._q_start), self.space.from_q(goal)
            if not self.planner.is_free(x_goal):
                reasons["collision or lost balance"] += 1
                continue
            curve = self.planner.plan(x_start, x_goal, self._moving(joints), self._rng)
            if curve is None:
                reasons["no path"] += 1
                continue
            return self.timed(name, curve, GESTURE_PACE)
        return NoPlan(f"no posture of the {self._hand} arm for that was found", reasons)

    def timed(self, name: str, curve: Curve, pace: Pace) -> MovePlan | NoPlan:
        """Give a free curve its time."""
        trajectory = time_in_balance(self._model, self.space, self._stance, curve, pace)
        if trajectory is None:
            return NoPlan("the legs cannot follow the motion", {"legs cannot follow": 1})
        trajectory = lead_in(trajectory, self._q_start, self._model.acceleration)
        return MovePlan(PlannedStep(name, trajectory, self.scene))

    def _starts(self, columns: NDArray[np.intp], look_m: Array, count: int) -> Iterator[Array]:
        """From home with the trunk turned, the other arm where it is, then random ones about that."""
        q = self._home.copy()
        other_arm = self._model.group("left_arm" if self._hand == "right" else "right_arm")
        q[7 + other_arm] = self._q_start[7 + other_arm]
        turning = 7 + self._model.indices(self._turning)
        q[turning] -= self.turned_past(q, look_m) / max(len(turning), 1)
        yield q
        for _ in range(count):
            other = q.copy()
            other[columns] += self._rng.uniform(-_SPREAD_RAD, _SPREAD_RAD, len(columns))
            yield other

    def _moving(self, joints: Sequence[str]) -> list[int]:
        return [self.space.index(joint) for joint in joints]


def _is_vertical(model: RobotModel, joint: str) -> bool:
    """Whether a joint turns about the vertical at home."""
    data = model.pin.createData()
    pin.computeJointJacobians(model.pin, data, model.q_home)
    index = model.pin.getJointId(joint)
    axis = pin.getJointJacobian(model.pin, data, index, pin.ReferenceFrame.WORLD)[3:, :]
    own = axis[:, int(model.pin.joints[index].idx_v)]
    return bool(abs(own[2]) > 0.99)


def _unlike(a: Array, b: Array) -> Array:
    """Difference of two directions as unit vectors, shape (3,)."""
    a, b = a / np.linalg.norm(a), b / np.linalg.norm(b)
    return np.asarray(b - a)
