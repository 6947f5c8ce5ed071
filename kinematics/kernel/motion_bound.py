"""Compiled: how far bodies can move against each other while joints and base move a little."""

from __future__ import annotations

import math

from kinematics.kernel.compiler import compiled
from kinematics.kernel.robot_arrays import Chains
from kinematics.kernel.tree import FLOATING, SLIDE, Array, Indices, Tree


@compiled
def bound_motion(
    tree: Tree,
    chains: Chains,
    needed: Indices,
    R: Array,
    p: Array,
    reach: Array,
    step: float,
    turn: float,
    moved: Array,
) -> None:
    """Bound each body's displacement against every body on its way to the world.

    Joints are moved one after the other, the outermost first: each carries a point along an arc about
    an axis that still is where it is now, at a distance that has grown by no more than what the
    joints before it did. So the bound is rigorous, and of first order it is the true one.

    Args:
        tree, chains: The robot.
        needed: 0 for bodies that nobody asks for, shape (n,).
        R, p: Poses of the bodies.
        reach: No joint moves farther than this, by body, shape (n,), rad or m.
        step, turn: Nor does the base, m and rad.
        moved: Result, by body and number of joints crossed, shape (n, depth + 1), m: no point of a
            body moves farther against the body that is so many joints away.
    """
    for body in range(1, tree.parent.shape[0]):
        if needed[body] == 0:
            continue
        c = chains.centre[body]
        radius = chains.radius[body]
        c0 = p[body, 0] + R[body, 0, 0] * c[0] + R[body, 0, 1] * c[1] + R[body, 0, 2] * c[2]
        c1 = p[body, 1] + R[body, 1, 0] * c[0] + R[body, 1, 1] * c[1] + R[body, 1, 2] * c[2]
        c2 = p[body, 2] + R[body, 2, 0] * c[0] + R[body, 2, 1] * c[1] + R[body, 2, 2] * c[2]
        so_far = 0.0
        moved[body, 0] = 0.0
        for crossed in range(chains.length[body]):
            k = chains.joint[body, crossed]
            kind = tree.kind[k]
            d0 = c0 - p[k, 0]
            d1 = c1 - p[k, 1]
            d2 = c2 - p[k, 2]
            if kind == FLOATING:
                if step > 0.0 or turn > 0.0:
                    so_far += step + turn * (math.sqrt(d0 * d0 + d1 * d1 + d2 * d2) + radius + so_far)
            elif reach[k] > 0.0:
                if kind == SLIDE:
                    so_far += reach[k]
                else:
                    axis = tree.axis[k]
                    a0 = R[k, 0, 0] * axis[0] + R[k, 0, 1] * axis[1] + R[k, 0, 2] * axis[2]
                    a1 = R[k, 1, 0] * axis[0] + R[k, 1, 1] * axis[1] + R[k, 1, 2] * axis[2]
                    a2 = R[k, 2, 0] * axis[0] + R[k, 2, 1] * axis[1] + R[k, 2, 2] * axis[2]
                    x = a1 * d2 - a2 * d1
                    y = a2 * d0 - a0 * d2
                    z = a0 * d1 - a1 * d0
                    so_far += reach[k] * (math.sqrt(x * x + y * y + z * z) + radius + so_far)
            moved[body, crossed + 1] = so_far
