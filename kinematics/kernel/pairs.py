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
        first, second: Pairs among the moving solids, shape (p,).
        margin: What they keep, shape (p,), m.
        first_level, second_level: How many joints are between each and what carries both, shape (p,).
        moving: Number of moving solids.
        object_margin: What everything keeps from each object, shape (objects,), m.
        judged: 1 where a solid is judged against an object, shape (objects, moving).
        limb_start: Where each limb begins in ``limb_solids``, shape (limbs + 1,).
        limb_solids: The moving solids by limb, shape (moving,).
    """

    first: Indices
    second: Indices
    margin: Array
    first_level: Indices
    second_level: Indices
    moving: int
    object_margin: Array
    judged: NDArray[np.uint8]
    limb_start: Indices
    limb_solids: Indices


class SceneSolids(NamedTuple):
    """A scene before its pairs are made.

    Attributes:
        solids: The robot's, what it holds, then the objects.
        names: Link or object of each.
        moving: How many of them move.
        own: Pairs among those that move, with what they keep, m.
    """

    solids: list[Solid]
    names: tuple[str, ...]
    moving: int
    own: list[tuple[int, int, float]]


def scene_solids(
    robot: RobotArrays, scene: PlanningScene, extra_margin_m: float, self_margin_m: float
) -> SceneSolids:
    """Solids and moving pairs of a scene, with the margins of ``CollisionWorld``.

    Raises:
        UnknownNameError: A body is attached to a frame that the robot does not have.
    """
    solids, names = list(robot.solids), list(robot.names)
    own = [(int(i), int(j), self_margin_m) for i, j in robot.self_pairs]
    for name, body in scene.attached.items():
        carrier, carrier_T_frame = robot.frame(body.frame)
        held = plain_solid(carrier, carrier_T_frame @ body.frame_T_object, body.body.shape)
        own += [
            (i, len(solids), extra_margin_m)
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
    own: Sequence[tuple[int, int, float]],
    extra_margin_m: float,
) -> Pairs:
    """Flatten a scene's pairs; ``own`` are the moving pairs to keep."""
    body = [solid.body for solid in found.solids]
    levels: dict[tuple[int, int], tuple[int, int]] = {}
    for i, j, _ in own:
        if (body[i], body[j]) not in levels:
            levels[body[i], body[j]] = _meeting(chains, body[i], body[j])
    objects = list(scene.objects.values())
    judged = np.ones((len(objects), found.moving), np.uint8)
    touch = {name: item.touch_links for name, item in scene.attached.items()}
    allowed: dict[str, set[str]] = {}
    for pair in scene.allowed:
        for name in pair:
            allowed.setdefault(name, set()).update(pair - {name})
    for row, item in enumerate(objects):
        unjudged = allowed.get(item.name, set())
        for column in range(found.moving):
            name = found.names[column]
            if name in unjudged or item.name in touch.get(name, frozenset()):
                judged[row, column] = 0
    limb = robot.limb[np.array(body[: found.moving], np.int64)]
    order = np.argsort(limb, kind="stable")
    counts = np.bincount(limb, minlength=int(robot.limb.max()) + 1)
    level = [levels[body[i], body[j]] for i, j, _ in own]
    return Pairs(
        first=np.array([i for i, _, _ in own], np.int64),
        second=np.array([j for _, j, _ in own], np.int64),
        margin=np.array([margin for _, _, margin in own], np.float64),
        first_level=np.array([a for a, _ in level], np.int64),
        second_level=np.array([b for _, b in level], np.int64),
        moving=found.moving,
        object_margin=np.array([item.margin_m + extra_margin_m for item in objects], np.float64),
        judged=judged,
        limb_start=np.concatenate([[0], np.cumsum(counts)]).astype(np.int64),
        limb_solids=order.astype(np.int64),
    )


def _meeting(chains: Chains, first: int, second: int) -> tuple[int, int]:
    """How many joints each of two bodies is away from the body that carries both."""
    a = list(chains.joint[first, : chains.length[first]])
    b = list(chains.joint[second, : chains.length[second]])
    while a and b and a[-1] == b[-1]:
        a.pop()
        b.pop()
    return len(a), len(b)
