"""Which joints lie between each body and the world, and balls about what the bodies carry."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from kinematics.arrays import Array, Indices
from kinematics.distance.solids import Solid
from kinematics.model.tree import WORLD, Tree
from kinematics.standing.flat_coordinates import Coordinates


class Chains(NamedTuple):
    """Which joints lie between a body and the world, and a ball about each body.

    A leg whose foot is planted hangs from the floor by its ankle, not from the base by its hip, as
    far as its thigh; the two small bodies in the hip hang from the base.

    Attributes:
        joint: Joints (by body) from a body outwards to the world, shape (n, depth).
        length: How many, shape (n,).
        limb: The limb that each body belongs to, shape (n,): a stretch of the tree without branches.
        limbs: How many limbs there are.
        centre, radius: Ball in the body's frame that holds its solids and its centre of mass, shapes
            (n, 3) and (n,), m.
    """

    joint: Indices
    length: Indices
    limb: Indices
    limbs: int
    centre: Array
    radius: Array


def chains_of(tree: Tree, space: Coordinates, solids: Sequence[Solid]) -> Chains:
    """Chains for free coordinates, and balls about all that the bodies carry."""
    n = len(tree.parent)
    chains: list[list[int]] = []
    for body in range(n):
        chain = []
        while body != WORLD:
            chain.append(body)
            body = int(tree.parent[body])
        chains.append(chain)
    for leg in space.leg_bodies:
        for k in range(2, 6):
            chains[leg[k]] = [int(joint) for joint in leg[k + 1 :]]
    joint = np.zeros((n, max(map(len, chains))), np.int64)
    for body, chain in enumerate(chains):
        joint[body, : len(chain)] = chain
    length = np.array([len(chain) for chain in chains], np.int64)
    limb = limbs_of(tree)
    bare = Chains(joint, length, limb, int(limb.max()) + 1, tree.lever, np.zeros(n))
    return with_solids(bare, solids)


def with_solids(chains: Chains, solids: Sequence[Solid]) -> Chains:
    """The same with balls that hold more."""
    centre, radius = chains.centre.copy(), chains.radius.copy()
    for solid in solids:
        if solid.body != WORLD:
            b = solid.body
            centre[b], radius[b] = _around(centre[b], radius[b], solid.centre, solid.radius_m)
    return chains._replace(centre=centre, radius=radius)


def _around(a: Array, ra: float, b: Array, rb: float) -> tuple[Array, float]:
    """The smallest ball about two balls."""
    apart = float(np.linalg.norm(b - a))
    if apart + rb <= ra:
        return a, ra
    if apart + ra <= rb:
        return b, rb
    radius = 0.5 * (apart + ra + rb)
    return a + (b - a) * ((radius - ra) / apart), radius * (1.0 + 1e-12)


def limbs_of(tree: Tree) -> Indices:
    """The limb of each body: a stretch of the tree without branches, shape (bodies,)."""
    children = np.bincount(tree.parent[1:], minlength=len(tree.parent))
    limb = np.zeros(len(tree.parent), np.int64)
    count = 0
    for body in range(1, len(tree.parent)):
        parent = tree.parent[body]
        if parent == WORLD or children[parent] > 1:
            limb[body] = count
            count += 1
        else:
            limb[body] = limb[parent]
    return limb
