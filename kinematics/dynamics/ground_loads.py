"""Compiled: what the ground has to carry along a motion of a standing robot.

Newton's and Euler's equations of every body, in world axes, summed up: who asks for the ground alone
needs no joint torques. Featherstone, "Rigid Body Dynamics Algorithms", Springer 2008, chapter 2.
"""

from __future__ import annotations

import numpy as np

from kinematics.arrays import Array
from kinematics.compiled.compiler import compiled
from kinematics.model.forward_kinematics import place_bodies
from kinematics.model.tree import SLIDE, Tree

GRAVITY_M_S2 = 9.81


@compiled
def ground_loads(
    tree: Tree, inertia: Array, q: Array, v: Array, a: Array, force: Array, moment: Array, com: Array
) -> None:
    """Force and moment of the ground, and the CoM, at many instants.

    Args:
        tree: A robot whose first body floats.
        inertia: Of each body about its centre of mass, in its own axes, shape (bodies, 3, 3), kg m^2.
        q, v, a: Configurations, velocities, accelerations, as Pinocchio has them, shapes (n, nq), (n, nv).
        force: Result, shape (n, 3), N.
        moment: Result, about the world's origin, shape (n, 3), Nm.
        com: Result, shape (n, 3), m.
    """
    bodies = tree.parent.shape[0]
    needed = np.ones(bodies, np.int64)
    R, p = np.empty((bodies, 3, 3)), np.empty((bodies, 3))
    # angular velocity and acceleration, and the acceleration of each body's origin
    w, u, b = np.zeros((bodies, 3)), np.zeros((bodies, 3)), np.zeros((bodies, 3))
    turned = np.empty(3)
    for k in range(q.shape[0]):
        place_bodies(tree, q[k], needed, R, p)
        speed = np.zeros(3)
        for r in range(3):
            w[1, r] = u[1, r] = b[1, r] = 0.0
            for c in range(3):
                speed[r] += R[1, r, c] * v[k, c]
                w[1, r] += R[1, r, c] * v[k, 3 + c]
                u[1, r] += R[1, r, c] * a[k, 3 + c]
                b[1, r] += R[1, r, c] * a[k, c]
        # the twist is that of a moving frame: its derivative lacks what turning does to the speed
        b[1, 0] += w[1, 1] * speed[2] - w[1, 2] * speed[1]
        b[1, 1] += w[1, 2] * speed[0] - w[1, 0] * speed[2]
        b[1, 2] += w[1, 0] * speed[1] - w[1, 1] * speed[0] + GRAVITY_M_S2
        mass = 0.0
        for r in range(3):
            force[k, r] = moment[k, r] = com[k, r] = 0.0
        for i in range(1, bodies):
            if i > 1:
                _carry(tree, i, v[k], a[k], R, p, w, u, b)
            m, lever = tree.mass[i], tree.lever[i]
            x = R[i, 0, 0] * lever[0] + R[i, 0, 1] * lever[1] + R[i, 0, 2] * lever[2]
            y = R[i, 1, 0] * lever[0] + R[i, 1, 1] * lever[1] + R[i, 1, 2] * lever[2]
            z = R[i, 2, 0] * lever[0] + R[i, 2, 1] * lever[1] + R[i, 2, 2] * lever[2]
            w0, w1, w2 = w[i, 0], w[i, 1], w[i, 2]
            c0, c1, c2 = w1 * z - w2 * y, w2 * x - w0 * z, w0 * y - w1 * x
            f0 = m * (b[i, 0] + u[i, 1] * z - u[i, 2] * y + w1 * c2 - w2 * c1)
            f1 = m * (b[i, 1] + u[i, 2] * x - u[i, 0] * z + w2 * c0 - w0 * c2)
            f2 = m * (b[i, 2] + u[i, 0] * y - u[i, 1] * x + w0 * c1 - w1 * c0)
            x, y, z = x + p[i, 0], y + p[i, 1], z + p[i, 2]
            # Euler's equation in the body's axes
            o0 = R[i, 0, 0] * w0 + R[i, 1, 0] * w1 + R[i, 2, 0] * w2
            o1 = R[i, 0, 1] * w0 + R[i, 1, 1] * w1 + R[i, 2, 1] * w2
            o2 = R[i, 0, 2] * w0 + R[i, 1, 2] * w1 + R[i, 2, 2] * w2
            e0 = R[i, 0, 0] * u[i, 0] + R[i, 1, 0] * u[i, 1] + R[i, 2, 0] * u[i, 2]
            e1 = R[i, 0, 1] * u[i, 0] + R[i, 1, 1] * u[i, 1] + R[i, 2, 1] * u[i, 2]
            e2 = R[i, 0, 2] * u[i, 0] + R[i, 1, 2] * u[i, 1] + R[i, 2, 2] * u[i, 2]
            J = inertia[i]
            h0 = J[0, 0] * o0 + J[0, 1] * o1 + J[0, 2] * o2
            h1 = J[1, 0] * o0 + J[1, 1] * o1 + J[1, 2] * o2
            h2 = J[2, 0] * o0 + J[2, 1] * o1 + J[2, 2] * o2
            turned[0] = J[0, 0] * e0 + J[0, 1] * e1 + J[0, 2] * e2 + o1 * h2 - o2 * h1
            turned[1] = J[1, 0] * e0 + J[1, 1] * e1 + J[1, 2] * e2 + o2 * h0 - o0 * h2
            turned[2] = J[2, 0] * e0 + J[2, 1] * e1 + J[2, 2] * e2 + o0 * h1 - o1 * h0
            force[k, 0] += f0
            force[k, 1] += f1
            force[k, 2] += f2
            moment[k, 0] += y * f2 - z * f1
            moment[k, 1] += z * f0 - x * f2
            moment[k, 2] += x * f1 - y * f0
            for r in range(3):
                moment[k, r] += R[i, r, 0] * turned[0] + R[i, r, 1] * turned[1] + R[i, r, 2] * turned[2]
            com[k, 0] += m * x
            com[k, 1] += m * y
            com[k, 2] += m * z
            mass += m
        for r in range(3):
            com[k, r] /= mass


@compiled
def _carry(tree: Tree, i: int, v: Array, a: Array, R: Array, p: Array, w: Array, u: Array, b: Array) -> None:
    """Velocity and acceleration of a body from those of what carries it."""
    o = tree.parent[i]
    x, y, z = p[i, 0] - p[o, 0], p[i, 1] - p[o, 1], p[i, 2] - p[o, 2]
    w0, w1, w2 = w[o, 0], w[o, 1], w[o, 2]
    c0, c1, c2 = w1 * z - w2 * y, w2 * x - w0 * z, w0 * y - w1 * x
    b[i, 0] = b[o, 0] + u[o, 1] * z - u[o, 2] * y + w1 * c2 - w2 * c1
    b[i, 1] = b[o, 1] + u[o, 2] * x - u[o, 0] * z + w2 * c0 - w0 * c2
    b[i, 2] = b[o, 2] + u[o, 0] * y - u[o, 1] * x + w0 * c1 - w1 * c0
    # columns of q are one more than those of v: the base has a quaternion
    at = tree.column[i] - 1
    rate, change = v[at], a[at]
    axis = tree.axis[i]
    x = R[i, 0, 0] * axis[0] + R[i, 0, 1] * axis[1] + R[i, 0, 2] * axis[2]
    y = R[i, 1, 0] * axis[0] + R[i, 1, 1] * axis[1] + R[i, 1, 2] * axis[2]
    z = R[i, 2, 0] * axis[0] + R[i, 2, 1] * axis[1] + R[i, 2, 2] * axis[2]
    c0, c1, c2 = rate * (w1 * z - w2 * y), rate * (w2 * x - w0 * z), rate * (w0 * y - w1 * x)
    if tree.kind[i] == SLIDE:
        for r in range(3):
            w[i, r], u[i, r] = w[o, r], u[o, r]
        b[i, 0] += change * x + 2.0 * c0
        b[i, 1] += change * y + 2.0 * c1
        b[i, 2] += change * z + 2.0 * c2
        return
    w[i, 0], w[i, 1], w[i, 2] = w0 + rate * x, w1 + rate * y, w2 + rate * z
    u[i, 0] = u[o, 0] + change * x + c0
    u[i, 1] = u[o, 1] + change * y + c1
    u[i, 2] = u[o, 2] + change * z + c2
