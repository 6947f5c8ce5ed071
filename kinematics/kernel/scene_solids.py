"""What a scene adds to a robot: what it holds, what is around, and which of them may touch."""

from __future__ import annotations

import functools
from collections.abc import Iterable, Mapping
from typing import NamedTuple

import numpy as np

from kinematics.arrays import Array, Indices
from kinematics.distance.solids import (
    Solid,
    Solids,
    flatten,
    half_extents_m,
    in_rows_from,
    plain_solids,
    shape_solids,
)
from kinematics.kernel.chains import with_solids
from kinematics.kernel.packing import SCENE_ROWS, SCENE_SOLIDS, Block, block
from kinematics.kernel.pairs import OwnPairs, carriers_of, joined
from kinematics.kernel.robot_arrays import RobotAlone, RobotArrays, carried
from kinematics.model.tree import WORLD
from kinematics.scene.planning_scene import PlanningScene, SceneObject


class SceneSolids(NamedTuple):
    """The solids of a robot, of what it holds and of the scene around it, ready for the collision judge.

    Attributes:
        names: Link or object of each solid: the robot's, what it holds, then the objects. Of what has parts,
            each part is one.
        moves: The robot with what it holds.
        object_margin: What everything keeps from each object, shape (objects,), m.
        judged: 1 where a moving solid is judged against an object, shape (objects, moving).
        vertices: Of the hulls that are not the robot's, shape (n, 3), m.
        laid_out: Solids but the robot's hulls, and pairs of what moves with what is around, ready for the
            compiled code.
    """

    names: tuple[str, ...]
    moves: RobotAlone
    object_margin: Array
    judged: Indices
    vertices: Array
    laid_out: Block


# By so much a box is larger than it has to be: rounding in coordinates of some metres.
_ROUNDING_M = 1e-9
# Sets of objects whose solids are kept: those of the scenes of one task, with the target and without.
_KEPT = 8


def scene_solids(
    robot: RobotArrays, alone: RobotAlone, scene: PlanningScene, extra_margin_m: float
) -> SceneSolids:
    """Solids and pairs of a scene, with the margins of ``CollisionWorld``.

    Args:
        robot: The robot.
        alone: The same, in free coordinates.
        scene: What it holds, what is around, and which pairs may touch.
        extra_margin_m: Added to every margin of the scene.

    Raises:
        UnknownNameError: A body is attached to a frame that the robot does not have.
    """
    held = [
        solid
        for item in scene.attached.values()
        for carrier, carrier_T_frame in (robot.frame(item.frame),)
        for solid in shape_solids(carrier, carrier_T_frame @ item.frame_T_object, item.body.shape)
    ]
    moves = _holding(robot, alone, scene, held, extra_margin_m) if held else alone
    around = _around(_Things(tuple(scene.objects.values())))
    others = _behind(robot.flat, (flatten(held), around.solids) if held else (around.solids,))
    every = (robot.flat, *others)
    solids = [tuple(getattr(part, name) for part in every) for name in SCENE_SOLIDS]
    margin = around.margin_m + extra_margin_m
    judged = judged_in(robot, scene)
    return SceneSolids(
        names=(*robot.names, *_held_names(scene), *around.names),
        moves=moves,
        object_margin=margin,
        judged=judged,
        vertices=np.concatenate([part.points for part in others]),
        laid_out=block([*solids, margin, judged, *around.box], SCENE_ROWS),
    )


def _behind(robot: Solids, others: Iterable[Solids]) -> list[Solids]:
    """The same solids whose vertices come behind the robot's, and behind each other's."""
    first_row, moved = len(robot.points), []
    for part in others:
        moved.append(in_rows_from(part, first_row) if len(part.points) else part)
        first_row += len(part.points)
    return moved


def _held_names(scene: PlanningScene) -> list[str]:
    """The name of each solid that is held."""
    return [name for name, item in scene.attached.items() for _ in range(_count(item.body))]


def _count(item: SceneObject) -> int:
    """How many solids a thing is."""
    return 1 if item.shape.parts is None else len(item.shape.parts.ends)


def judged_in(robot: RobotArrays, scene: PlanningScene) -> Indices:
    """1 where a moving solid is judged against an object, shape (objects, moving)."""
    rows_of, rows = _numbered(scene.objects, 0)
    held, moving = _numbered({name: item.body for name, item in scene.attached.items()}, len(robot.names))
    judged = np.ones((rows, moving), np.int64)
    for pair in scene.allowed:
        for thing in pair & rows_of.keys():
            for other in pair - {thing}:
                judged[rows_of[thing], _numbers(robot, held, other)] = 0
    for name, item in scene.attached.items():
        for thing in item.touch_links & rows_of.keys():
            judged[rows_of[thing], held[name]] = 0
    return judged


def _numbered(things: Mapping[str, SceneObject], first: int) -> tuple[dict[str, slice], int]:
    """The numbers of each thing's solids, and the one behind the last."""
    numbers: dict[str, slice] = {}
    for name, item in things.items():
        last = first + _count(item)
        numbers[name] = slice(first, last)
        first = last
    return numbers, first


def _numbers(robot: RobotArrays, held: Mapping[str, slice], name: str) -> list[int]:
    """The moving solids of a name."""
    own = held.get(name)
    return [*robot.solids_of.get(name, ()), *(() if own is None else range(own.start, own.stop))]


class _Around(NamedTuple):
    """Objects as solids; ``margin_m`` and ``box`` as in ``Pairs``, the box's low and high corners."""

    names: tuple[str, ...]
    solids: Solids
    margin_m: Array
    box: tuple[Array, Array]


class _Things:
    """Objects by their identity: as values they cannot be compared cheaply."""

    def __init__(self, things: tuple[SceneObject, ...]) -> None:
        self.things = things
        self._key = tuple(map(id, things))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Things) and self._key == other._key

    def __hash__(self) -> int:
        return hash(self._key)


@functools.lru_cache(maxsize=_KEPT)
def _around(of: _Things) -> _Around:
    things = of.things
    counts = [_count(item) for item in things]
    if all(item.shape.parts is None for item in things):
        poses = np.array([item.world_T_object for item in things], np.float64).reshape(-1, 4, 4)
        solids = plain_solids(WORLD, poses, [item.shape for item in things])
    else:
        solids = flatten(
            [solid for item in things for solid in shape_solids(WORLD, item.world_T_object, item.shape)]
        )
    centre, half = solids.centre, half_extents_m(solids) + _ROUNDING_M
    margin_m = np.repeat(np.array([item.margin_m for item in things], np.float64), counts)
    names = tuple(item.name for item, count in zip(things, counts, strict=True) for _ in range(count))
    return _Around(names, solids, margin_m, ((centre - half).T, (centre + half).T))


def _holding(
    robot: RobotArrays,
    alone: RobotAlone,
    scene: PlanningScene,
    held: list[Solid],
    margin_m: float,
) -> RobotAlone:
    """The robot with what it holds; kept for the same things in the same places of a hand."""
    key = (
        margin_m,
        *((name, item.touch_links) for name, item in scene.attached.items()),
        *((solid.body, solid.centre.tobytes(), solid.radius_m) for solid in held),
    )
    touching = frozenset(pair for pair in scene.allowed if not pair.isdisjoint(scene.attached))
    found = alone.holding.pop((key, touching), None) or _made_holding(robot, alone, scene, held, margin_m)
    alone.holding[key, touching] = found
    while len(alone.holding) > _KEPT:
        alone.holding.pop(next(iter(alone.holding)))
    return found


def _made_holding(
    robot: RobotArrays, alone: RobotAlone, scene: PlanningScene, held: list[Solid], margin_m: float
) -> RobotAlone:
    names = [*robot.names, *_held_names(scene)]
    body = np.array([*robot.body_of, *(solid.body for solid in held)], np.int64)
    own = alone.own
    for number, name in enumerate(names[len(robot.names) :], len(robot.names)):
        may_touch = scene.attached[name].touch_links | {
            other for pair in scene.allowed if name in pair for other in pair if other != name
        }
        apart = [i for i in range(number) if body[i] != body[number] and names[i] not in may_touch]
        own = joined(own, _held_apart(alone, body, np.array(apart, np.int64), number, margin_m))
    chains = with_solids(alone.chains, held)
    carriers = carriers_of(robot.limb, body.tolist())
    return RobotAlone(chains, own, carriers, carried(chains, own, carriers), alone.levels, {})


def _held_apart(alone: RobotAlone, body: Indices, apart: Indices, number: int, margin_m: float) -> OwnPairs:
    """Pairs of one held solid with others, in groups by what carries those."""
    carrier = int(body[number])
    bodies, first_at, group = np.unique(body[apart], return_index=True, return_inverse=True)
    rank = np.argsort(np.argsort(first_at))
    ordered = np.argsort(rank[group], kind="stable")
    bodies = bodies[np.argsort(first_at)]
    sizes = np.bincount(rank[group], minlength=len(bodies))
    levels = np.array([alone.levels_of(int(b), carrier) for b in bodies], np.int64).reshape(-1, 2)
    count = len(apart)
    return OwnPairs(
        first=apart[ordered],
        second=np.full(count, number, np.int64),
        margin=np.full(count, margin_m),
        group=np.repeat(np.arange(len(bodies)), sizes).astype(np.int64),
        group_first=bodies.astype(np.int64),
        group_second=np.full(len(bodies), carrier, np.int64),
        first_level=np.ascontiguousarray(levels[:, 0]),
        second_level=np.ascontiguousarray(levels[:, 1]),
        group_margin=np.full(len(bodies), margin_m),
        group_start=np.concatenate([[0], np.cumsum(sizes)]).astype(np.int64),
    )
