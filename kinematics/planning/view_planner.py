"""Plan a look past what hides something: pelvis, trunk and head take the eyes to where more is seen.

As with grasps, goals are what fails: postures are tried by how much of what was not seen yet they show,
the most telling first, until one is free and can be reached. (A next best view, by sampling.)
"""

from __future__ import annotations

import itertools
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array
from kinematics.geometry import poses
from kinematics.ik.arm_frames import elbow_frame
from kinematics.ik.gaze import gaze_joints, in_picture
from kinematics.model.robot_model import RobotModel
from kinematics.model.standing_robot import StandingRobot
from kinematics.planning.planning_task import REACH_PACE, PlanningTask
from kinematics.requests.move import MovePlan
from kinematics.requests.step import NoPlan
from kinematics.requests.view import ViewRequest
from kinematics.scene.line_of_sight import hidden, near_line
from kinematics.standing.free_coordinates import free_coordinates
from kinematics.standing.reserves import MOVING_RESERVE_M as RESERVE_M

# Of the pelvis from where it is at home: ahead, to the left, up.
SHIFTS_M = (
    (0.0, 0.0, 0.0),
    (-0.03, 0.08, 0.04),
    (-0.03, -0.08, 0.04),
    (0.0, 0.0, 0.04),
    (-0.03, 0.0, -0.08),
)
LEANS_RAD = (0.0, 0.35, 0.7)
TURNS_RAD = (0.0, 0.4, -0.4, 0.8, -0.8, 1.15, -1.15)
# Aims: where most of what was not seen is near together.
MOST_AIMS = 3
TOGETHER_M = 0.12
# A view that shows less than this of all, by worth, is not worth going there.
LEAST_SHARE = 0.02
# So many postures are judged, and so many of the free ones are planned to.
MOST_JUDGED, MOST_PLANNED = 40, 3
# Postures in which the head is aimed.
MOST_AIMED = 24


@dataclass(frozen=True, slots=True)
class _View:
    x: Array
    share: float


class ViewPlanner:
    """Answers view requests for one robot."""

    def __init__(self, model: RobotModel) -> None:
        self._model = model

    def plan(self, request: ViewRequest) -> MovePlan | NoPlan:
        """Plan to the posture that shows most, or say why none does."""
        task = PlanningTask(self._model, request, RESERVE_M, RESERVE_M)
        views = self._views(task.robot, request)
        if not views:
            return NoPlan("no posture shows what was not seen yet", {"hidden from everywhere": 1})
        rng = np.random.default_rng(request.seed)
        free = (view for view in views[:MOST_JUDGED] if task.planner.is_free(view.x))
        for view in itertools.islice(free, MOST_PLANNED):
            curve = task.path(view.x, self._model.description.arms, rng)
            if curve is None:
                task.reasons["no path"] += 1
                continue
            step = task.first_step("peer", curve, REACH_PACE)
            if step is None:
                task.reasons["legs cannot follow"] += 1
                continue
            return MovePlan(step)
        return NoPlan(
            "no posture that shows what was not seen yet can be taken",
            dict(task.reasons) or {"collision or lost balance": min(len(views), MOST_JUDGED)},
            {"views": float(len(views))},
        )

    def _views(self, robot: StandingRobot, request: ViewRequest) -> list[_View]:
        """Postures that show something, the most telling first."""
        model, space = self._model, free_coordinates(robot)
        camera = model.description.camera
        torso = model.description.groups["torso"]
        turning = next((joint for joint in torso if joint != camera.lean_joint), None)
        home = robot.q_home
        arms = 7 + np.concatenate([model.group(f"{hand}_arm") for hand in model.description.arms])
        home[arms] = request.q_start[arms]
        x_home = space.from_q(home)
        yaw = poses.rotation_z(poses.yaw_of(poses.rotation_from_quaternion(home[3:7])))
        leans = LEANS_RAD if camera.lean_joint is not None else (0.0,)
        turns = TURNS_RAD if turning is not None else (0.0,)
        shifts = SHIFTS_M if space.base_size else SHIFTS_M[:1]
        aims = _aims(request.points_m, request.worth)
        postures = []
        for shift, lean, turn in itertools.product(shifts, leans, turns):
            x = x_home.copy()
            if space.base_size:
                x[:3] += yaw @ shift
            for joint, angle in ((camera.lean_joint, lean), (turning, turn)):
                if joint is not None:
                    x[space.index(joint)] = self._inside(joint, angle)
            postures.append(x)
        found, reached = space.to_q(np.array(postures))
        candidates: list[tuple[float, Array, Array]] = []
        for x, q, feet_reach in zip(postures, found, reached, strict=True):
            if feet_reach:
                eye = model.frame_pose(q, camera.frame)[:3, 3]
                blocked = hidden(eye, request.points_m, request.scene.objects.values())
                candidates.append((float(request.worth[~blocked].sum()), x, q))
        # turning the head hardly moves the eyes: only where most is open to them is it aimed
        candidates.sort(key=lambda one: -one[0])
        views: list[_View] = []
        for open_worth, x, q in candidates[:MOST_AIMED]:
            if open_worth <= 0.0:
                break
            for aim in aims:
                looking, x_looking = q.copy(), x.copy()
                for joint, angle in gaze_joints(model, looking, aim).items():
                    looking[7 + model.joint_index(joint)] = angle
                    x_looking[space.index(joint)] = angle
                share = self._shown(request, looking)
                if share >= LEAST_SHARE:
                    views.append(_View(x_looking, share))
        # of views that show nearly the same, that which is nearer to home
        views.sort(key=lambda view: -round(view.share, 2) + 1e-3 * space.distance(view.x, x_home))
        return views

    def _shown(self, request: ViewRequest, q: Array) -> float:
        """Share of the points' worth that is in view and not hidden."""
        model, points = self._model, request.points_m
        camera = model.description.camera
        names = [camera.frame]
        for hand in model.description.hands:
            names += [elbow_frame(model, hand), model.description.tcp_frames[hand]]
        world_T_camera, *parts = model.frame_poses(q, names)
        eye = world_T_camera[:3, 3]
        seen = in_picture(points, world_T_camera, camera.horizontal_fov_rad, camera.vertical_fov_rad)
        shown = np.flatnonzero(seen)
        if len(shown) == 0:
            return 0.0
        blocked = hidden(eye, points[shown], request.scene.objects.values())
        left = shown[~blocked]
        ends = np.array([part[:3, 3] for part in parts])
        ends = np.concatenate([ends, 0.5 * (ends[0::2] + ends[1::2])])
        left = left[~near_line(eye, points[left], ends, request.clear_m)]
        return float(request.worth[left].sum() / request.worth.sum())

    def _inside(self, joint: str, angle: float) -> float:
        index, margin = self._model.joint_index(joint), self._model.description.planning_margin_rad
        low, high = self._model.lower_rad[index] + margin, self._model.upper_rad[index] - margin
        return float(np.clip(angle, low, high))


def _aims(points: Array, worth: Array) -> list[Array]:
    """Where most of it is near together, the densest first."""
    left = np.ones(len(points), dtype=bool)
    aims: list[Array] = []
    while left.any() and len(aims) < MOST_AIMS:
        open_points, open_worth = points[left], worth[left]
        worth_around = [float((open_worth * _near(open_points, one)).sum()) for one in open_points]
        near = _near(open_points, open_points[int(np.argmax(worth_around))])
        aims.append(np.average(open_points[near], axis=0, weights=open_worth[near]))
        left[np.flatnonzero(left)[near]] = False
    return aims


def _near(points: Array, one: Array) -> NDArray[np.bool_]:
    """Which points are near to one of them."""
    return np.asarray(np.linalg.norm(points - one, axis=1) <= TOGETHER_M)
