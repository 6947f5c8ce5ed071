"""Plan to take hold of a handle so that its whole path is within reach.

Few grasps come into question: the pads on either side of the bar, from straight ahead or turned about it.
A grasp is taken when the hand gets there, comes straight to it, and when the rehearsal of the path ends
where it should.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Iterator

import numpy as np

from kinematics.arrays import Array
from kinematics.geometry import poses
from kinematics.geometry.shapes import Box, Cylinder
from kinematics.ik.gaze import gaze_joints
from kinematics.ik.result import IkResult, IkTolerance
from kinematics.ik.solver import along_line
from kinematics.model.palm_grip import way_to_bar
from kinematics.model.robot_description import Hand
from kinematics.model.robot_model import RobotModel
from kinematics.motion.curves import Curve, PolynomialCurve
from kinematics.planning.finger_room import fitting_opening_m, stands_out
from kinematics.planning.grasps import key_of
from kinematics.planning.opening_rehearsal import rehearse
from kinematics.planning.planning_task import CARTESIAN_PACE, CARTESIAN_POINTS, PlanningTask
from kinematics.planning.pushing import assumed_bars, outward_of, push_grasps, shut_at
from kinematics.requests.grasp import Grasp
from kinematics.requests.handle import HandlePlan, HandleRequest
from kinematics.requests.step import NoPlan, WhyNoPlan
from kinematics.scene.concessions import Concession, ConcessionReason
from kinematics.scene.opening_path import DoorArc
from kinematics.scene.planning_scene import PlanningScene
from kinematics.standing.reserves import HANDED_ON_RESERVE_M, PLANNING_RESERVE_M
from kinematics.timing.curve_timing import Pace

APPROACH_M = 0.10
SHORT_M = 0.010
"""The TCP stops so far before the bar's middle, where fingers swing ahead as they close: behind the bar there
is no more room than they need."""
SEEN_WITHIN_M = 0.02
"""A handle may be seen so far before or behind where it is."""
_OVERLAP = 0.8
"""Of the pads' length: so far apart are the depths at which short pads try, one attempt after the other."""
# Slower than other reaches: what swings open is met before the eyes and the brake have done their part.
_REACH_PACE = Pace(velocity=0.35, acceleration=0.6)
_TILTS_RAD = (0.0, 0.4, 0.8)
"""How far a hand comes from above to a bar that lies, and has something beside it: a table below."""
_UPRIGHT: tuple[tuple[str, float], ...] = (("", 0.0),)
_LYING: tuple[tuple[str, float], ...] = (("thumb up", 0.5 * math.pi), ("thumb down", -0.5 * math.pi))
"""How a hand is rolled that holds an upright bar, or one that lies."""
_FLOATED = 0.8
"""Of a door's angle: so far the hand has turned about the bar when it has followed the door there."""
_TOLERANCE = IkTolerance(com_margin_m=0.05)
_BEFORE_FRONT_M = 0.004
"""Fingertips stay so far before the front on which the bar is."""
_ON_PADS_M = 0.008
"""So much of the pads reaches beyond a bar's middle in any case."""
_WIDER_M = 0.05
"""No wider than so much more than the bar: letting go, fingers open among what has moved by then."""
_DEEPER = 0.4
"""Of a short pad's half-length: so much deeper a bar is held that goes away when it is squeezed."""
_TILTED = 0.1
_ABOUT_BAR_M = 0.006
"""Fingers are so far from a bar before they close: what it is misjudged by."""
_LED_IN = 6
"""Poses on the way of a palm that has to be turned to a bar."""


class HandlePlanner:
    """Answers handle requests for one robot."""

    def __init__(self, model: RobotModel) -> None:
        self._model = model

    def plan(self, request: HandleRequest) -> HandlePlan | NoPlan:
        """Plan reach and approach, or say honestly why there is no plan.

        A bar that is out of sight is kept clear of where one would be; where that leaves no way, what is
        seen alone counts, and the hand will feel what it meets.
        """
        for bar in assumed_bars(request):
            scene, parts = request.scene.with_object(bar), (*request.parts, bar.name)
            careful = _HandleTask(self._model, dataclasses.replace(request, scene=scene, parts=parts))
            if careful.starts_free:
                plan = self._first(careful)
                if isinstance(plan, HandlePlan):
                    return plan
                break
        return self._first(_HandleTask(self._model, request))

    def _first(self, task: _HandleTask) -> HandlePlan | NoPlan:
        """The plan for the first grasp that has one."""
        for grasp in task.grasps():
            if (plan := task.planned(grasp)) is not None:
                return plan
        farthest = task.farthest_s
        numbers = {"grasps_considered": float(task.considered)}
        if farthest is not None:
            numbers["reached"] = farthest
            numbers["wanted"] = task.request.s_to
        return NoPlan(
            f"no way to move the {task.request.handle} from here was found",
            dict(task.reasons),
            numbers,
            WhyNoPlan.NO_GRASP,
        )


class _HandleTask(PlanningTask):
    """One handle to be taken hold of: its candidates are grasps."""

    def __init__(self, model: RobotModel, request: HandleRequest) -> None:
        super().__init__(model, request, PLANNING_RESERVE_M, HANDED_ON_RESERVE_M, start_reserve_m=0.0)
        self.request = request
        self.farthest_s: float | None = None

    @property
    def starts_free(self) -> bool:
        """Whether the robot is inside nothing where it stands."""
        return self.planner.is_free(self.x_start)

    def grasps(self) -> Iterator[Grasp]:
        """Candidates, the most promising first."""
        request = self.request
        if request.pushed:
            yield from push_grasps(self._model, request)
            return
        point, bar = request.path.at(request.s_from), request.scene.objects[request.handle]
        heading = math.atan2(-point.outward[1], -point.outward[0])
        shape = bar.shape
        diameter = 2.0 * shape.radius_m if isinstance(shape, Cylinder) else 0.02
        place = bar.world_T_object[:3, 3]
        for hand in request.hands:
            gripper = self._model.description.grippers[hand]
            from_above = self._spares(hand) and not isinstance(request.path, DoorArc)
            for tilt in _TILTS_RAD if from_above else _TILTS_RAD[:1]:
                for turn in gripper.bar.turns_rad:
                    yield from self._turned(hand, turn, tilt, heading, place, diameter)

    def _turned(
        self, hand: Hand, turn: float, tilt: float, heading: float, place: Array, diameter: float
    ) -> Iterator[Grasp]:
        path, s = self.request.path, self.request.s_from
        gripper = self._model.description.grippers[hand]
        aside = turn if hand == "right" else -turn
        yaw, about, rolls = heading, -gripper.bar.approach_rad, _LYING
        if isinstance(path, DoorArc):
            yaw, rolls = heading + path.side * (_FLOATED * s - turn), _UPRIGHT
        elif gripper.palm_side_m is None:
            yaw = heading + aside
        else:  # a palm lies along the whole bar: it turns about that
            about += aside
        short_m = max(min(SHORT_M, gripper.closing_advance_m), self._kept_off_m(hand, place))
        bar = np.array([gripper.bar.along_m, gripper.grasped_at_m(diameter), 0.0])
        deeper, deeper_m = self._depth(hand)
        for name, roll in rolls:
            lowered = poses.rotation_z(yaw) @ poses.rotation_y(tilt)
            rotation = lowered @ poses.rotation_x(roll) @ poses.rotation_z(about)
            above = f" {math.degrees(tilt):.0f} down" if tilt else ""
            label = f"bar {math.degrees(turn):+.0f}{above}{' ' + name if name else ''}{deeper}"
            if key_of(hand, label) in self.request.excluded:
                continue
            ahead = (deeper_m - short_m) * way_to_bar(gripper)
            pose = poses.transform(rotation, place + rotation @ (ahead - bar))
            yield Grasp(hand, label, pose, APPROACH_M, diameter)

    def _kept_off_m(self, hand: Hand, place: Array) -> float:
        """How far before the bar's middle pads have to stop that would else meet the front behind it."""
        request, gripper = self.request, self._model.description.grippers[hand]
        front = request.scene.objects.get(request.parts[0])
        if not request.beside or front is None or not isinstance(front.shape, Box):
            return 0.0
        pad_m = gripper.pad_half_size_m[0][2]
        off_m = abs(float((place - front.world_T_object[:3, 3]) @ front.world_T_object[:3, 0]))
        behind_m = off_m - 0.5 * front.shape.size_m[0]
        return min(pad_m + gripper.closing_advance_m + _BEFORE_FRONT_M - behind_m, pad_m - _ON_PADS_M)

    def _opening_m(self, grasp: Grasp) -> float | None:
        """How far pads open at a bar, for what is beside it; None where not even the bar would fit."""
        request, gripper = self.request, self._model.description.grippers[grasp.hand]
        objects, outward = request.scene.objects, request.path.at(request.s_from).outward
        around = [objects[name] for name in request.beside]
        if (front := objects.get(request.parts[0])) is not None:
            around = [item for item in around if stands_out(item, front, outward)]
            if abs(float(grasp.world_T_tcp[2, 0])) > _TILTED:  # one finger goes down between bar and front
                around.append(front)
        poses_m = [grasp.world_T_tcp]
        if not isinstance(request.path, DoorArc):  # it lets go, or begins, where the drawer is shut
            shut = grasp.world_T_tcp.copy()
            shut[:3, 3] += request.path.at(0.0).position_m - request.path.at(request.s_from).position_m
            poses_m.append(shut)
        least_m = grasp.diameter_m + 2.0 * _ABOUT_BAR_M
        found = [fitting_opening_m(gripper, pose, around, least_m) for pose in poses_m]
        fitting = [opening_m for opening_m in found if opening_m is not None]
        return min(*fitting, grasp.diameter_m + _WIDER_M) if len(fitting) == len(found) else None

    def _spares(self, hand: Hand) -> bool:
        """Whether a hand opens no wider than fits: pads do, fingers on a palm cannot."""
        palm = self._model.description.grippers[hand].palm_side_m
        return bool(self.request.beside) and palm is None

    def _near(self, hand: Hand) -> Iterator[tuple[str, str]]:
        """What a hand may touch: its links the bar and its front, its fingers what is beside as well."""
        gripper = self._model.description.grippers[hand]
        yield from ((link, part) for link in gripper.touch_links for part in self.request.parts)
        if self._spares(hand):
            yield from ((link, name) for link in gripper.finger_links for name in self.request.beside)

    def _depth(self, hand: Hand) -> tuple[str, float]:
        """How much deeper than it is seen the bar is looked for, in words and m: another way after each miss.

        Pads that are shorter than what a handle is misjudged by close beside it where they meet it once.
        """
        pad_m = self._model.description.grippers[hand].pad_half_size_m[0][2]
        if pad_m >= SEEN_WITHIN_M:
            return "", 0.0
        step_m = 2.0 * _OVERLAP * pad_m
        # what slides shut is squeezed out, and away, from before the middle of a pad
        first_m = _DEEPER * pad_m if self.request.beside and self.request.s_to < self.request.s_from else 0.0
        ways = (("", first_m), (" deeper", step_m), (" less deep", -step_m))
        missed = sum(key.startswith(f"{hand} ") for key in self.request.excluded)
        return ways[missed % len(ways)]

    def planned(self, grasp: Grasp) -> HandlePlan | None:
        """The whole plan for one grasp, or None with the reason counted."""
        return self.tried(grasp, self._plan)

    def _plan(self, grasp: Grasp) -> HandlePlan | str:
        request = self.request
        if self._spares(grasp.hand):
            opening_m = self._opening_m(grasp)
            if opening_m is None:
                return "no room for fingers beside the handle"
            grasp = dataclasses.replace(grasp, opening_m=opening_m)
        ik = self.ik_of(grasp.hand)
        found = self._at(grasp)
        if found is None:
            return "no inverse kinematics at the handle"
        scene = self._touching(grasp.hand)
        near = self.planner_in(scene)
        blocked = near.judge.not_free(self.space.from_q(found.q))
        if blocked is not None:
            return "collision at the handle" if blocked.pair is not None else f"at the handle {blocked}"
        back = along_line(ik, found.q, grasp.world_T_tcp, self._before(grasp), CARTESIAN_POINTS)
        if back is None:
            return "no straight approach"
        gaze = gaze_joints(self._model, back[-1], grasp.world_T_tcp[:3, 3])
        approach = PolynomialCurve(self.looking(self.rows(back[::-1]), gaze))
        x_pregrasp, x_grasp = approach(np.array([0.0, 1.0]))
        if not self.planner.is_free(x_pregrasp) or not near.curve_is_free(approach):
            return "approach collides"
        q_grasp = self.space.to_q(x_grasp[None, :])[0][0]
        lead_to = shut_at(self._model, request, grasp) if request.pushed else request.s_to
        rehearsal = rehearse(
            self.robot, grasp.hand, q_grasp, scene, request.parts, request.path,
            request.s_from, lead_to, not request.pushed,
        )  # fmt: skip
        if rehearsal.reason:
            best = self.farthest_s
            farther = best is None or abs(rehearsal.farthest_s - request.s_from) > abs(best - request.s_from)
            self.farthest_s = rehearsal.farthest_s if farther else best
            return rehearsal.reason
        return self._timed(grasp, x_pregrasp, approach, lead_to)

    def _at(self, grasp: Grasp) -> IkResult | None:
        """The robot with its hand at the handle; None where no way to hold it there was found.

        A palm has to be turned to a bar: where the search does not find that at once, it is led there from
        the posture in which the robot stands.
        """
        request, ik = self.request, self.ik_of(grasp.hand)
        found = ik.solve(grasp.world_T_tcp, request.q_start)
        gripper = self._model.description.grippers[grasp.hand]
        if not found.within(_TOLERANCE) and gripper.bar.approach_rad != 0.0:
            q = request.q_start
            here = self._model.frame_pose(q, gripper.tcp_frame)
            for pose in poses.line(here, grasp.world_T_tcp, _LED_IN):
                found = ik.solve(pose, q)
                q = found.q
        return found if found.within(_TOLERANCE) else None

    def _before(self, grasp: Grasp) -> Array:
        """Pose of the TCP from which the hand goes straight to a grasp, shape (4, 4)."""
        if not self.request.pushed:
            back = -grasp.approach_m * way_to_bar(self._model.description.grippers[grasp.hand])
            return np.asarray(grasp.world_T_tcp @ poses.transform(np.eye(3), back))
        before = grasp.world_T_tcp.copy()
        before[:3, 3] += grasp.approach_m * outward_of(self.request)
        return before

    def _timed(self, grasp: Grasp, x_pregrasp: Array, approach: Curve, lead_to: float) -> HandlePlan | str:
        arms = self._model.description.arms
        reach = self.path(x_pregrasp, arms, np.random.default_rng(self.request.seed))
        if reach is None:
            return "no path to the handle"
        held = ConcessionReason.HANDLE_IN_HAND
        in_hand = tuple(Concession(frozenset(pair), held, "approach") for pair in self._near(grasp.hand))
        first = self.first_step("reach", reach, _REACH_PACE)
        second = self.step("approach", approach, CARTESIAN_PACE, in_hand)
        if first is None or second is None:
            return "legs cannot follow"
        return HandlePlan(grasp, first, second, lead_to, self.considered)

    def _touching(self, hand: Hand) -> PlanningScene:
        """The scene in which this hand may touch the handle and what it is on."""
        return self.request.scene.allowing(self._near(hand))
