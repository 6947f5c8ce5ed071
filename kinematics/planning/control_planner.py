"""Plan to turn a knob, or to come to a button that is pressed.

A knob has a bar that pads take on both sides; the hand comes along the knob's axis and turns about it. To a
button the closed hand comes with what of it is foremost. Few ways come into question: the hand either way up,
and each hand.
"""

from __future__ import annotations

import dataclasses
import itertools
import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from kinematics.arrays import Array, Sealed
from kinematics.geometry import poses
from kinematics.geometry.poses import Transform
from kinematics.geometry.shapes import Box
from kinematics.ik.gaze import gaze_joints
from kinematics.ik.result import IkTolerance
from kinematics.ik.solver import LINE_RESERVE_RAD, along_line, along_poses
from kinematics.model.robot_description import Hand
from kinematics.model.robot_model import RobotModel
from kinematics.motion.curves import Curve, PolynomialCurve
from kinematics.motion.lead_in import lead_in
from kinematics.planning.grasps import key_of
from kinematics.planning.planning_task import CARTESIAN_PACE, CARTESIAN_POINTS, REACH_PACE, PlanningTask
from kinematics.planning.pressing import pressing_faces
from kinematics.planning.pushing import hand_points
from kinematics.requests.control import ControlPlan, ControlRequest, TurnPlan, TurnRequest
from kinematics.requests.grasp import Grasp
from kinematics.requests.step import NoPlan, WhyNoPlan
from kinematics.scene.concessions import ConcessionReason, touching
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from kinematics.standing.reserves import HANDED_ON_RESERVE_M, PLANNING_RESERVE_M
from kinematics.timing.curve_timing import Pace

_APPROACH_M = 0.08
_FINGER_ROOMS_M = (("", 0.012), (" less deep", 0.020), (" at its end", 0.028))
"""Between closed fingertips and what a knob is on, in words and m: that is misjudged by millimetres too."""
_TURN_POINTS = 5
_TURN_PACE = Pace(velocity=0.25, acceleration=0.5)
_ROLLS = (0.0, math.pi)
_SHARES = (1.0, 0.85, 0.7)
"""Of a turn, where the hand holds the knob otherwise than was thought: what has switched is seen."""
_TOLERANCE = IkTolerance(com_margin_m=0.05)
_ALONG = np.array([1.0, 0.0, 0.0])


class ControlPlanner:
    """Answers control requests for one robot."""

    def __init__(self, model: RobotModel) -> None:
        self._model = model

    def plan(self, request: ControlRequest) -> ControlPlan | NoPlan:
        """The first way that goes, or honestly why there is none."""
        task = _ControlTask(self._model, request)
        for way in task.ways():
            if (plan := task.tried(way, task.plan_of)) is not None:
                return plan
        told = f"no way for a hand to the {request.control} from here was found"
        numbers = {"ways_considered": float(task.considered)}
        return NoPlan(told, dict(task.reasons), numbers, WhyNoPlan.NO_GRASP)

    def plan_turn(self, request: TurnRequest) -> TurnPlan | NoPlan:
        """The turn of a knob that a hand holds, or honestly why there is none."""
        asked = ControlRequest(request.q_start, request.stance, request.scene, request.control)
        return _ControlTask(self._model, asked).turn_plan(request.hand, request.turn_rad)


@dataclass(frozen=True, slots=True)
class _Way(Sealed):
    """Where a hand is at the end of its approach, how it comes there, in the TCP frame, and how short."""

    grasp: Grasp
    inwards: Array
    short_m: float = 0.0


class _ControlTask(PlanningTask):
    """One knob or button to come to: its candidates are poses of the hand."""

    def __init__(self, model: RobotModel, request: ControlRequest) -> None:
        super().__init__(model, request, PLANNING_RESERVE_M, HANDED_ON_RESERVE_M, start_reserve_m=0.0)
        self.request = request

    def ways(self) -> Iterator[_Way]:
        """Candidates, the most promising first."""
        request = self.request
        control = request.scene.objects[request.control]
        found = self._pressing if request.turn_rad is None else self._about
        for way in itertools.chain.from_iterable(found(control, hand) for hand in request.hands):
            if key_of(way.grasp.hand, way.grasp.label) not in request.excluded:
                yield way

    def _about(self, knob: SceneObject, hand: Hand) -> Iterator[_Way]:
        """At a knob: its x inwards, its y across the bar."""
        pose, long = knob.world_T_object, _long_m(knob)
        points = hand_points(self._model, hand, self.request.q_start)
        advance_m = self._model.description.grippers[hand].closing_advance_m
        for (deep, room_m), roll in itertools.product(_FINGER_ROOMS_M, _ROLLS):
            rotation = pose[:3, :3] @ poses.rotation_x(0.5 * math.pi + roll)
            stands_off_m = float(points[:, 0].max()) + advance_m + room_m
            at = pose[:3, 3] + (0.5 * long - stands_off_m) * pose[:3, 0]
            label = f"roll {math.degrees(roll):.0f}{deep}"
            yield _Way(_grasp(knob, hand, label, poses.transform(rotation, at)), _ALONG)

    def _pressing(self, button: SceneObject, hand: Hand) -> Iterator[_Way]:
        """Before a button: what of the closed hand can press comes inwards.

        Fingers are judged open: where they would come before the hand that is closed, feeling begins sooner.
        """
        pose = button.world_T_object
        yaw, face_m = poses.yaw_of(pose[:3, :3]), pose[:3, 3] - 0.5 * _long_m(button) * pose[:3, 0]
        faces = pressing_faces(self._model, hand, self.request.q_start)
        if not faces:
            self.reasons["its fingers always come before its palm"] += 1
        for face in faces:
            short_m, inwards = self.request.short_m + face.open_ahead_m, face.tcp_R_face[:, 0]
            for roll in face.rolls_rad:
                turned = poses.rotation_z(yaw) @ poses.rotation_x(0.5 * math.pi + roll)
                rotation = turned @ face.tcp_R_face.T
                at = face_m - rotation @ (face.point_m + short_m * inwards)
                label = f"{face.label}roll {math.degrees(roll):.0f}"
                yield _Way(_grasp(button, hand, label, poses.transform(rotation, at)), inwards, short_m)

    def plan_of(self, way: _Way) -> ControlPlan | str:
        """The whole plan for one way, or why there is none."""
        grasp = way.grasp
        request, ik = self.request, self.ik_of(grasp.hand)
        found = ik.solve(grasp.world_T_tcp, request.q_start)
        if not found.within(_TOLERANCE):
            return "no inverse kinematics there"
        touched = self._touching(grasp.hand)
        near = self.planner_in(touched)
        blocked = near.judge.not_free(self.space.from_q(found.q))
        if blocked is not None:
            return "collision there" if blocked.pair is not None else str(blocked)
        before = grasp.world_T_tcp @ poses.transform(np.eye(3), -grasp.approach_m * way.inwards)
        back = along_line(ik, found.q, grasp.world_T_tcp, before, CARTESIAN_POINTS)
        if back is None:
            return "no straight approach"
        gaze = gaze_joints(self._model, back[-1], grasp.world_T_tcp[:3, 3])
        approach = PolynomialCurve(self.looking(self.rows(back[::-1]), gaze))
        x_before, x_there = approach(np.array([0.0, 1.0]))
        if not self.planner.is_free(x_before) or not near.curve_is_free(approach):
            return "approach collides"
        links = self._model.description.grippers[grasp.hand].touch_links
        in_hand = touching(links, (request.control,), ConcessionReason.HANDLE_IN_HAND, "approach")
        if request.turn_rad is not None:
            q_there = self.space.to_q(x_there[None, :])[0][0]
            ways = (self.turned(grasp.hand, q_there, share * request.turn_rad) for share in _SHARES)
            reasons = [way for way in ways if isinstance(way, str)]
            if len(reasons) == len(_SHARES):
                return reasons[-1]
        arms = self._model.description.arms
        reach = self.path(x_before, arms, np.random.default_rng(request.seed))
        if reach is None:
            return "no path to it"
        first = self.first_step("reach", reach, REACH_PACE)
        second = self.step("approach", approach, CARTESIAN_PACE, in_hand)
        if first is None or second is None:
            return "legs cannot follow"
        return ControlPlan(grasp, first, second, self.considered, way.short_m)

    def turned(
        self, hand: Hand, q: Array, turn_rad: float, scene: PlanningScene | None = None
    ) -> tuple[Curve, Curve] | str:
        """The turn of a hand about its own x from a configuration, and the way straight back."""
        found = self._turned(hand, q, turn_rad, scene, 0.0)
        if isinstance(found, str):  # between joints at their limit a curve leads beyond it
            again = self._turned(hand, q, turn_rad, scene, LINE_RESERVE_RAD)
            found = found if isinstance(again, str) else again
        return found

    def _turned(
        self, hand: Hand, q: Array, turn_rad: float, scene: PlanningScene | None, reserve_rad: float
    ) -> tuple[Curve, Curve] | str:
        ik, frame = self.ik_of(hand), self._model.description.grippers[hand].tcp_frame
        start = self._model.frame_pose(q, frame)
        turns = [
            start @ poses.transform(poses.rotation_x(share * turn_rad), (0.0, 0.0, 0.0))
            for share in np.linspace(0.0, 1.0, _TURN_POINTS)[1:]
        ]
        configurations = along_poses(ik, q, turns, reserve_rad)
        if configurations is None:
            return "the wrist does not turn so far"
        near = self.planner_in(self._touching(hand, scene))
        curve = PolynomialCurve(self._with_gaze(configurations, q))
        if not near.curve_is_free(curve):
            return "turning collides"
        before = turns[-1] @ poses.translation(-_APPROACH_M, 0.0, 0.0)
        line = along_line(ik, configurations[-1], turns[-1], before, CARTESIAN_POINTS, reserve_rad)
        if line is None:
            return "no straight way back"
        away = PolynomialCurve(self._with_gaze(line, q))
        return (curve, away) if near.curve_is_free(away) else "the way back collides"

    def turn_plan(self, hand: Hand, turn_rad: float) -> TurnPlan | NoPlan:
        """The turn from where the hand is, with the knob in it."""
        control = self.request.control
        q = self.request.q_start
        turned: tuple[Curve, Curve] | str = ""
        for share in _SHARES:
            turned = self.turned(hand, q, share * turn_rad, self.scene)
            if not isinstance(turned, str):
                break
            self.reasons[turned] += 1
        if isinstance(turned, str):
            return NoPlan(f"the {control} cannot be turned from here", dict(self.reasons))
        links = self._model.description.grippers[hand].touch_links
        steps = []
        for name, curve, pace in zip(("turn", "back"), turned, (_TURN_PACE, CARTESIAN_PACE), strict=True):
            in_hand = touching(links, (control,), ConcessionReason.HANDLE_IN_HAND, name)
            step = self.step(name, curve, pace, (*self.start_concessions(name), *in_hand))
            if step is None:
                return NoPlan(f"the {control} cannot be turned from here", {"legs cannot follow": 1})
            steps.append(step)
        led = lead_in(steps[0].trajectory, q, self._model.acceleration)
        return TurnPlan(dataclasses.replace(steps[0], trajectory=led), steps[1])

    def _with_gaze(self, configurations: Array, q: Array) -> Array:
        """Rows of free coordinates in which the head stays where it is at ``q``."""
        rows = self.rows(configurations)
        head = self.space.from_q(q)
        for joint in self._model.description.camera.neck or ():
            column = self.space.index(joint)
            rows[:, column] = head[column]
        return rows

    def _touching(self, hand: Hand, scene: PlanningScene | None = None) -> PlanningScene:
        """A scene, the request's when left out, in which this hand may touch the control."""
        links = self._model.description.grippers[hand].touch_links
        around = self.request.scene if scene is None else scene
        return around.allowing((link, self.request.control) for link in links)


def _long_m(control: SceneObject) -> float:
    """How far a knob or button stands out."""
    return control.shape.size_m[0] if isinstance(control.shape, Box) else 0.0


def _grasp(control: SceneObject, hand: Hand, label: str, world_T_tcp: Transform) -> Grasp:
    thick_m = control.shape.size_m[2] if isinstance(control.shape, Box) else 0.02
    return Grasp(hand, label, world_T_tcp, _APPROACH_M, thick_m)
