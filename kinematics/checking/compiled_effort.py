"""Compiled: the checker's own inverse dynamics of a robot that stands.

Forces and moments of all bodies about the world's origin, added up from the tips inwards: what a joint
has to give is the moment about its axis of all that it carries.
"""

from __future__ import annotations

import numpy as np

from kinematics.arrays import Array, Indices
from kinematics.checking.compiled_placing import FIRST_JOINT, Links
from kinematics.compiled.compiler import compiled

GRAVITY_M_S2 = 9.81


@compiled
def loads_of(
    links: Links,
    mass: Array,
    lever: Array,
    inertia: Array,
    R: Array,
    p: Array,
    v: Array,
    a: Array,
    feet: Indices,
    soles: Array,
    share: Array,
    torques: Array,
    zmp: Array,
) -> None:
    """Joint torques when the soles carry everything, all at the same place of their own; and the ZMP.

    Args:
        links: The robot.
        mass, lever: Of each body, shapes (bodies,) and (bodies, 3), kg and m.
        inertia: About its centre of mass in its own axes, shape (bodies, 3, 3), kg m^2.
        R, p: Poses of all bodies at n instants, shapes (bodies, n, 3, 3) and (bodies, n, 3).
        v, a: Velocities and accelerations, shape (n, nv), the base's in its own axes.
        feet: Bodies of the m soles, shape (m,).
        soles: Where they stand, shape (m, 3), m.
        share: The part of each sole in the wrench of the ground for each ZMP (x, y, 1), held between 0 and
            1, shape (m, 3).
        torques: Result, shape (n, joints), Nm.
        zmp: Result, shape (n, 2), m.
    """
    bodies = mass.shape[0]
    # rows: angular velocity, its derivative, acceleration of the origin
    motion = np.zeros((bodies, 3, 3))
    # rows: force, moment about the world's origin
    load = np.zeros((bodies, 2, 3))
    axes = np.zeros((bodies, 3))
    arm, about, rest = np.zeros(3), np.zeros(3), np.zeros(3)
    part = np.zeros(feet.shape[0])
    for i in range(v.shape[0]):
        base = R[1, i]
        omega, alpha, acceleration = motion[1, 0], motion[1, 1], motion[1, 2]
        for r in range(3):
            arm[r] = base[r, 0] * v[i, 0] + base[r, 1] * v[i, 1] + base[r, 2] * v[i, 2]
            omega[r] = base[r, 0] * v[i, 3] + base[r, 1] * v[i, 4] + base[r, 2] * v[i, 5]
            alpha[r] = base[r, 0] * a[i, 3] + base[r, 1] * a[i, 4] + base[r, 2] * a[i, 5]
            acceleration[r] = base[r, 0] * a[i, 0] + base[r, 1] * a[i, 1] + base[r, 2] * a[i, 2]
        _add_cross(omega, arm, 1.0, acceleration)
        acceleration[2] += GRAVITY_M_S2
        for body in range(FIRST_JOINT, bodies):
            k = links.parent[body]
            rate, change = v[i, body + 4], a[i, body + 4]
            turn, axis = R[body, i], axes[body]
            for r in range(3):
                along = links.axis[body]
                axis[r] = turn[r, 0] * along[0] + turn[r, 1] * along[1] + turn[r, 2] * along[2]
                motion[body, 0, r] = motion[k, 0, r] + rate * axis[r]
                motion[body, 1, r] = motion[k, 1, r] + change * axis[r]
                motion[body, 2, r] = motion[k, 2, r]
                arm[r] = p[body, i, r] - p[k, i, r]
            _add_cross(motion[k, 0], axis, rate, motion[body, 1])
            _add_swing(motion[k], arm, about, motion[body, 2])
        for body in range(1, bodies):
            _load_of(
                mass[body],
                lever[body],
                inertia[body],
                R[body, i],
                p[body, i],
                motion[body],
                arm,
                about,
                load[body],
            )
        for body in range(bodies - 1, FIRST_JOINT - 1, -1):
            force, moment = load[body, 0], load[body, 1]
            place, axis = p[body, i], axes[body]
            # about the body's own origin
            n0 = moment[0] - place[1] * force[2] + place[2] * force[1]
            n1 = moment[1] - place[2] * force[0] + place[0] * force[2]
            n2 = moment[2] - place[0] * force[1] + place[1] * force[0]
            torques[i, body - FIRST_JOINT] = n0 * axis[0] + n1 * axis[1] + n2 * axis[2]
            for r in range(3):
                load[links.parent[body], 0, r] += force[r]
                load[links.parent[body], 1, r] += moment[r]
        ground = load[1]
        lift = max(ground[0, 2], 1e-6)
        zmp[i, 0], zmp[i, 1] = -ground[1, 1] / lift, ground[1, 0] / lift
        # what the forces at the soles leave over of the moment
        for r in range(3):
            rest[r] = ground[1, r]
        for foot in range(feet.shape[0]):
            part[foot] = share[foot, 0] * zmp[i, 0] + share[foot, 1] * zmp[i, 1] + share[foot, 2]
            part[foot] = min(max(part[foot], 0.0), 1.0)
            _add_cross(soles[foot], ground[0], -part[foot], rest)
        for foot in range(feet.shape[0]):
            for r in range(3):
                arm[r] = part[foot] * ground[0, r]
                about[r] = part[foot] * rest[r]
            body = feet[foot]
            while body >= FIRST_JOINT:
                x, y, z = (
                    soles[foot, 0] - p[body, i, 0],
                    soles[foot, 1] - p[body, i, 1],
                    soles[foot, 2] - p[body, i, 2],
                )
                axis = axes[body]
                torques[i, body - FIRST_JOINT] -= (
                    axis[0] * (y * arm[2] - z * arm[1] + about[0])
                    + axis[1] * (z * arm[0] - x * arm[2] + about[1])
                    + axis[2] * (x * arm[1] - y * arm[0] + about[2])
                )
                body = links.parent[body]


@compiled
def _load_of(
    mass: float,
    lever: Array,
    inertia: Array,
    turn: Array,
    place: Array,
    motion: Array,
    arm: Array,
    about: Array,
    load: Array,
) -> None:
    """What moves one body: force, and moment about the world's origin; ``arm`` and ``about`` are scratch."""
    force, moment = load[0], load[1]
    for r in range(3):
        arm[r] = turn[r, 0] * lever[0] + turn[r, 1] * lever[1] + turn[r, 2] * lever[2]
        force[r] = motion[2, r]
        moment[r] = 0.0
    _add_swing(motion, arm, about, force)
    for r in range(3):
        force[r] *= mass
        arm[r] += place[r]
    _add_cross(arm, force, 1.0, moment)
    # angular momentum and its change in the body's axes
    for r in range(3):
        about[r] = turn[0, r] * motion[0, 0] + turn[1, r] * motion[0, 1] + turn[2, r] * motion[0, 2]
        arm[r] = turn[0, r] * motion[1, 0] + turn[1, r] * motion[1, 1] + turn[2, r] * motion[1, 2]
    o0, o1, o2 = about[0], about[1], about[2]
    e0, e1, e2 = arm[0], arm[1], arm[2]
    for r in range(3):
        arm[r] = inertia[r, 0] * o0 + inertia[r, 1] * o1 + inertia[r, 2] * o2
    h0, h1, h2 = arm[0], arm[1], arm[2]
    for r in range(3):
        arm[r] = inertia[r, 0] * e0 + inertia[r, 1] * e1 + inertia[r, 2] * e2
    g0, g1, g2 = arm[0] + o1 * h2 - o2 * h1, arm[1] + o2 * h0 - o0 * h2, arm[2] + o0 * h1 - o1 * h0
    for r in range(3):
        moment[r] += turn[r, 0] * g0 + turn[r, 1] * g1 + turn[r, 2] * g2


@compiled
def _add_cross(one: Array, other: Array, times: float, to: Array) -> None:
    """Add a multiple of a vector product."""
    to[0] += times * (one[1] * other[2] - one[2] * other[1])
    to[1] += times * (one[2] * other[0] - one[0] * other[2])
    to[2] += times * (one[0] * other[1] - one[1] * other[0])


@compiled
def _add_swing(motion: Array, arm: Array, speed: Array, to: Array) -> None:
    """Add the acceleration of the end of an arm against its beginning; ``speed`` is scratch."""
    for r in range(3):
        speed[r] = 0.0
    _add_cross(motion[0], arm, 1.0, speed)
    _add_cross(motion[0], speed, 1.0, to)
    _add_cross(motion[1], arm, 1.0, to)
