"""Whole-body inverse kinematics: feet pinned, CoM inside the support polygon, one TCP at a pose.

PlaCo's task-based quadratic program does the search; the legs are then set exactly, and every residual
is measured again with Pinocchio. An answer is never returned unverified. A welded robot has neither feet
nor balance to keep; its base stays at its mount.
"""

from __future__ import annotations

import functools
import math
import xml.etree.ElementTree as ElementTree

import numpy as np
import pinocchio as pin
import placo

from kinematics.arrays import Array, as_float64
from kinematics.errors import MissingPartError
from kinematics.geometry import poses
from kinematics.geometry.poses import Transform
from kinematics.ik.result import DEFAULT_TOLERANCE, IkResult, IkTolerance, errors_between
from kinematics.model.robot_description import Hand
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import Stance
from kinematics.model.standing_robot import StandingRobot
from kinematics.standing.leg_ik import LegIk
from kinematics.standing.reserves import SEARCH_COM_RESERVE_M


@functools.cache
def without_meshes(urdf: str) -> str:
    """Drop what is drawn and what collides: PlaCo loads every mesh otherwise, for 0.8 s."""
    root = ElementTree.fromstring(urdf)
    for link in root.findall("link"):
        for element in (*link.findall("visual"), *link.findall("collision")):
            link.remove(element)
    return ElementTree.tostring(root, encoding="unicode")


# Weights of the tasks: a TCP weight of 1 never converges against the posture (field notes).
TCP_WEIGHTS = (100.0, 30.0)
COM_WEIGHT = 1.0
POSTURE_WEIGHT = 1e-3
# Ten times as much of the trunk keeps it upright over a pelvis that leans by 29 degrees: G1 found a quarter
# of the level grasps over low tables. Without the pelvis's it leans by 20, with it by 5, and finds as many.
TRUNK_WEIGHT, PELVIS_WEIGHT = 0.005, 0.01
REGULARISATION = 1e-5
# Who reaches far is at the limits of the trunk, and curves through a few solved points swing beyond them.
SWING_RESERVE_RAD = 0.03
STEP_S = 0.01


class PlacoIk:
    """Inverse kinematics of one hand for one stance.

    Args:
        robot: Where it stands.
        hand: The hand whose TCP is placed.

    Raises:
        MissingPartError: The robot has no such hand.
    """

    def __init__(self, robot: StandingRobot, hand: Hand) -> None:
        model = robot.model
        description = model.description
        self._model = model
        self._legs, self._polygon = robot.derived(LegIk), robot.polygon
        if hand not in description.tcp_frames:
            raise MissingPartError(description.name, f"{hand} hand")
        self._frame = description.tcp_frames[hand]
        margin = description.planning_margin_rad
        self._least_upright = math.cos(description.lean_rad)
        reserve = 0.0 if description.welded else SWING_RESERVE_RAD
        self._lower, self._upper = model.lower_rad + margin, model.upper_rad - margin
        self._robot = placo.RobotWrapper(
            "", int(placo.Flags.ignore_collisions), without_meshes(description.planning_urdf)
        )
        for name, lower, upper in zip(model.joints, self._lower, self._upper, strict=True):
            self._robot.set_joint_limits(name, float(lower) + reserve, float(upper) - reserve)
        for name, (low, high) in self._legs.bent_knees().items():
            self._robot.set_joint_limits(name, low, high)
        self._solver = self._make_solver(robot.stance)
        self._tcp = self._solver.add_frame_task(self._frame, np.eye(4))
        self._tcp.configure(self._frame, "soft", *TCP_WEIGHTS)

    def _make_solver(self, stance: Stance) -> placo.KinematicsSolver:
        robot, model = self._robot, self._model
        robot.state.q = model.q_home
        robot.update_kinematics()
        solver = placo.KinematicsSolver(robot)
        solver.dt = STEP_S
        solver.enable_joint_limits(True)
        if model.description.welded:
            solver.mask_fbase(True)
        else:
            self._keep_standing(solver, stance)
        self._posture = solver.add_joints_task()
        self._posture.configure("posture", "soft", POSTURE_WEIGHT)
        if model.description.groups["torso"] and not model.description.welded:
            facing = poses.rotation_z(_heading(stance))
            solver.add_orientation_task(_trunk(model), facing).configure("trunk", "soft", TRUNK_WEIGHT)
            pelvis = model.description.base_link
            solver.add_orientation_task(pelvis, facing).configure("pelvis", "soft", PELVIS_WEIGHT)
        solver.add_regularization_task(REGULARISATION)
        return solver

    def _keep_standing(self, solver: placo.KinematicsSolver, stance: Stance) -> None:
        model = self._model
        for frame, world_T_sole in stance.soles:
            solver.add_frame_task(frame, world_T_sole).configure(frame, "hard")
        clockwise = [np.array(corner) for corner in self._polygon.vertices_m[::-1]]
        margin = model.description.com_margin_m + SEARCH_COM_RESERVE_M
        solver.add_com_polygon_constraint(clockwise, margin).configure("support polygon", "hard")
        com = model.com(model.q_home)
        middle = self._polygon.vertices_m.mean(axis=0)
        solver.add_com_task(np.array([middle[0], middle[1], com[2]])).configure("com", "soft", COM_WEIGHT)

    def solve(
        self,
        world_T_tcp: Transform,
        q_seed: Array,
        tolerance: IkTolerance = DEFAULT_TOLERANCE,
        iterations: int = 60,
        q_preferred: Array | None = None,
        upright: bool = False,  # noqa: ARG002
        lowest_m: float = -math.inf,  # noqa: ARG002
    ) -> IkResult:
        """Bring the TCP to a pose, starting from a configuration with the feet at the stance.

        A welded base must be at its mount in ``q_seed``.

        Args:
            world_T_tcp: Target, shape (4, 4).
            q_seed: Start, shape (nq,).
            tolerance: The search ends when the TCP is this near.
            iterations: Most steps of the solver.
            q_preferred: Posture to stay near where there is a choice; home when left out.
            upright: Makes no difference: this solver bends knees only where it must.
            lowest_m: Makes none either.

        Raises:
            InvalidArrayError: One has another shape, or holds no real numbers.
        """
        world_T_tcp = as_float64(world_T_tcp, (4, 4), "world_T_tcp")
        q_seed = as_float64(q_seed, (self._model.nq,), "q_seed")
        home = self._model.q_home
        if q_preferred is not None:
            home = as_float64(q_preferred, (self._model.nq,), "q_preferred")
        self._posture.set_joints(dict(zip(self._model.joints, home[7:].tolist(), strict=True)))
        robot = self._robot
        robot.state.q = q_seed
        robot.update_kinematics()
        self._tcp.T_world_frame = world_T_tcp
        count, last = 0, np.inf
        while count < iterations:
            count += 1
            try:
                self._solver.solve(True)
            except RuntimeError:  # PlaCo's "Infeasible QP": the state before it is judged below
                break
            robot.update_kinematics()
            error, turn = errors_between(robot.get_T_world_frame(self._frame), world_T_tcp)
            if error <= 0.5 * tolerance.position_m and turn <= 0.5 * tolerance.orientation_rad:
                break
            # an unreachable target does not raise: give up when nothing moves any more
            if count % 10 == 0:
                if error + 0.1 * turn > 0.8 * last:
                    break
                last = error + 0.1 * turn
        return self._verified(np.array(robot.state.q), world_T_tcp, count)

    def _verified(self, q: Array, world_T_tcp: Transform, count: int) -> IkResult:
        q[3:7] /= np.linalg.norm(q[3:7])
        feet = bool(self._legs.fill(q[None, :])[0])
        error, turn = errors_between(self._model.frame_pose(q, self._frame), world_T_tcp)
        joints = q[7:]
        upright = self._model.description.welded or bool(
            poses.rotation_from_quaternion(q[3:7])[2, 2] >= self._least_upright
        )
        return IkResult(
            q=q,
            position_error_m=error,
            orientation_error_rad=turn,
            com_margin_m=self._polygon.com_margin_m(self._model.com(q)),
            limits_kept=upright
            and bool(np.all(joints >= self._lower - 1e-9) and np.all(joints <= self._upper + 1e-9)),
            feet_reached=feet,
            iterations=count,
        )


def _trunk(model: RobotModel) -> str:
    """Link that the last joint of the torso moves."""
    joint = model.pin.getJointId(model.description.groups["torso"][-1])
    return next(
        str(frame.name) for frame in model.pin.frames if frame.parentJoint == joint and frame.type == pin.BODY
    )


def _heading(stance: Stance) -> float:
    vectors = [world_T_sole[:2, 0] for _, world_T_sole in stance.soles]
    x, y = np.sum(vectors, axis=0)
    return float(np.arctan2(y, x))
