"""Plan gestures: raise a hand and wave, point at something, offer what is held.

A gesture is a posture of one arm and the trunk's turn that meets a few conditions; it is searched from
several starts, judged like any goal, and reached by the path planner. The robot looks where it means.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial

import numpy as np
from numpy.typing import NDArray

from kinematics import poses
from kinematics.arm_posture import arm_posture
from kinematics.gesture_requests import (
    CarryRequest,
    GestureRequest,
    OfferRequest,
    PointRequest,
    RaiseHandRequest,
    SwingRequest,
)
from kinematics.gesture_task import ENOUGH, STARTS, GestureTask, Wish
from kinematics.pointing import beside_ray_m
from kinematics.requests import MovePlan, NoPlan
from kinematics.robot_description import Hand
from kinematics.robot_model import RobotModel

Array = NDArray[np.float64]

MakeTask = Callable[[RobotModel, Array, GestureRequest, Hand, int], GestureTask]
"""Begins to plan a gesture of a hand from a configuration, with a seed."""

# Where a waving hand is, from its shoulder: ahead, outwards, up. Elbow bent, beside the head.
WAVING_M = (0.24, 0.20, 0.27)
# Where an offered object is, from the shoulder: ahead, inwards, down. Within a person's easy grasp.
OFFER_M = (0.50, 0.06, 0.22)
# What a decimetre off that place counts, when the fingers are in the way there.
OFFER_FREEDOM = 0.2
# Between an offered object and the person's axis, at least: an arm's length of room.
OFFER_ROOM_M = 0.55
# Cosine of the angle between the fingers' closing and the way to the person, at most: a cup in an open hand
# has 1 cm on each side, and is pulled against a finger when it leaves farther off than that.
BESIDE_FINGERS = 0.12
# Of the whole arm, how far a pointing hand is stretched.
STRETCHED = 0.85
# Where a carried object is, from the shoulder: ahead, inwards, down.
CARRY_M = (0.36, 0.05, 0.26)
CARRY_TILT_RAD = 0.02
# So much higher where something stands beside it that the sway of the first steps could reach: a cup knocked
# over a can that its hand had stood 3 cm above and 8 cm beside.
CARRY_RAISED_M = (0.0, 0.1, 0.2)
CARRY_ROOM_M = 0.06
CARRY_STARTS = 3
# Where a robot that carries something looks, from the middle of its feet: ahead, aside, and height.
CARRY_LOOK_M = np.array([2.0, 0.0, 0.6])
# A pointing hand stays this far from what it points at.
POINT_ROOM_M = 0.15
# Ways to point, tried with each hand in turn: the hand so far above the line from the shoulder, and the
# number of starts. Above a table there is more room for an arm that is held high.
POINT_WAYS = ((0.0, 1), (0.12, 2), (0.24, 2), (0.0, STARTS))
# How far beside home an arm begins that searches how to point: its elbow has to find its way up. Of 45 plans
# amid things each took half the time that it took with half of this.
POINT_SPREAD_RAD = 1.2
# A posture that turns the trunk less than this past its target is facing it.
FACING_RAD = 0.2
_UP = np.array([0.0, 0.0, 1.0])


class GesturePlanner:
    """Answers gesture requests for one robot."""

    def __init__(self, model: RobotModel, make_task: MakeTask | None = None) -> None:
        """Plan for a robot.

        Args:
            model: The robot.
            make_task: How it gets to postures. Left out, past what is around and in balance.
        """
        if make_task is None:
            # imported here: it brings the compiler
            from kinematics.planned_gesture import PlannedGesture

            make_task = PlannedGesture
        self._model, self._make_task = model, make_task

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
        task = self._make_task(self._model, request.q_start, request, request.hand, request.seed)
        target = np.array(request.towards_m)
        ahead, aside, up = WAVING_M

        def residual(q: Array) -> Array:
            turn = poses.rotation_z(task.bearing(q, target))
            place = task.shoulder(q) + turn @ (ahead, task.outwards * aside, up)
            tcp = task.tcp(q)
            return np.concatenate(
                [tcp[:3, 3] - place, 0.3 * _unlike(tcp[:3, 0], _UP), [0.5 * task.turned_past(q, target)]]
            )

        def faces(q: Array) -> bool:
            return abs(task.turned_past(q, target)) <= FACING_RAD

        return task.reach("raise", Wish(residual, target, faces, "facing it"))

    def _swing(self, request: SwingRequest) -> MovePlan | NoPlan:
        task = self._make_task(self._model, request.q_start, request, request.hand, 0)
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
            ends.append(found.q)
        return task.swing([q, *(ends[k % 2] for k in range(request.swings + 1)), q])

    def _point(self, request: PointRequest) -> MovePlan | NoPlan:
        target = np.array(request.target_m)
        tasks = [
            self._make_task(self._model, request.q_start, request, hand, request.seed)
            for hand in request.hands
        ]
        tasks.sort(key=lambda task: float(np.linalg.norm(task.shoulder(request.q_start) - target)))
        answer: MovePlan | NoPlan = NoPlan("no hand may be used", {})
        # the other hand before many postures of the first
        for task, above_m, starts in [(task, *way) for way in POINT_WAYS for task in tasks]:

            def residual(q: Array, task: GestureTask = task, above_m: float = above_m) -> Array:
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

            def meets(q: Array, task: GestureTask = task) -> bool:
                return beside_ray_m(task.elbow(q), task.tcp(q)[:3, 3], target) <= 2.0 * ENOUGH

            wish = Wish(residual, target, meets, "pointing at it", 0.1, starts, POINT_SPREAD_RAD)
            answer = task.reach("point", wish)
            if isinstance(answer, MovePlan):
                break
        return answer

    def _offer(self, request: OfferRequest) -> MovePlan | NoPlan:
        body = request.scene.attached[request.held]
        frames = self._model.description.tcp_frames
        hand = next(hand for hand, frame in frames.items() if frame == body.frame)
        task = self._make_task(self._model, request.q_start, request, hand, request.seed)
        person = np.array(request.person_m)
        ahead, inwards, down = OFFER_M

        def across(tcp: poses.Transform, item: poses.Transform) -> float:
            """Cosine of the angle between the fingers' closing and the way to the person."""
            way = (person - item[:3, 3])[:2]
            return float(tcp[:2, 1] @ way) / math.hypot(*way)

        def residual(q: Array, place_weight: float, finger_weight: float) -> Array:
            shoulder, bearing = task.shoulder(q), task.bearing(q, person)
            far = math.hypot(*(person - shoulder)[:2])
            turn = poses.rotation_z(bearing)
            place = shoulder + turn @ (min(ahead, far - OFFER_ROOM_M), -task.outwards * inwards, -down)
            tcp = task.tcp(q)
            item = tcp @ body.frame_T_object
            return np.concatenate(
                [
                    place_weight * (item[:3, 3] - place),
                    0.5 * _unlike(item[:3, 2], _UP),
                    0.03 * _unlike(tcp[:3, 0], turn[:, 0]),
                    [finger_weight * across(tcp, item)],
                ]
            )

        def upright(q: Array) -> bool:
            return bool((task.tcp(q) @ body.frame_T_object)[2, 2] >= np.cos(0.05))

        def out_of_the_way(q: Array) -> bool:
            tcp = task.tcp(q)
            return upright(q) and abs(across(tcp, tcp @ body.frame_T_object)) <= BESIDE_FINGERS

        answer: MovePlan | NoPlan = NoPlan("nothing was tried", {})
        for place_weight, finger_weight, good, goodness, starts in (
            (1.0, 0.1, out_of_the_way, "with the fingers out of the way", 3),
            (OFFER_FREEDOM, 0.3, out_of_the_way, "with the fingers out of the way", STARTS),
            (1.0, 0.0, upright, "upright", STARTS),
        ):
            weighed = partial(residual, place_weight=place_weight, finger_weight=finger_weight)
            answer = task.reach("offer", Wish(weighed, person, good, goodness, 0.12, starts))
            if isinstance(answer, MovePlan):
                break
        return answer

    def _carry(self, request: CarryRequest) -> MovePlan | NoPlan:
        body = request.scene.attached[request.held]
        frames = self._model.description.tcp_frames
        hand = next(hand for hand, frame in frames.items() if frame == body.frame)
        task = self._make_task(self._model, request.q_start, request, hand, request.seed)
        home = self._model.home_over(request.stance)
        facing = poses.rotation_z(poses.yaw_of(poses.rotation_from_quaternion(home[3:7])))
        ahead, inwards, down = CARRY_M
        watched = home[:3] + facing @ CARRY_LOOK_M
        watched[2] = CARRY_LOOK_M[2]

        def residual(q: Array, raised_m: float) -> Array:
            place = task.shoulder(q) + facing @ (ahead, -task.outwards * inwards, raised_m - down)
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

        has_room = task.room_for(CARRY_ROOM_M)

        def good(q: Array) -> bool:
            return upright(q) and has_room(q)

        for raised_m in CARRY_RAISED_M:
            raised = partial(residual, raised_m=raised_m)
            wish = Wish(raised, watched, good, "upright, with room", 0.08, CARRY_STARTS)
            answer = task.reach("carry", wish)
            if isinstance(answer, MovePlan):
                return answer
        low = partial(residual, raised_m=0.0)
        return task.reach("carry", Wish(low, watched, upright, "upright", enough=0.08))


def _unlike(a: Array, b: Array) -> Array:
    """Difference of two directions as unit vectors, shape (3,)."""
    # numpy takes longer for the length of three numbers than for all the rest
    return np.asarray(b / math.hypot(*b) - a / math.hypot(*a))
