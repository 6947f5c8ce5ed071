"""A robot's kinematic tree as flat arrays, for compiled code.

Any tree of hinges and slides, hanging from the world by a floating base or by a weld, with its
joints' placements and axes as they come.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import pinocchio as pin

from kinematics.arrays import Array, Indices
from kinematics.errors import ModelError

WORLD = 0
WELDED, HINGE, SLIDE, FLOATING = 0, 1, 2, 3
GENERAL_AXIS = 3


class Tree(NamedTuple):
    """Bodies are Pinocchio's joints; body 0 is the world; a parent comes before its children.

    Attributes:
        parent: Parent body, shape (n,).
        kind: WELDED, HINGE, SLIDE or FLOATING, shape (n,).
        column: Where the joint's position begins in ``q``, shape (n,).
        spin: 0, 1 or 2 for a hinge about plus or minus x, y or z, else GENERAL_AXIS, shape (n,).
        axis: Joint axis in the body's frame, shape (n, 3).
        turned: 1 when the placement has a rotation, else 0, shape (n,).
        place_R, place_p: Placement of the joint in its parent, shapes (n, 3, 3) and (n, 3), m.
        mass: Shape (n,), kg.
        lever: Centre of mass in the body's frame, shape (n, 3), m.
    """

    parent: Indices
    kind: Indices
    column: Indices
    spin: Indices
    axis: Array
    turned: Indices
    place_R: Array
    place_p: Array
    mass: Array
    lever: Array


def tree_of(model: pin.Model) -> Tree:
    """Flatten a Pinocchio model.

    Raises:
        ModelError: A joint is neither a floating base at the root nor a hinge or slide of one number.
    """
    n = int(model.njoints)
    kind, spin = np.zeros(n, np.int64), np.full(n, GENERAL_AXIS)
    axis = np.zeros((n, 3))
    for body in range(1, n):
        joint = model.joints[body]
        subspace = np.array(joint.createData().S).reshape(6, -1)
        if body == 1 and joint.nq == 7 and subspace.shape[1] == 6:
            kind[body] = FLOATING
            continue
        linear, angular = (subspace[:3, 0], subspace[3:, 0]) if subspace.shape[1] == 1 else (axis[0], axis[0])
        hinge = not linear.any()
        axis[body] = angular if hinge else linear
        if joint.nq != 1 or abs(np.linalg.norm(axis[body]) - 1.0) > 1e-9 or (not hinge and angular.any()):
            raise ModelError(f"joint {model.names[body]!r} ({joint.shortname()}) is no hinge and no slide")
        kind[body] = HINGE if hinge else SLIDE
        along = np.abs(axis[body]).argmax()
        if hinge and abs(axis[body, along]) == 1.0:
            spin[body] = along
    placements = model.jointPlacements
    rotation = np.array([np.array(place.rotation) for place in placements])
    return Tree(
        parent=np.array(list(model.parents), np.int64),
        kind=kind,
        column=np.array([joint.idx_q if i else 0 for i, joint in enumerate(model.joints)], np.int64),
        spin=spin.astype(np.int64),
        axis=axis,
        turned=np.array([int(abs(R - np.eye(3)).max() > 1e-12) for R in rotation], np.int64),
        place_R=rotation,
        place_p=np.array([np.array(place.translation) for place in placements]),
        mass=np.array([0.0, *(float(inertia.mass) for inertia in list(model.inertias)[1:])]),
        lever=np.array([np.array(inertia.lever) for inertia in model.inertias]),
    )


def welded_at(tree: Tree, base: int, mount_R: Array, mount_p: Array) -> Tree:
    """The same tree with its floating base bolted to the world.

    Args:
        tree: The tree.
        base: The body that floats.
        mount_R, mount_p: ``world_R_base``, shape (3, 3), and the base's place in the world, shape (3,), m.
    """
    kind, turned = tree.kind.copy(), tree.turned.copy()
    place_R, place_p = tree.place_R.copy(), tree.place_p.copy()
    kind[base], turned[base] = WELDED, 1
    place_R[base], place_p[base] = mount_R, mount_p
    return tree._replace(kind=kind, turned=turned, place_R=place_R, place_p=place_p)
