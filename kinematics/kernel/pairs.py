"""Which solids are kept apart and by how much, as flat arrays."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array, Indices
from kinematics.kernel.chains import Chains


class Pairs(NamedTuple):
    """Pairs among what moves, and of what moves with what is around.

    Solids are numbered: the robot's, what it holds, then the objects. Pair ``k`` is ``first[k]`` and
    ``second[k]`` for ``k < len(first)``; after those, object by object, every moving solid with it.

    Attributes:
        first, second: Pairs among the moving solids, by group, shape (p,).
        margin: What they keep, shape (p,), m.
        group: Group of each pair, shape (p,).
        group_first, group_second: The two bodies that a group of pairs is about, shape (groups,).
        first_level, second_level: How many joints are between each of them and what carries both,
            shape (groups,).
        group_margin: The largest margin in a group, shape (groups,), m.
        group_start: Where each group begins, shape (groups + 1,).
        moving: Number of moving solids.
        object_margin: What everything keeps from each object, shape (objects,), m.
        judged: 1 where a solid is judged against an object, shape (objects, moving).
        limb_start: Where each limb begins in ``limb_bodies``, shape (limbs + 1,).
        limb_bodies: Bodies that carry solids, by limb.
        body_start: Where the solids of each of those bodies begin in ``body_solids``.
        body_solids: The moving solids by body, shape (moving,).
        object_low, object_high: Boxes along the world's axes that hold the objects, shape (3, objects), m.
    """

    first: Indices
    second: Indices
    margin: Array
    group: Indices
    group_first: Indices
    group_second: Indices
    first_level: Indices
    second_level: Indices
    group_margin: Array
    group_start: Indices
    moving: int
    object_margin: Array
    judged: Indices
    limb_start: Indices
    limb_bodies: Indices
    body_start: Indices
    body_solids: Indices
    object_low: Array
    object_high: Array


class OwnPair(NamedTuple):
    """Two moving solids that stay apart.

    Attributes:
        first, second: Their numbers.
        margin_m: By how much.
    """

    first: int
    second: int
    margin_m: float


class OwnPairs(NamedTuple):
    """Pairs among what moves, by group; attributes as the first ones of ``Pairs``."""

    first: Indices
    second: Indices
    margin: Array
    group: Indices
    group_first: Indices
    group_second: Indices
    first_level: Indices
    second_level: Indices
    group_margin: Array
    group_start: Indices


def grouped(own: Sequence[OwnPair], body: Sequence[int], chains: Chains) -> OwnPairs:
    """Flatten pairs of moving solids.

    Args:
        own: The pairs.
        body: Body of each solid.
        chains: Of the bodies.
    """
    groups: dict[tuple[int, int], list[OwnPair]] = {}
    for pair in own:
        groups.setdefault((body[pair.first], body[pair.second]), []).append(pair)
    ordered = [pair for group in groups.values() for pair in group]
    sizes = [len(group) for group in groups.values()]
    levels = [meeting(chains, i, j) for i, j in groups]
    return OwnPairs(
        first=np.array([pair.first for pair in ordered], np.int64),
        second=np.array([pair.second for pair in ordered], np.int64),
        margin=np.array([pair.margin_m for pair in ordered], np.float64),
        group=np.repeat(np.arange(len(groups)), sizes).astype(np.int64),
        group_first=np.array([i for i, _ in groups], np.int64),
        group_second=np.array([j for _, j in groups], np.int64),
        first_level=np.array([a for a, _ in levels], np.int64),
        second_level=np.array([b for _, b in levels], np.int64),
        group_margin=np.array([max(pair.margin_m for pair in group) for group in groups.values()]),
        group_start=np.cumsum([0, *sizes]).astype(np.int64),
    )


def joined(one: OwnPairs, other: OwnPairs) -> OwnPairs:
    """Pairs of the same robot behind each other."""
    both = OwnPairs(*(np.concatenate(two) for two in zip(one, other, strict=True)))
    return both._replace(
        group=np.concatenate([one.group, other.group + len(one.group_first)]),
        group_start=np.concatenate([one.group_start[:-1], other.group_start + one.group_start[-1]]),
    )


class Carriers(NamedTuple):
    """Which bodies carry solids, by limb; attributes as those of ``Pairs``."""

    moving: int
    limb_start: Indices
    limb_bodies: Indices
    body_start: Indices
    body_solids: Indices


def carriers_of(limb: Indices, body: Sequence[int]) -> Carriers:
    """The bodies that carry solids.

    Args:
        limb: Limb of each body.
        body: Body of each moving solid.
    """
    carrier = np.array(body, np.int64)
    order = np.lexsort((carrier, limb[carrier]))
    carriers, counts = np.unique(carrier, return_counts=True)
    place = np.lexsort((carriers, limb[carriers]))
    on_limb = np.bincount(limb[carriers], minlength=int(limb.max()) + 1)
    return Carriers(
        moving=len(carrier),
        limb_start=_starts(on_limb),
        limb_bodies=carriers[place],
        body_start=_starts(counts[place]),
        body_solids=order.astype(np.int64),
    )


def _starts(counts: NDArray[np.intp]) -> Indices:
    return np.concatenate([[0], np.cumsum(counts)]).astype(np.int64)


def meeting(chains: Chains, first: int, second: int) -> tuple[int, int]:
    """How many joints each of two bodies is away from the body that carries both."""
    a = list(chains.joint[first, : chains.length[first]])
    b = list(chains.joint[second, : chains.length[second]])
    while a and b and a[-1] == b[-1]:
        a.pop()
        b.pop()
    return len(a), len(b)
