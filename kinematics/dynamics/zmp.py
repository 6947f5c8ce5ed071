"""Where the ground would have to push: the zero-moment point along a motion of a standing robot.

From the wrench that the base would need if nothing else carried it, Pinocchio's inverse dynamics; Kajita
et al., "Introduction to Humanoid Robotics", Springer 2014, section 3.3.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import pinocchio as pin

from kinematics.arrays import Array, as_float64
from kinematics.compiled import readiness
from kinematics.model.robot_build import model_tree, planning_memory
from kinematics.model.robot_model import RobotModel
from kinematics.model.standing_robot import StandingRobot
from kinematics.motion.sampler import MotionSample, cross, rotate

if TYPE_CHECKING:
    from kinematics.model.tree import Tree


def zmp_margins_m(robot: StandingRobot, motion: MotionSample) -> Array:
    """Distance of the ZMP to the edge of the support polygon, positive inside.

    Args:
        robot: Where it stands.
        motion: Instants of a motion, arrays with k rows.

    Returns:
        Margins, shape (k,), m; infinite for a welded robot.
    """
    model, data = robot.model, planning_memory(robot.model)
    q, v, a = motion.q, motion.v, motion.a
    wrench = np.array([pin.rnea(model.pin, data, q[k], v[k], a[k])[:6] for k in range(len(q))])
    force, moment = rotate(q[:, 3:7], wrench[:, :3]), rotate(q[:, 3:7], wrench[:, 3:])
    moment += cross(q[:, :3], force)
    return robot.polygon.margins_m(_zmp(force, moment, robot.stance.height_m))


def balance_margins_m(robot: StandingRobot, motion: MotionSample) -> tuple[Array, Array]:
    """Distances of ZMP and CoM to the edge of the support polygon, positive inside.

    Args:
        robot: Where it stands.
        motion: Instants of a motion, arrays with k rows.

    Returns:
        Margins of the ZMP and of the CoM's ground projection, shape (k,) each, m; infinite for a
        welded robot.
    """
    model, polygon = robot.model, robot.polygon
    if model.description.welded or not readiness.usable():
        com = np.array([pin.centerOfMass(model.pin, planning_memory(model), q)[:2] for q in motion.q])
        return zmp_margins_m(robot, motion), polygon.margins_m(com)
    force, moment, com = compiled_loads(model, motion)
    return polygon.margins_m(_zmp(force, moment, robot.stance.height_m)), polygon.margins_m(com[:, :2])


def compiled_loads(model: RobotModel, motion: MotionSample) -> tuple[Array, Array, Array]:
    """Force and moment of the ground about the world's origin, and the CoM, shape (k, 3) each.

    Args:
        model: A robot whose base floats.
        motion: Instants of a motion, arrays with k rows.
    """
    # imported here: it brings the compiler
    from kinematics.dynamics.ground_loads import ground_loads

    force, moment, com = (np.empty((len(motion.q), 3)) for _ in range(3))
    n = len(motion.q)
    ground_loads(
        *model.derived(_masses),
        as_float64(motion.q, (n, model.nq), "q"),
        as_float64(motion.v, (n, model.nv), "v"),
        as_float64(motion.a, (n, model.nv), "a"),
        force,
        moment,
        com,
    )
    return force, moment, com


def _masses(model: RobotModel) -> tuple[Tree, Array]:
    """The robot's tree, and the inertia of each body about its centre of mass, shape (bodies, 3, 3)."""
    return model_tree(model), np.array([np.array(inertia.inertia) for inertia in model.pin.inertias])


def _zmp(force: Array, moment: Array, height_m: float) -> Array:
    """Where on a level plane a wrench about the world's origin acts, shape (k, 2)."""
    up = np.maximum(force[:, 2], 1e-6)
    x, y = height_m * force[:, 0] - moment[:, 1], height_m * force[:, 1] + moment[:, 0]
    return np.column_stack([x / up, y / up])
