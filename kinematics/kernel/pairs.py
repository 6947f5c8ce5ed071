"""Which solids a scene keeps apart and by how much, as flat arrays."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from kinematics.kernel.robot_arrays import Chains, RobotArrays
from kinematics.kernel.solids import Solid, plain_solid
from kinematics.kernel.tree import WORLD
from kinematics.scene import PlanningScene

Array = NDArray[np.float64]
Indices = NDArray[np.int64]


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


class OwnPair(NamedTuple):
    """Two moving solids that stay apart.

    Attributes:
        first, second: Their numbers.
        margin_m: By how much.
    """

    first: int
    second: int
    margin_m: float


class SceneSolids(NamedTuple):
    """A scene before its pairs are made.

    Attributes:
        solids: The robot's, what it holds, then the objects.
        names: Link or object of each.
        moving: How many of them move.
        own: Pairs among those that move.
    """

    solids: list[Solid]
    names: tuple[str, ...]
    moving: int
    own: list[OwnPair]


def scene_solids(
    robot: RobotArrays, scene: PlanningScene, extra_margin_m: float, self_margin_m: float
) -> SceneSolids:
    """Solids and moving pairs of a scene, with the margins of ``CollisionWorld``.

    Raises:
        UnknownNameError: A body is attached to a frame that the robot does not have.
    """
    solids, names = list(robot.solids), list(robot.names)
    own = [OwnPair(int(i), int(j), self_margin_m) for i, j in robot.self_pairs]
    for name, body in scene.attached.items():
        carrier, carrier_T_frame = robot.frame(body.frame)
        held = plain_solid(carrier, carrier_T_frame @ body.frame_T_object, body.body.shape)
        own += [
            OwnPair(i, len(solids), extra_margin_m)
            for i in range(len(solids))
            if solids[i].body != carrier
            and names[i] not in body.touch_links
            and not scene.is_allowed(names[i], name)
        ]
        solids.append(held)
        names.append(name)
    moving = len(solids)
    for item in scene.objects.values():
        solids.append(plain_solid(WORLD, item.world_T_object, item.shape))
        names.append(item.name)
    return SceneSolids(solids, tuple(names), moving, own)


def pairs_of(
    robot: RobotArrays,
    chains: Chains,
    scene: PlanningScene,
    found: SceneSolids,
    own: Sequence[OwnPair],
    extra_margin_m: float,
) -> Pairs:
    """Flatten a scene's pairs; ``own`` are the moving pairs to keep."""
    body = [solid.body for solid in found.solids]
    groups: dict[tuple[int, int], list[OwnPair]] = {}
    for pair in own:
        groups.setdefault((body[pair.first], body[pair.second]), []).append(pair)
    ordered = [pair for group in groups.values() for pair in group]
    sizes = [len(group) for group in groups.values()]
    starts = np.cumsum([0, *sizes])
    levels = [_meeting(chains, i, j) for i, j in groups]
    objects = list(scene.objects.values())
    judged = np.ones((len(objects), found.moving), np.int64)
    touch = {name: item.touch_links for name, item in scene.attached.items()}
    allowed: dict[str, set[str]] = {}
    for names in scene.allowed:
        for name in names:
            allowed.setdefault(name, set()).update(names - {name})
    for row, item in enumerate(objects):
        unjudged = allowed.get(item.name, set())
        for column in range(found.moving):
            link = found.names[column]
            if link in unjudged or item.name in touch.get(link, frozenset()):
                judged[row, column] = 0
    carriers = sorted(set(body[: found.moving]), key=lambda b: (robot.limb[b], b))
    solids_of = [[s for s in range(found.moving) if body[s] == b] for b in carriers]
    counts = np.bincount(robot.limb[np.array(carriers, np.int64)], minlength=chains.limbs)
    return Pairs(
        first=np.array([pair.first for pair in ordered], np.int64),
        second=np.array([pair.second for pair in ordered], np.int64),
        margin=np.array([pair.margin_m for pair in ordered], np.float64),
        group=np.repeat(np.arange(len(groups)), sizes).astype(np.int64),
        group_first=np.array([i for i, _ in groups], np.int64),
        group_second=np.array([j for _, j in groups], np.int64),
        first_level=np.array([a for a, _ in levels], np.int64),
        second_level=np.array([b for _, b in levels], np.int64),
        group_margin=np.array([max(pair.margin_m for pair in group) for group in groups.values()]),
        group_start=starts.astype(np.int64),
        moving=found.moving,
        object_margin=np.array([item.margin_m + extra_margin_m for item in objects], np.float64),
        judged=judged,
        limb_start=np.concatenate([[0], np.cumsum(counts)]).astype(np.int64),
        limb_bodies=np.array(carriers, np.int64),
        body_start=np.cumsum([0, *map(len, solids_of)]).astype(np.int64),
        body_solids=np.array([s for part in solids_of for s in part], np.int64),
    )


def _meeting(chains: Chains, first: int, second: int) -> tuple[int, int]:
    """How many joints each of two bodies is away from the body that carries both."""
    a = list(chains.joint[first, : chains.length[first]])
    b = list(chains.joint[second, : chains.length[second]])
    while a and b and a[-1] == b[-1]:
        a.pop()
        b.pop()
    return len(a), len(b)
