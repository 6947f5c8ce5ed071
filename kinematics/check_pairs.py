"""Which solids must stay apart, by how much, and how fast they can approach each other."""

from __future__ import annotations

import functools
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kinematics.check_kinematics import BASE, WORLD, BatchedKinematics
from kinematics.check_solids import Solid, plain_solid, robot_solids
from kinematics.robot_model import RobotModel
from kinematics.scene import FLOOR, PlanningScene, floor
from kinematics.trajectory import FindingKind

Array = NDArray[np.float64]
Indices = NDArray[np.intp]

# rows of a rate: the base's path and turn, then the hinges; a hinge's row is its body's index
_BASE_PATH, _BASE_TURN = 0, 1


@dataclass(frozen=True, slots=True)
class Pairs:
    """All pairs of solids that one check judges.

    Attributes:
        solids: Every solid of robot, hands and scene.
        first, second: Indices of the pairs' solids, shape (p,).
        clearance_m: Distance that each pair has to keep, shape (p,).
        kinds: What a pair's contact is called.
        rates: Computes ``rate``, which not every check needs.
    """

    solids: tuple[Solid, ...]
    first: Indices
    second: Indices
    clearance_m: Array
    kinds: tuple[FindingKind, ...]
    rates: Callable[[], Array]

    @property
    def rate(self) -> Array:
        """Displacement of one solid relative to the other for one unit of each path length.

        Path lengths are those of ``Timeline.path_lengths``; a bound from above, shape (2 + k, p).
        """
        return self.rates()

    def only(self, some: Indices) -> Pairs:
        """The same for some of the pairs."""
        return Pairs(
            self.solids,
            self.first[some],
            self.second[some],
            self.clearance_m[some],
            tuple(self.kinds[k] for k in some),
            lambda: self.rate[:, some],
        )


class PairBuilder:
    """Makes the pairs of a scene; what depends on the robot alone is prepared once.

    Attributes:
        robot: The robot's solids; those of all pairs begin with them.

    Raises:
        ModelError: A collision geometry of the robot cannot be judged.
    """

    def __init__(self, model: RobotModel, kinematics: BatchedKinematics) -> None:
        self._model = model
        self._kinematics = kinematics
        self.robot = robot_solids(model, kinematics)
        geometry = model.geometry()
        self._self_pairs = [
            (int(pair.first), int(pair.second))
            for pair in geometry.collisionPairs
            if self.robot[pair.first].body != self.robot[pair.second].body
        ]
        self._self_names = [frozenset((self.robot[i].name, self.robot[j].name)) for i, j in self._self_pairs]
        self._own = list(range(len(self._self_pairs)))
        self._robot_rates: dict[tuple[int, int], Array] = {}
        self._meetings: dict[tuple[int, int], int] = {}
        self._last: tuple[PlanningScene, Pairs] | None = None
        self._self_rate = self._rates(self.robot, self._self_pairs)
        self._sole_links = frozenset(sole.link for sole in model.description.soles)
        if model.description.welded:  # what is bolted to the floor stands on it too
            self._sole_links |= {solid.name for solid in self.robot if solid.body == BASE}

    def pairs(self, scene: PlanningScene) -> Pairs:
        """Pairs that may not touch in a scene: robot, held objects, scene objects and the floor."""
        if self._last is None or self._last[0] is not scene:
            self._last = (scene, self._pairs(scene))
        return self._last[1]

    def _pairs(self, scene: PlanningScene) -> Pairs:
        robot, kinematics = self.robot, self._kinematics
        held = []
        for body in scene.attached.values():
            frame = self._model.pin.frames[self._model.frame_id(body.frame)]
            joint_T_object = np.array(frame.placement.homogeneous) @ body.frame_T_object
            held.append(
                plain_solid(
                    body.body.name, int(frame.parentJoint), joint_T_object, body.body.shape, kinematics
                )
            )
        things = list(scene.objects.values())
        if FLOOR not in scene.objects:
            things.append(floor())
        world = [
            plain_solid(item.name, WORLD, item.world_T_object, item.shape, kinematics) for item in things
        ]
        solids = [*robot, *held, *world]
        first_held, first_world = len(robot), len(robot) + len(held)
        names = [solid.name for solid in solids]
        allowed = scene.allowed
        own = [k for k, pair in enumerate(self._self_names) if pair not in allowed] if allowed else self._own
        pairs = [self._self_pairs[k] for k in own]
        clearance = [0.0] * len(pairs)
        kinds = [FindingKind.SELF_COLLISION] * len(pairs)
        others: list[tuple[int, int]] = []
        may_touch: dict[str, set[str]] = {}
        for pair in allowed:
            for name in pair:
                may_touch.setdefault(name, set()).update(pair)
        touching = list(scene.attached.values())
        for i in range(first_held, first_world):
            free = {*touching[i - first_held].touch_links, *may_touch.get(names[i], ())}
            others += [(j, i) for j in range(i) if names[j] not in free]
        clearance += [0.0] * len(others)
        for i in range(first_world, len(solids)):
            free = {*may_touch.get(names[i], ()), *(self._sole_links if names[i] == FLOOR else ())}
            with_it = [(j, i) for j in range(first_world) if names[j] not in free]
            others += with_it
            clearance += [things[i - first_world].margin_m] * len(with_it)
        for j, i in others:
            by_hand = j >= first_held or first_held <= i < first_world
            kinds.append(FindingKind.HELD_OBJECT_COLLISION if by_hand else FindingKind.SCENE_COLLISION)
        index = np.array(pairs + others, dtype=np.intp).reshape(-1, 2)
        return Pairs(
            tuple(solids),
            index[:, 0],
            index[:, 1],
            np.array(clearance),
            tuple(kinds),
            functools.cache(
                lambda: np.hstack([self._self_rate[:, own], self._rates(solids, others)]),
            ),
        )

    def _rates(self, solids: Sequence[Solid], pairs: Sequence[tuple[int, int]]) -> Array:
        if not pairs:
            return np.zeros((self._kinematics.count, 0))
        robot = len(self.robot)
        held_rates: dict[tuple[int, int], Array] = {}
        columns = []
        for i, j in pairs:
            meeting = self._meeting(solids[i].body, solids[j].body)
            for k in (i, j):
                known = self._robot_rates if k < robot else held_rates
                if (k, meeting) not in known:
                    known[k, meeting] = self._reach(solids[k], meeting)
                columns.append(known[k, meeting])
        both = np.array(columns).reshape(len(pairs), 2, -1)
        return np.ascontiguousarray((both[:, 0] + both[:, 1]).T)

    def _meeting(self, first: int, second: int) -> int:
        """The body nearest to both on the way to the world."""
        if WORLD in (first, second):
            return WORLD
        if (first, second) not in self._meetings:
            above = set(self._kinematics.chain(first))
            chain = self._kinematics.chain(second)
            self._meetings[first, second] = next((body for body in chain if body in above), WORLD)
        return self._meetings[first, second]

    def _reach(self, solid: Solid, root: int) -> Array:
        """How far any point of a solid can be from each axis between it and ``root``, shape (2 + k,).

        The base's path carries everything along (1), its turn acts about its origin.
        """
        kinematics = self._kinematics
        rate = np.zeros(kinematics.count)
        reaches = kinematics.reaches(solid.body, solid.reach_m, solid.axis_reach_m)
        for body, reach in zip(kinematics.chain(solid.body), reaches, strict=True):
            if body == root:
                break
            if body == BASE:
                rate[_BASE_PATH], rate[_BASE_TURN] = 1.0, reach
            else:
                rate[body] = reach
        return rate
