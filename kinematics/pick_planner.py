"""Plan a pick: choose hand and grasp, then reach, approach and lift as one chain of motions.

It is the goals that fail, not the passages (field notes), so many grasps are filtered cheaply (does
the open hand alone fit there?), then tried with whole-body inverse kinematics, best first.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kinematics import poses
from kinematics.collision import CollisionWorld, HandCollision
from kinematics.curves import Curve, PolynomialCurve
from kinematics.free_coordinates import FreeCoordinates
from kinematics.gaze import gaze_joints
from kinematics.grasping import GraspCandidate, grasp_candidates, key_of
from kinematics.ik import IkTolerance, WholeBodyIk
from kinematics.path_planner import PathPlanner
from kinematics.poses import Transform
from kinematics.requests import Grasp, NoPlan, PickPlan, PickRequest, PlannedStep
from kinematics.robot_description import Hand
from kinematics.robot_model import RobotModel
from kinematics.scene import PlanningScene, SceneObject
from kinematics.timing import Pace, time_curve

Array = NDArray[np.float64]

# Kept in reserve against the checker, which judges with the scene's own margins.
PLANNING_RESERVE_M = 0.004
SELF_MARGIN_M = 0.005
# Straight approach: long enough that open fingers clear the object before it begins.
APPROACH_M = 0.10
SHORT_APPROACH_M = 0.075
# Points of the straight approach and lift that are solved; a cubic runs through them.
CARTESIAN_POINTS = 4
REACH_PACE = Pace(velocity=0.5, acceleration=0.7)
CARTESIAN_PACE = Pace(velocity=0.2, acceleration=0.5)
# An arm reaches no farther than this from its shoulder to the TCP, trunk leaning included.
FARTHEST_M = 1.15


@dataclass(frozen=True, slots=True)
class _Goal:
    """A grasp with the configurations that carry it out."""

    grasp: Grasp
    approach: Array
    lift: Array


class PickPlanner:
    """Answers pick requests for one robot."""

    def __init__(self, model: RobotModel) -> None:
        self._model = model

    def plan(self, request: PickRequest) -> PickPlan | NoPlan:
        """Plan reach, approach and lift, or say honestly why there is no plan."""
        target = request.scene.objects[request.target]
        task = _PickTask(self._model, request, target)
        reasons: Counter[str] = Counter()
        candidates = task.candidates(reasons)
        for considered, candidate in enumerate(candidates, start=1):
            goal = task.solve(candidate.grasp, reasons)
            if goal is None:
                continue
            plan = task.connect(goal, considered, reasons)
            if plan is not None:
                return plan
        hands = " or ".join(request.hands)
        return NoPlan(
            f"no way to grasp the {request.target} with the {hands} hand was found",
            dict(reasons),
            {"grasps_considered": float(sum(reasons.values()))},
        )


class _PickTask:
    """The state of one planning problem."""

    def __init__(self, model: RobotModel, request: PickRequest, target: SceneObject) -> None:
        self._model, self._request, self._target = model, request, target
        self._space = FreeCoordinates(model, request.stance)
        self._rng = np.random.default_rng(request.seed)
        self._ik: dict[Hand, WholeBodyIk] = {}
        self._reach_scene = request.scene
        self._reach_world = CollisionWorld(model, request.scene, PLANNING_RESERVE_M, SELF_MARGIN_M)
        self._grasp_worlds: dict[Hand, tuple[PlanningScene, CollisionWorld]] = {}
        self._x_start = self._space.from_q(request.q_start)
        # the search starts at home, which keeps elbows where they belong
        self._seed = model.home_over(request.stance)

    def candidates(self, reasons: Counter[str]) -> list[GraspCandidate]:
        """Grasps of all allowed hands that the open hand alone could reach, best first."""
        found = []
        for hand in self._request.hands:
            model, gripper = self._model, self._model.description.grippers[hand]
            shoulder = self._shoulder(hand)
            offset = self._target.world_T_object[:3, 3] - shoulder
            natural = float(np.arctan2(offset[1], offset[0]))
            distance = float(np.linalg.norm(offset[:2]))
            if distance > FARTHEST_M:
                reasons["out of reach"] += 1
                continue
            fits = HandCollision(model, hand, self._request.scene, self._target.name, PLANNING_RESERVE_M)
            for candidate in grasp_candidates(self._target, gripper, natural, APPROACH_M):
                if key_of(hand, candidate.grasp.label) in self._request.excluded:
                    reasons["tried before"] += 1
                elif fits.collides(candidate.grasp.world_T_tcp):
                    reasons["hand collides at the grasp"] += 1
                else:
                    found.append(GraspCandidate(candidate.grasp, candidate.cost + 2.0 * distance))
        return sorted(found, key=lambda candidate: candidate.cost)

    def solve(self, grasp: Grasp, reasons: Counter[str]) -> _Goal | None:
        """Find configurations for approach and lift of a grasp."""
        ik = self._ik_of(grasp.hand)
        pregrasp = grasp.world_T_tcp @ poses.translation(-grasp.approach_m, 0.0, 0.0)
        _, world = self._grasp_world(grasp.hand)
        first = ik.solve(grasp.world_T_tcp, self._seed, IkTolerance())
        if not first.within(IkTolerance()):
            reasons["no inverse kinematics at the grasp"] += 1
            return None
        if world.collides(first.q):
            reasons["collision at the grasp"] += 1
            return None
        approach = self._straight(ik, first.q, grasp.world_T_tcp, pregrasp)
        if approach is None:
            reasons["no straight approach"] += 1
            return None
        approach = approach[::-1]
        if self._reach_world.collides(approach[0]):
            reasons["collision before the approach"] += 1
            return None
        lifted = poses.translation(0.0, 0.0, self._request.lift_m) @ grasp.world_T_tcp
        lift = self._straight(ik, first.q, grasp.world_T_tcp, lifted)
        if lift is None:
            reasons["no straight lift"] += 1
            return None
        return _Goal(grasp, approach, lift)

    def connect(self, goal: _Goal, considered: int, reasons: Counter[str]) -> PickPlan | None:
        """Plan the reach and time all three motions."""
        request, model, space = self._request, self._model, self._space
        scene, world = self._grasp_world(goal.grasp.hand)
        gaze = gaze_joints(model, goal.approach[0], self._target.world_T_object[:3, 3])
        approach = np.array([space.from_q(q) for q in goal.approach])
        lift = np.array([space.from_q(q) for q in goal.lift])
        for joint, angle in gaze.items():
            approach[:, space.index(joint)] = angle
            lift[:, space.index(joint)] = angle
        approach_curve, lift_curve = PolynomialCurve(approach), PolynomialCurve(lift)
        lift_scene = self._lift_scene(goal.grasp, scene)
        near = PathPlanner(model, space, request.stance, world)
        if not near.curve_is_free(approach_curve):
            reasons["approach collides"] += 1
            return None
        lift_world = CollisionWorld(model, lift_scene, 0.0, SELF_MARGIN_M)
        if not PathPlanner(model, space, request.stance, lift_world).curve_is_free(lift_curve):
            reasons["lift collides"] += 1
            return None
        moving = [space.index(joint) for joint in model.description.groups[f"{goal.grasp.hand}_arm"]]
        moving += [space.index(joint) for joint in model.description.groups["torso"]]
        planner = PathPlanner(model, space, request.stance, self._reach_world)
        reach_curve = planner.plan(self._x_start, approach[0], moving, self._rng)
        if reach_curve is None:
            reasons["no path to the pre-grasp"] += 1
            return None
        reach = self._timed("reach", reach_curve, REACH_PACE, self._reach_scene)
        straight = self._timed("approach", approach_curve, CARTESIAN_PACE, scene)
        up = self._timed("lift", lift_curve, CARTESIAN_PACE, lift_scene)
        if reach is None or straight is None or up is None:
            reasons["legs cannot follow"] += 1
            return None
        return PickPlan(goal.grasp, reach, straight, up, considered)

    def _timed(self, name: str, curve: Curve, pace: Pace, scene: PlanningScene) -> PlannedStep | None:
        trajectory = time_curve(self._model, self._space, self._request.stance, curve, pace)
        return None if trajectory is None else PlannedStep(name, trajectory, scene)

    def _straight(self, ik: WholeBodyIk, q: Array, start: Transform, end: Transform) -> Array | None:
        """Configurations along a straight line of the TCP, the first one given, or None."""
        found = [q]
        for fraction in np.linspace(0.0, 1.0, CARTESIAN_POINTS)[1:]:
            result = ik.solve(poses.interpolate(start, end, float(fraction)), found[-1], IkTolerance())
            if not result.within(IkTolerance()):
                return None
            found.append(result.q)
        return np.array(found)

    def _grasp_world(self, hand: Hand) -> tuple[PlanningScene, CollisionWorld]:
        """Scene and world in which this hand may touch the target."""
        if hand not in self._grasp_worlds:
            links = self._model.description.grippers[hand].touch_links
            scene = self._request.scene.allowing((link, self._target.name) for link in links)
            world = CollisionWorld(self._model, scene, PLANNING_RESERVE_M, SELF_MARGIN_M)
            self._grasp_worlds[hand] = scene, world
        return self._grasp_worlds[hand]

    def _lift_scene(self, grasp: Grasp, scene: PlanningScene) -> PlanningScene:
        """The scene with the target in the hand; what it stands on may still touch it."""
        gripper = self._model.description.grippers[grasp.hand]
        tcp_T_object = poses.inverse(grasp.world_T_tcp) @ self._target.world_T_object
        held = scene.with_attached(self._target.name, gripper.tcp_frame, tcp_T_object, gripper.touch_links)
        return held.allowing((self._target.name, name) for name in supports_of(self._target, scene))

    def _ik_of(self, hand: Hand) -> WholeBodyIk:
        if hand not in self._ik:
            self._ik[hand] = WholeBodyIk(self._model, self._request.stance, hand)
        return self._ik[hand]

    def _shoulder(self, hand: Hand) -> Array:
        joint = self._model.pin.getJointId(self._model.description.groups[f"{hand}_arm"][1])
        name = next(f.name for f in self._model.pin.frames if f.parentJoint == joint)
        return self._model.frame_pose(self._request.q_start, name)[:3, 3]


def supports_of(target: SceneObject, scene: PlanningScene, reach_m: float = 0.03) -> list[str]:
    """Furniture right under an object: what it may touch when it is lifted off."""
    bottom = target.world_T_object[2, 3] - 0.5 * target.shape.height_m
    names = []
    for item in scene.objects.values():
        if item.movable or item.name == target.name:
            continue
        local = poses.inverse(item.world_T_object) @ np.append(target.world_T_object[:3, 3], 1.0)
        half = 0.5 * np.array(getattr(item.shape, "size_m", (0.0, 0.0, 0.0)))
        top = item.world_T_object[2, 3] + 0.5 * item.shape.height_m
        if np.all(np.abs(local[:2]) <= half[:2] + 0.02) and abs(bottom - top) <= reach_m:
            names.append(item.name)
    return names
