"""Coordinates and limits of a robot's model, standing or welded, as the flat arrays of ``coordinates``."""

from __future__ import annotations

import numpy as np

from kinematics.model.robot_model import RobotModel
from kinematics.model.standing_robot import StandingRobot
from kinematics.model.tree import Tree
from kinematics.standing.flat_coordinates import Coordinates, Limits, joint_limits, plain_coordinates
from kinematics.standing.leg_ik import LegIk
from kinematics.standing.reserves import COM_RESERVE_M


def standing_coordinates(robot: StandingRobot) -> Coordinates:
    """The coordinates of ``FreeCoordinates``, column by column.

    Raises:
        ModelError: A leg has no closed form.
    """
    return robot.derived(_standing_coordinates)


def _standing_coordinates(robot: StandingRobot) -> Coordinates:
    legs = robot.derived(LegIk).geometry
    model = robot.model
    return Coordinates(
        floating=1,
        columns=(7 + model.indices(model.free_joints)).astype(np.int64),
        bodies=np.array([model.pin.getJointId(joint) for joint in model.free_joints], np.int64),
        leg_bodies=np.array([leg.joints for leg in legs], np.int64).reshape(-1, 6),
        hip=np.array([leg.hip_m for leg in legs]).reshape(-1, 3),
        bones=np.array([(leg.thigh_m, leg.shin_m) for leg in legs]).reshape(-1, 2),
        foot_R=np.array([leg.foot_R for leg in legs]).reshape(-1, 3, 3),
        ankle=np.array([leg.ankle_m for leg in legs]).reshape(-1, 3),
    )


def mounted_coordinates(model: RobotModel, tree: Tree) -> Coordinates:
    """The coordinates of a welded robot's ``FreeCoordinates``: its joints."""
    bodies = np.array([model.pin.getJointId(joint) for joint in model.joints], np.int64)
    return plain_coordinates(tree)._replace(floating=0, columns=tree.column[bodies], bodies=bodies)


def mounted_limits(model: RobotModel) -> Limits:
    """Joint limits shrunk for planning; a welded robot cannot lose its balance."""
    margin = model.description.planning_margin_rad
    return joint_limits(model.lower_rad + margin, model.upper_rad - margin, floating=True)


def standing_limits(robot: StandingRobot) -> Limits:
    """Joint limits shrunk for planning, and the CoM's margin with its reserve, as planners judge them."""
    return robot.derived(_standing_limits)


def _standing_limits(robot: StandingRobot) -> Limits:
    model, polygon = robot.model, robot.polygon.vertices_m
    margin = model.description.planning_margin_rad
    edges = np.roll(polygon, -1, axis=0) - polygon
    inward = np.column_stack([-edges[:, 1], edges[:, 0]]) / np.linalg.norm(edges, axis=1)[:, None]
    least = np.sum(inward * polygon, axis=1) + model.description.com_margin_m + COM_RESERVE_M
    plain = joint_limits(model.lower_rad + margin, model.upper_rad - margin, floating=True)
    return plain._replace(inward=np.ascontiguousarray(inward), offset=least)
