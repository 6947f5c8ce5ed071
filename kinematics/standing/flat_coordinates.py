"""Free coordinates of a robot, and what a posture must keep, as flat arrays.

What is compiled imports this; what makes them of a robot's model is in ``model_coordinates``.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from kinematics.arrays import Array, Indices
from kinematics.model.tree import FLOATING, Tree
from kinematics.standing.reserves import LIMIT_NOISE_RAD


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
