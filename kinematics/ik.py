"""Whole-body inverse kinematics: feet pinned, CoM inside the support polygon, one TCP at a pose.

PlaCo's task-based quadratic program does the search; the legs are then set exactly, and every residual
is measured again with Pinocchio. An answer is never returned unverified. A welded robot has neither feet
nor balance to keep; its base stays at its mount.
"""

from __future__ import annotations

import functools
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass

import numpy as np
import pinocchio as pin
import placo
from numpy.typing import NDArray

from kinematics import poses
from kinematics.errors import MissingPartError
from kinematics.leg_ik import LegIk
from kinematics.poses import Transform
from kinematics.robot_description import Hand
from kinematics.robot_model import RobotModel
from kinematics.stance import SupportPolygon
from kinematics.trajectory import Stance

Array = NDArray[np.float64]

# Weights of the tasks: a TCP weight of 1 never converges against the posture (field notes).
TCP_WEIGHTS = (100.0, 30.0)
COM_WEIGHT = 1.0
POSTURE_WEIGHT = 1e-3
TRUNK_WEIGHT = 0.05
REGULARISATION = 1e-5
STEP_S = 0.01


@dataclass(frozen=True, slots=True)
class IkTolerance:
    """Residuals that an answer may have."""

    position_m: float = 5e-4
    orientation_rad: float = 3e-3
    com_margin_m: float = 0.0


@dataclass(frozen=True, slots=True)
class IkResult:
    """One inverse-kinematics answer, with the evidence to judge it by.

    Attributes:
        q: Configuration, shape (nq,), Pinocchio order; the soles are at the stance exactly.
        position_error_m: Distance of the TCP from its target.
        orientation_error_rad: Angle between TCP and target.
        com_margin_m: Distance of the CoM's ground projection to the edge of the support polygon,
            positive inside; infinite when the base is welded.
        limits_kept: Whether every joint is inside its limits (shrunk for planning).
        feet_reached: Whether the legs can be placed.
        iterations: Steps of the solver.
    """

    q: Array
    position_error_m: float
    orientation_error_rad: float
    com_margin_m: float
    limits_kept: bool
    feet_reached: bool
    iterations: int

    def within(self, tolerance: IkTolerance) -> bool:
        """Tell whether every residual is inside ``tolerance``."""
        return (
            self.feet_reached
            and self.limits_kept
            and self.position_error_m <= tolerance.position_m
            and self.orientation_error_rad <= tolerance.orientation_rad
            and self.com_margin_m >= tolerance.com_margin_m
        )


class WholeBodyIk:
    """Inverse kinematics of one hand for one stance.

    Args:
        model: The robot.
        stance: Where the soles stand.
        hand: The hand whose TCP is placed.

    Raises:
        MissingPartError: The robot has no such hand.
    """

    def __init__(self, model: RobotModel, stance: Stance, hand: Hand) -> None:
        description = model.description
        self._model = model
        self._legs = LegIk(model, stance)
        self._polygon = SupportPolygon(stance, description.soles)
        if hand not in description.tcp_frames:
            raise MissingPartError(description.name, f"{hand} hand")
        self._frame = description.tcp_frames[hand]
        margin = description.planning_margin_rad
        self._lower, self._upper = model.lower_rad + margin, model.upper_rad - margin
        self._robot = placo.RobotWrapper(
            "", int(placo.Flags.ignore_collisions), _without_meshes(description.planning_urdf)
        )
        for name, lower, upper in zip(model.joints, self._lower, self._upper, strict=True):
            self._robot.set_joint_limits(name, float(lower), float(upper))
        self._solver = self._make_solver(stance)
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
        posture = solver.add_joints_task()
        posture.set_joints({name: model.description.home[name] for name in model.joints})
        posture.configure("posture", "soft", POSTURE_WEIGHT)
        if model.description.groups["torso"] and not model.description.welded:
            facing = poses.rotation_z(_heading(stance))
            solver.add_orientation_task(_trunk(model), facing).configure("trunk", "soft", TRUNK_WEIGHT)
        solver.add_regularization_task(REGULARISATION)
        return solver

    def _keep_standing(self, solver: placo.KinematicsSolver, stance: Stance) -> None:
        model = self._model
        for frame, world_T_sole in stance.soles:
            solver.add_frame_task(frame, world_T_sole).configure(frame, "hard")
        clockwise = [np.array(corner) for corner in self._polygon.vertices_m[::-1]]
        # a centimetre more than the limit, so that the checker's view never differs
        margin = model.description.com_margin_m + 0.01
        solver.add_com_polygon_constraint(clockwise, margin).configure("support polygon", "hard")
        com = model.com(model.q_home)
        middle = self._polygon.vertices_m.mean(axis=0)
        solver.add_com_task(np.array([middle[0], middle[1], com[2]])).configure("com", "soft", COM_WEIGHT)

    def solve(
        self,
        world_T_tcp: Transform,
        q_seed: Array,
        tolerance: IkTolerance = IkTolerance(),
        iterations: int = 60,
    ) -> IkResult:
        """Bring the TCP to a pose, starting from a configuration with the feet at the stance.

        A welded base must be at its mount in ``q_seed``.

        Args:
            world_T_tcp: Target, shape (4, 4).
            q_seed: Start, shape (nq,).
            tolerance: The search ends when the TCP is this near.
            iterations: Most steps of the solver.
        """
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
            error, turn = _errors(robot.get_T_world_frame(self._frame), world_T_tcp)
            if error <= 0.5 * tolerance.position_m and turn <= 0.5 * tolerance.orientation_rad:
                break
            # an unreachable target does not raise: give up when nothing moves any more
            if count % 10 == 0:
                if error + 0.1 * turn > 0.8 * last:
                    break
                last = error + 0.1 * turn
        return self._verified(np.array(robot.state.q), world_T_tcp, count)

    def along_line(self, q: Array, start: Transform, end: Transform, points: int) -> Array | None:
        """Configurations along a straight line of the TCP.

        Args:
            q: Configuration at the start of the line, shape (nq,); the first of the answer.
            start, end: Poses of the TCP, shape (4, 4).
            points: How many configurations, both ends included.

        Returns:
            Shape (points, nq), or None when one of them is not reached within the tolerance.
        """
        found = [q]
        for fraction in np.linspace(0.0, 1.0, points)[1:]:
            result = self.solve(poses.interpolate(start, end, float(fraction)), found[-1])
            if not result.within(IkTolerance()):
                return None
            found.append(result.q)
        return np.array(found)

    def _verified(self, q: Array, world_T_tcp: Transform, count: int) -> IkResult:
        q[3:7] /= np.linalg.norm(q[3:7])
        feet = bool(self._legs.fill(q[None, :])[0])
        error, turn = _errors(self._model.frame_pose(q, self._frame), world_T_tcp)
        joints = q[7:]
        return IkResult(
            q=q,
            position_error_m=error,
            orientation_error_rad=turn,
            com_margin_m=self._polygon.com_margin_m(self._model.com(q)),
            limits_kept=bool(np.all(joints >= self._lower - 1e-9) and np.all(joints <= self._upper + 1e-9)),
            feet_reached=feet,
            iterations=count,
        )


@functools.cache
def _without_meshes(urdf: str) -> str:
    """A URDF of bodies and joints alone: PlaCo loads every mesh otherwise, for 0.8 s."""
    root = ElementTree.fromstring(urdf)
    for link in root.findall("link"):
        for tag in ("visual", "collision"):
            for element in link.findall(tag):
                link.remove(element)
    return ElementTree.tostring(root, encoding="unicode")


def _trunk(model: RobotModel) -> str:
    """Link that the last joint of the torso moves."""
    joint = model.pin.getJointId(model.description.groups["torso"][-1])
    return next(
        str(frame.name) for frame in model.pin.frames if frame.parentJoint == joint and frame.type == pin.BODY
    )


def _errors(actual: Transform, wanted: Transform) -> tuple[float, float]:
    offset = actual[:3, 3] - wanted[:3, 3]
    trace = float(np.sum(actual[:3, :3] * wanted[:3, :3]))
    return float(np.sqrt(offset @ offset)), float(np.arccos(min(1.0, max(-1.0, (trace - 1.0) / 2.0))))


def _heading(stance: Stance) -> float:
    vectors = [world_T_sole[:2, 0] for _, world_T_sole in stance.soles]
    x, y = np.sum(vectors, axis=0)
    return float(np.arctan2(y, x))
