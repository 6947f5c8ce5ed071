"""Plan gestures: raise a hand and wave, point at something, offer what is held.

A gesture is a posture of one arm and the trunk's turn that meets a few conditions; it is searched from
several starts, judged like any goal, and reached by the path planner. The robot looks where it means.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from functools import partial
from typing import Any

import numpy as np

from kinematics.arrays import Array
from kinematics.geometry import poses
from kinematics.ik.arm_frames import ArmFrames, arm_kinematics, beside_ray_m
from kinematics.ik.arm_posture import arm_posture
from kinematics.ik.held_upright import UP, HeldInHand, unlike
from kinematics.model.robot_description import Hand
from kinematics.model.robot_model import RobotModel
from kinematics.model.standing_robot import StandingRobot
from kinematics.planning.gesture_task import ENOUGH, STARTS, GestureTask, Wish
from kinematics.requests.gesture import (
    CarryRequest,
    GestureRequest,
    OfferRequest,
    PointRequest,
    RaiseHandRequest,
    SwingRequest,
)
from kinematics.requests.move import MovePlan
from kinematics.requests.request import Request
from kinematics.requests.step import NoPlan

MakeTask = Callable[[RobotModel, Array, GestureRequest, Hand, int], GestureTask]
"""Begins to plan a gesture of a hand from a configuration, with a seed."""

# Where a waving hand is, from its shoulder: ahead, outwards, up. Elbow bent, beside the head.
WAVING_M = (0.24, 0.20, 0.27)
# Where an offered object is, from the shoulder: ahead, inwards, down. Within a person's easy grasp.
OFFER_M = (0.50, 0.06, 0.22)
# What a decimetre off that place counts, when the fingers are in the way there.
OFFER_FREEDOM = 0.2
# How far it leans, at most.
OFFER_TILT_RAD = 0.05
# Between an offered object and the person's axis, at least: an arm's length of room.
OFFER_ROOM_M = 0.55
# Cosine of the angle between the fingers' closing and the way to the person, at most: a cup in an open hand
# has 1 cm on each side, and is pulled against a finger when it leaves farther off than that.
BESIDE_FINGERS = 0.12
# Cosine of the angle between the way to the person and the hand's own axis backwards, at most: a can that was
# pulled into the palm stayed in the open hand, and the hand that went home met the person's fingers.
BEFORE_PALM = 0.2
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
            from kinematics.planning.planned_gesture import PlannedGesture

            make_task = PlannedGesture
        self._model, self._make_task = model, make_task

    @property
    def planners(self) -> Mapping[type[Request[Any]], Callable[[Any], MovePlan | NoPlan]]:
        """Who plans which gesture."""
        return {
            RaiseHandRequest: self._raise,
            SwingRequest: self._swing,
            PointRequest: self._point,
            CarryRequest: self._carry,
            OfferRequest: self._offer,
        }

    def plan(self, request: GestureRequest) -> MovePlan | NoPlan:
        """Plan one gesture, or say honestly why there is none."""
        return self.planners[type(request)](request)

    def _raise(self, request: RaiseHandRequest) -> MovePlan | NoPlan:
        task = self._make_task(self._model, request.q_start, request, request.hand, request.seed)
        target = np.array(request.towards_m)
        ahead, aside, up = (task.share * measure for measure in WAVING_M)

        def residual(at: ArmFrames) -> Array:
            turn = poses.rotations_z(at.bearing_rad(target))
            place = at.shoulder_m + turn @ (ahead, task.outwards * aside, up)
            return np.column_stack(
                [
                    at.tcp_m - place,
                    0.3 * unlike(at.world_R_tcp[:, :, 0], UP),
                    0.5 * at.turned_past_rad(target),
                ]
            )

        def facing(at: ArmFrames) -> bool:
            return abs(float(at.turned_past_rad(target)[0])) <= FACING_RAD

        return task.reach("raise", Wish(residual, target, facing, "facing it"))

    def _swing(self, request: SwingRequest) -> MovePlan | NoPlan:
        task = self._make_task(self._model, request.q_start, request, request.hand, 0)
        q = request.q_start
        arm = arm_kinematics(self._model, request.hand, trunk=False)
        start = arm.at(q)
        across = poses.rotation_z(float(start.heading_rad[0])) @ (0.0, 0.5 * request.width_m, 0.0)
        ends = []
        for side in (1.0, -1.0):
            place = start.tcp_m[0] + side * across

            def residual(at: ArmFrames, place: Array = place) -> Array:
                return np.hstack([at.tcp_m - place, 0.05 * unlike(at.world_R_tcp[:, :, 0], UP)])

            found = arm_posture(self._model, arm, q, residual, q[arm.columns])
            if float(np.linalg.norm(arm.at(found.q).tcp_m[0] - place)) > ENOUGH:
                return NoPlan("the raised hand has no room to swing", {"out of reach": 1})
            ends.append(found.q)
        return task.swing([q, *(ends[k % 2] for k in range(request.swings + 1)), q])

    def _point(self, request: PointRequest) -> MovePlan | NoPlan:
        target = np.array(request.target_m)
        tasks = [
            self._make_task(self._model, request.q_start, request, hand, request.seed)
            for hand in request.hands
        ]
        tasks.sort(key=lambda task: math.dist(task.arm.at(request.q_start).shoulder_m[0], target))
        answer: MovePlan | NoPlan = NoPlan("no hand may be used", {})
        # the other hand before many postures of the first
        for task, above_m, starts in [(task, *way) for way in POINT_WAYS for task in tasks]:

            def residual(at: ArmFrames, above_m: float = above_m) -> Array:
                towards = target - at.shoulder_m
                far = np.linalg.norm(towards, axis=1)
                reach = np.maximum(np.minimum(STRETCHED * at.length_m(), far - POINT_ROOM_M), 0.2)
                way = (reach / far)[:, None] * towards + above_m * UP
                return np.hstack(
                    [
                        unlike(at.tcp_m - at.elbow_m, target - at.elbow_m),
                        0.5 * unlike(at.world_R_tcp[:, :, 0], target - at.tcp_m),
                        0.15 * (at.tcp_m - at.shoulder_m - way),
                    ]
                )

            def meets(at: ArmFrames) -> bool:
                return beside_ray_m(at.elbow_m[0], at.tcp_m[0], target) <= 2.0 * ENOUGH

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
        held, person = HeldInHand(body.frame_T_object), np.array(request.person_m)
        ahead, inwards, down = (task.share * measure for measure in OFFER_M)

        def across(at: ArmFrames, item_m: Array) -> Array:
            """Cosine of the angle between the fingers' closing and the way to the person, shape (n,)."""
            way = (person - item_m)[:, :2]
            return np.asarray(np.sum(at.world_R_tcp[:, :2, 1] * way, axis=1) / np.hypot(*way.T))

        def goes_with_pull(at: ArmFrames) -> bool:
            """Whether the palm is not between the object and the person, who would pull it into the palm."""
            way = (person - held.places_m(at))[0, :2]
            along = float(at.world_R_tcp[0, :2, 0] @ way) / float(np.hypot(*way))
            return upright(at) and along >= -BEFORE_PALM

        def residual(at: ArmFrames, place_weight: float, finger_weight: float) -> Array:
            far = np.hypot(*(person - at.shoulder_m)[:, :2].T)
            turn = poses.rotations_z(at.bearing_rad(person))
            aside, below = -task.outwards * inwards * turn[:, :, 1], down * UP
            place = (
                at.shoulder_m + np.minimum(ahead, far - OFFER_ROOM_M)[:, None] * turn[:, :, 0] + aside - below
            )
            item_m = held.places_m(at)
            return np.column_stack(
                [
                    place_weight * (item_m - place),
                    0.5 * unlike(held.upwards(at), UP),
                    0.03 * unlike(at.world_R_tcp[:, :, 0], turn[:, :, 0]),
                    finger_weight * across(at, item_m),
                ]
            )

        def upright(at: ArmFrames) -> bool:
            return held.is_upright(at, OFFER_TILT_RAD)

        def out_of_the_way(at: ArmFrames) -> bool:
            return goes_with_pull(at) and abs(float(across(at, held.places_m(at))[0])) <= BESIDE_FINGERS

        answer: MovePlan | NoPlan = NoPlan("nothing was tried", {})
        for place_weight, finger_weight, good, goodness, starts in (
            (1.0, 0.1, out_of_the_way, "with the fingers out of the way", 3),
            (OFFER_FREEDOM, 0.3, out_of_the_way, "with the fingers out of the way", STARTS),
            (1.0, 0.0, goes_with_pull, "with the palm out of the way", STARTS),
            (1.0, 0.0, upright, "upright", STARTS),
        ):
            weighed = partial(residual, place_weight=place_weight, finger_weight=finger_weight)
            wish = Wish(weighed, person, good, goodness, 0.12, starts)
            answer = task.reach("offer", wish)
            if isinstance(answer, MovePlan):
                break
        return answer

    def _carry(self, request: CarryRequest) -> MovePlan | NoPlan:
        body = request.scene.attached[request.held]
        frames = self._model.description.tcp_frames
        hand = next(hand for hand, frame in frames.items() if frame == body.frame)
        task = self._make_task(self._model, request.q_start, request, hand, request.seed)
        home = StandingRobot.of(self._model, request.stance).q_home
        facing = poses.rotation_z(poses.yaw_of(poses.rotation_from_quaternion(home[3:7])))
        held = HeldInHand(body.frame_T_object)
        ahead, inwards, down = (task.share * measure for measure in CARRY_M)
        watched = home[:3] + facing @ CARRY_LOOK_M
        watched[2] = CARRY_LOOK_M[2]

        def residual(at: ArmFrames, raised_m: float) -> Array:
            place = at.shoulder_m + facing @ (ahead, -task.outwards * inwards, raised_m - down)
            return np.column_stack(
                [
                    0.2 * (held.places_m(at) - place),
                    unlike(held.upwards(at), UP),
                    0.02 * unlike(at.world_R_tcp[:, :, 0], facing[:, 0]),
                    0.5 * at.turned_past_rad(watched),
                ]
            )

        def upright(at: ArmFrames) -> bool:
            return held.is_upright(at, CARRY_TILT_RAD)

        has_room = task.room_for(CARRY_ROOM_M)

        for raised_m in CARRY_RAISED_M:
            raised = partial(residual, raised_m=raised_m)
            wish = Wish(
                raised,
                watched,
                upright,
                "upright",
                0.08,
                starts=CARRY_STARTS,
                has_room=has_room,
            )
            answer = task.reach("carry", wish)
            if isinstance(answer, MovePlan):
                return answer
        low = partial(residual, raised_m=0.0)
        wish = Wish(low, watched, upright, "upright", enough=0.08)
        return task.reach("carry", wish)
