"""Compiled: the checker's own forward kinematics."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from kinematics.arrays import Array, Indices
from kinematics.compiled.compiler import compiled, inlined
from kinematics.compiled.loose_arrays import loose2, loose3, loose_ints1

FIRST_JOINT = 2
"""The first body that hangs from the base."""


class Links(NamedTuple):
    """The kinematic tree, with Rodrigues' formula multiplied out; see ``BatchedKinematics``.

    Attributes:
        parent: Shape (bodies,).
        offset: Shape (bodies, 3), m.
        axis: Shape (bodies, 3).
        fixed, sine, versine: Shape (bodies, 3, 3).
    """

    parent: Indices
    offset: Array
    axis: Array
    fixed: Array
    sine: Array
    versine: Array


@inlined
def loose_links(links: Links) -> Links:
    """Every array of links, see ``check_loose_arrays``."""
    return Links(
        loose_ints1(links.parent),
        loose2(links.offset),
        loose2(links.axis),
        loose3(links.fixed),
        loose3(links.sine),
        loose3(links.versine),
    )


@compiled
def place_needed(
    links: Links,
    value: Array,
    quaternion: Array,
    moves: Indices,
    needed: Indices,
    local: Array,
    R: Array,
    p: Array,
) -> None:
    """Poses of the needed bodies; ``local`` holds the rotations of joints that do not move."""
    x, y, z, w = quaternion[0], quaternion[1], quaternion[2], quaternion[3]
    R[1, 0, 0] = 1.0 - 2.0 * (y * y + z * z)
    R[1, 0, 1] = 2.0 * (x * y - z * w)
    R[1, 0, 2] = 2.0 * (x * z + y * w)
    R[1, 1, 0] = 2.0 * (x * y + z * w)
    R[1, 1, 1] = 1.0 - 2.0 * (x * x + z * z)
    R[1, 1, 2] = 2.0 * (y * z - x * w)
    R[1, 2, 0] = 2.0 * (x * z - y * w)
    R[1, 2, 1] = 2.0 * (y * z + x * w)
    R[1, 2, 2] = 1.0 - 2.0 * (x * x + y * y)
    for r in range(3):
        p[1, r] = value[r]
    for body in range(FIRST_JOINT, needed.shape[0]):
        if needed[body] == 0:
            continue
        k = links.parent[body]
        if moves[body] == 1:
            angle = value[body + 1]
            sine = math.sin(angle)
            versine = 1.0 - math.cos(angle)
            for a in range(3):
                for b in range(3):
                    local[body, a, b] = (
                        links.fixed[body, a, b]
                        + sine * links.sine[body, a, b]
                        + versine * links.versine[body, a, b]
                    )
        o = links.offset[body]
        for a in range(3):
            x, y, z = R[k, a, 0], R[k, a, 1], R[k, a, 2]
            for b in range(3):
                R[body, a, b] = x * local[body, 0, b] + y * local[body, 1, b] + z * local[body, 2, b]
            p[body, a] = x * o[0] + y * o[1] + z * o[2] + p[k, a]


@compiled
def place_all(
    links: Links,
    base_R: Array,
    base_p: Array,
    joints: Array,
    needed: Indices,
    mass: Array,
    lever: Array,
    R: Array,
    p: Array,
    com: Array,
) -> None:
    """Poses of the needed bodies at n instants, and the moment of mass of those.

    Args:
        links: The robot.
        base_R, base_p: Poses of the base, shapes (n, 3, 3) and (n, 3), m.
        joints: Joint positions, shape (n, k), rad.
        needed: 1 for bodies to be placed, with all that they hang on, shape (bodies,).
        mass, lever: Of each body, shapes (bodies,) and (bodies, 3), kg and m.
        R, p: Results, shapes (bodies, n, 3, 3) and (bodies, n, 3).
        com: Result, sum of masses times positions, shape (n, 3), kg m.
    """
    local = np.empty((3, 3))
    for i in range(base_p.shape[0]):
        for a in range(3):
            for b in range(3):
                R[0, i, a, b] = 1.0 if a == b else 0.0
                R[1, i, a, b] = base_R[i, a, b]
            p[0, i, a] = 0.0
            p[1, i, a] = base_p[i, a]
        for body in range(FIRST_JOINT, needed.shape[0]):
            if needed[body] == 0:
                continue
            k = links.parent[body]
            angle = joints[i, body - FIRST_JOINT]
            sine = math.sin(angle)
            versine = 1.0 - math.cos(angle)
            for a in range(3):
                for b in range(3):
                    local[a, b] = (
                        links.fixed[body, a, b]
                        + sine * links.sine[body, a, b]
                        + versine * links.versine[body, a, b]
                    )
            for a in range(3):
                x, y, z = R[k, i, a, 0], R[k, i, a, 1], R[k, i, a, 2]
                for b in range(3):
                    R[body, i, a, b] = x * local[0, b] + y * local[1, b] + z * local[2, b]
                o = links.offset[body]
                p[body, i, a] = x * o[0] + y * o[1] + z * o[2] + p[k, i, a]
        for a in range(3):
            total = 0.0
            for body in range(needed.shape[0]):
                if needed[body] == 1:
                    c = lever[body]
                    x = R[body, i, a, 0] * c[0] + R[body, i, a, 1] * c[1] + R[body, i, a, 2] * c[2]
                    total += mass[body] * (x + p[body, i, a])
            com[i, a] = total
