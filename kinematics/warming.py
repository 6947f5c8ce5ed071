"""Compile everything that plans and checks, before anybody waits for it."""

from __future__ import annotations

from collections.abc import Callable

import coal
import numpy as np
import pinocchio as pin

from kinematics.compiled import cache
from kinematics.geometry import poses
from kinematics.geometry.shapes import Ball
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import stance_at
from kinematics.model.standing_robot import StandingRobot
from kinematics.scene.planning_scene import PlanningScene, SceneObject


def compile_judge(tell: Callable[[str], None] = lambda _: None) -> None:
    """Compile the collision judge and the path search when they are not on disk yet; a minute or two.

    Args:
        tell: Is told what is being done.
    """
    # imported here: they bring the compiler
    tell("motion kernel: loading the compiler")
    from kinematics.kernel.collision_kernel import CollisionKernel
    from kinematics.kernel.robot_arrays import RobotArrays

    tell("motion kernel: compiling hulls (part 1 of 3)")
    model = pin.Model()
    base = model.addJoint(0, pin.JointModelFreeFlyer(), pin.SE3.Identity(), "base")
    model.addJoint(base, pin.JointModelRX(), pin.SE3.Identity(), "hinge")
    geometry = pin.GeometryModel()
    for k in range(2):
        place = pin.SE3(np.eye(3), np.array([0.5 * k, 0.0, 0.0]))
        geometry.addGeometryObject(pin.GeometryObject(f"part_{k}", base, place, _hull()))
    geometry.addCollisionPair(pin.CollisionPair(0, 1))
    robot = RobotArrays(model, geometry, ["part_0", "part_1"])
    tell("motion kernel: compiling the judge (part 2 of 3)")
    ball = SceneObject("ball", Ball(0.1), poses.translation(2.0, 0.0, 0.0))
    kernel = CollisionKernel(robot, PlanningScene().with_object(ball))
    kernel.collides(np.array([0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0]))


def _hull() -> coal.ConvexBase:
    points = coal.StdVec_Vec3s()
    for corner in np.ndindex(2, 2, 2):
        points.append(0.1 * np.array(corner, np.float64))
    return coal.ConvexBase.convexHull(points, True, "Qt")


def warm(model: RobotModel, tell: Callable[[str], None] = lambda _: None) -> None:
    """Compile all that is not on disk yet, and note that it is there; a minute or two when nothing is.

    Args:
        model: A robot that stands on legs with a closed form, whose use brings all of the code.
        tell: Is told what is being done.
    """
    compile_judge(tell)
    # imported here: they bring the compiler
    from kinematics.checking.trajectory_checker import TrajectoryChecker
    from kinematics.dynamics.zmp import compiled_loads
    from kinematics.ik.solver import along_line, inverse_kinematics
    from kinematics.motion.curves import PolynomialCurve
    from kinematics.motion.sampler import MotionSample
    from kinematics.standing.free_coordinates import free_coordinates
    from kinematics.standing.leg_newton import solve_poses
    from kinematics.timing.balanced_timing import time_in_balance
    from kinematics.timing.curve_timing import Pace

    tell("motion kernel: compiling reach, timing and checker (part 3 of 3)")
    robot = StandingRobot.of(model, stance_at(model, model.q_home))
    hand = next(iter(model.description.grippers))
    tcp = model.frame_pose(model.q_home, model.description.grippers[hand].tcp_frame)
    along_line(inverse_kinematics(robot, hand), model.q_home, tcp, tcp, 2)
    inverse_kinematics(robot, hand).solve(tcp, model.q_home)
    space = free_coordinates(robot)
    ends = space.from_q(model.q_home)[None].repeat(2, axis=0)
    ends[1, space.index(model.description.groups[f"{hand}_arm"][-1])] += 0.1
    ends[1, :1] += 0.001
    trajectory = time_in_balance(robot, PolynomialCurve(ends), Pace(0.5, 0.5))
    still, pose = np.zeros((3, 6, 4, 4)), np.eye(4)
    found = np.empty((1, 6)), np.empty(1, dtype=bool)
    solve_poses(np.zeros(6), still, np.zeros((6, 3)), pose, np.zeros((1, 3)), np.eye(3)[None], *found)
    rest = np.zeros((1, model.nv))
    compiled_loads(model, MotionSample(model.q_home[None], rest, rest))
    if trajectory is not None:
        TrajectoryChecker(model, compiled=True).check(trajectory, PlanningScene())
    cache.mark_complete()
