"""Free coordinates of a standing or welded robot, and what a posture must keep, as flat arrays."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from kinematics.free_coordinates import free_coordinates
from kinematics.kernel.tree import FLOATING, Tree
from kinematics.leg_ik import LegIk
from kinematics.planning_reserve import COM_RESERVE_M, LIMIT_NOISE_RAD
from kinematics.robot_model import RobotModel
from kinematics.stance import SupportPolygon
from kinematics.stance_table import StanceTable
from kinematics.trajectory import Stance

Array = NDArray[np.float64]
Indices = NDArray[np.int64]


class Coordinates(NamedTuple):
    """How free coordinates ``x`` make a configuration ``q``.

    Attributes:
        floating: 1 when ``x`` begins with the base's position and rotation vector, else 0.
        columns: Columns of ``q`` of the joints in ``x``, shape (m,).
        bodies: Bodies of those joints, shape (m,).
        leg_bodies: Bodies of each leg whose foot is planted, hip to ankle, shape (legs, 6).
        hip: Hips in the base's frame, shape (legs, 3), m.
        bones: Lengths of thigh and shin, shape (legs, 2), m.
        foot_R: ``world_R_ankle``, shape (legs, 3, 3).
        ankle: Ankles in the world, shape (legs, 3), m.
    """

    floating: int
    columns: Indices
    bodies: Indices
    leg_bodies: Indices
    hip: Array
    bones: Array
    foot_R: Array
    ankle: Array


class Limits(NamedTuple):
    """What a posture must keep.

    Attributes:
        lower, upper: By column of ``q``; infinite for the base, shape (nq,).
        inward: Inward normals of the support polygon's edges, shape (k, 2); k may be 0.
        offset: Least ``inward @ com``, the margin included, shape (k,), m.
    """

    lower: Array
    upper: Array
    inward: Array
    offset: Array


def _standing_coordinates(model: RobotModel, stance: Stance) -> Coordinates:
    legs = LegIk(model, stance).geometry
    space = free_coordinates(model, stance)
    return Coordinates(
        floating=1,
        columns=(7 + model.indices(space.joints)).astype(np.int64),
        bodies=np.array([model.pin.getJointId(joint) for joint in space.joints], np.int64),
        leg_bodies=np.array([leg.joints for leg in legs], np.int64).reshape(-1, 6),
        hip=np.array([leg.hip_m for leg in legs]).reshape(-1, 3),
        bones=np.array([(leg.thigh_m, leg.shin_m) for leg in legs]).reshape(-1, 2),
        foot_R=np.array([leg.foot_R for leg in legs]).reshape(-1, 3, 3),
        ankle=np.array([leg.ankle_m for leg in legs]).reshape(-1, 3),
    )


standing_coordinates = StanceTable(_standing_coordinates)
"""The coordinates of ``FreeCoordinates``, column by column; ``ModelError`` where a leg has no closed form."""


def mounted_coordinates(model: RobotModel, tree: Tree) -> Coordinates:
    """The coordinates of a welded robot's ``FreeCoordinates``: its joints."""
    bodies = np.array([model.pin.getJointId(joint) for joint in model.joints], np.int64)
    return plain_coordinates(tree)._replace(floating=0, columns=tree.column[bodies], bodies=bodies)


def mounted_limits(model: RobotModel) -> Limits:
    """Joint limits shrunk for planning; a welded robot cannot lose its balance."""
    margin = model.description.planning_margin_rad
    return joint_limits(model.lower_rad + margin, model.upper_rad - margin, floating=True)


def plain_coordinates(tree: Tree) -> Coordinates:
    """Every joint on its own, after the base's position and rotation vector when it floats."""
    floating = bool((tree.kind == FLOATING).any())
    bodies = np.arange(2 if floating else 1, len(tree.kind), dtype=np.int64)
    return Coordinates(
        floating=int(floating),
        columns=tree.column[bodies],
        bodies=bodies,
        leg_bodies=np.zeros((0, 6), np.int64),
        hip=np.zeros((0, 3)),
        bones=np.zeros((0, 2)),
        foot_R=np.zeros((0, 3, 3)),
        ankle=np.zeros((0, 3)),
    )


def joint_limits(lower: Array, upper: Array, floating: bool) -> Limits:
    """Joint limits alone, in the order of ``q``'s joints."""
    free = np.full(7 if floating else 0, np.inf)
    return Limits(
        lower=np.concatenate([-free, lower - LIMIT_NOISE_RAD]),
        upper=np.concatenate([free, upper + LIMIT_NOISE_RAD]),
        inward=np.zeros((0, 2)),
        offset=np.zeros(0),
    )


def _standing_limits(model: RobotModel, stance: Stance) -> Limits:
    margin = model.description.planning_margin_rad
    polygon = SupportPolygon(stance, model.description.soles).vertices_m
    edges = np.roll(polygon, -1, axis=0) - polygon
    inward = np.column_stack([-edges[:, 1], edges[:, 0]]) / np.linalg.norm(edges, axis=1)[:, None]
    least = np.sum(inward * polygon, axis=1) + model.description.com_margin_m + COM_RESERVE_M
    plain = joint_limits(model.lower_rad + margin, model.upper_rad - margin, floating=True)
    return plain._replace(inward=np.ascontiguousarray(inward), offset=least)


standing_limits = StanceTable(_standing_limits)
"""Joint limits shrunk for planning and the CoM's margin with its reserve, as the path planner judges them."""
