"""Whether the kernel can be used at once, and what makes it so; see also ``kinematics.warming``."""

from __future__ import annotations

import functools
from collections.abc import Callable

import coal
import numpy as np
import pinocchio as pin

from kinematics import poses
from kinematics.kernel import cache
from kinematics.scene import PlanningScene, SceneObject
from kinematics.shapes import Ball


def ready() -> bool:
    """Tell whether all compiled code of the present sources is on disk for this processor.

    Looks at each file's end, not at what is in it; ``cache.damaged`` does.
    Who plans goes on with Coal when it is not: nobody waits for a compiler unasked.
    """
    return cache.is_complete()


@functools.cache
def usable() -> bool:
    """``ready``, asked once: one run has one judge."""
    return ready()


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
