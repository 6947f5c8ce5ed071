"""Compiled forward kinematics of a flat tree."""

from __future__ import annotations

import math

from kinematics.arrays import Array, Indices
from kinematics.compiled.compiler import compiled, inlined
from kinematics.model.tree import FLOATING, GENERAL_AXIS, HINGE, SLIDE, Tree


@inlined
def rotate_about(P: Array, spin: int, c: float, s: float, R: Array) -> None:
    """``R = P @ rotation about x, y or z``, by its cosine and sine; shapes (3, 3)."""
    i = (spin + 1) % 3
    j = (spin + 2) % 3
    for r in range(3):
        a = P[r, i]
        b = P[r, j]
        R[r, i] = c * a + s * b
        R[r, j] = c * b - s * a
        R[r, spin] = P[r, spin]


@inlined
def _rotate_in_place(R: Array, axis: Array, c: float, s: float) -> None:
    """``R = R @ rotation about a unit axis``, by Rodrigues' formula."""
    x, y, z = axis[0], axis[1], axis[2]
    d = 1.0 - c
    for r in range(3):
        a, b, e = R[r, 0], R[r, 1], R[r, 2]
        along = d * (a * x + b * y + e * z)
        # row times (c I + s [axis] + d axis axis^T)
        R[r, 0] = c * a + s * (b * z - e * y) + along * x
        R[r, 1] = c * b + s * (e * x - a * z) + along * y
        R[r, 2] = c * e + s * (a * y - b * x) + along * z


@inlined
def _spin_in_place(R: Array, spin: int, c: float, s: float) -> None:
    """``R = R @ rotation about x, y or z``, by its cosine and sine."""
    i = (spin + 1) % 3
    j = (spin + 2) % 3
    for r in range(3):
        a = R[r, i]
        b = R[r, j]
        R[r, i] = c * a + s * b
        R[r, j] = c * b - s * a


@inlined
def quaternion_to_rotation(x: float, y: float, z: float, w: float, R: Array) -> None:
    """Rotation matrix of a quaternion of any length but 0."""
    f = 2.0 / (x * x + y * y + z * z + w * w)
    R[0, 0] = 1.0 - f * (y * y + z * z)
    R[0, 1] = f * (x * y - z * w)
    R[0, 2] = f * (x * z + y * w)
    R[1, 0] = f * (x * y + z * w)
    R[1, 1] = 1.0 - f * (x * x + z * z)
    R[1, 2] = f * (y * z - x * w)
    R[2, 0] = f * (x * z - y * w)
    R[2, 1] = f * (y * z + x * w)
    R[2, 2] = 1.0 - f * (x * x + y * y)


@compiled
def place_bodies(tree: Tree, q: Array, needed: Indices, R: Array, p: Array) -> None:
    """Poses of bodies at a configuration.

    Args:
        tree: The robot.
        q: Configuration, shape (nq,).
        needed: 0 for bodies that nobody asks for, shape (n,); what carries a needed body is needed.
        R: Result, ``world_R_body``, shape (n, 3, 3).
        p: Result, origins in the world, shape (n, 3), m.
    """
    for r in range(3):
        p[0, r] = 0.0
        for k in range(3):
            R[0, r, k] = 1.0 if r == k else 0.0
    for body in range(1, tree.parent.shape[0]):
        if needed[body] == 0:
            continue
        a = tree.parent[body]
        kind = tree.kind[body]
        at = tree.column[body]
        offset = tree.place_p[body]
        for r in range(3):
            p[body, r] = p[a, r] + R[a, r, 0] * offset[0] + R[a, r, 1] * offset[1] + R[a, r, 2] * offset[2]
        if kind == HINGE and tree.turned[body] == 0 and tree.spin[body] != GENERAL_AXIS:
            spin = tree.spin[body]
            sine = math.sin(q[at]) * tree.axis[body, spin]
            rotate_about(R[a], spin, math.cos(q[at]), sine, R[body])
            continue
        if tree.turned[body] == 0:
            for r in range(3):
                for k in range(3):
                    R[body, r, k] = R[a, r, k]
        else:
            P = tree.place_R[body]
            for r in range(3):
                for k in range(3):
                    R[body, r, k] = R[a, r, 0] * P[0, k] + R[a, r, 1] * P[1, k] + R[a, r, 2] * P[2, k]
        if kind == HINGE and tree.spin[body] != GENERAL_AXIS:
            spin = tree.spin[body]
            _spin_in_place(R[body], spin, math.cos(q[at]), math.sin(q[at]) * tree.axis[body, spin])
        elif kind == HINGE:
            _rotate_in_place(R[body], tree.axis[body], math.cos(q[at]), math.sin(q[at]))
        elif kind == SLIDE:
            axis = tree.axis[body]
            for r in range(3):
                along = R[body, r, 0] * axis[0] + R[body, r, 1] * axis[1] + R[body, r, 2] * axis[2]
                p[body, r] += q[at] * along
        elif kind == FLOATING:
            # the root: its placement is the identity in every model that Pinocchio builds
            for r in range(3):
                p[body, r] += q[at + r]
            quaternion_to_rotation(q[at + 3], q[at + 4], q[at + 5], q[at + 6], R[body])


@compiled
def centre_of_mass(tree: Tree, R: Array, p: Array, com: Array) -> None:
    """Centre of mass in the world of placed bodies, into ``com``, shape (3,), m."""
    total = 0.0
    com[0] = com[1] = com[2] = 0.0
    for body in range(1, tree.parent.shape[0]):
        m = tree.mass[body]
        if m == 0.0:
            continue
        lever = tree.lever[body]
        total += m
        for r in range(3):
            turned = R[body, r, 0] * lever[0] + R[body, r, 1] * lever[1] + R[body, r, 2] * lever[2]
            com[r] += m * (p[body, r] + turned)
    for r in range(3):
        com[r] /= total
