"""Which solids must stay apart, by how much, and how fast they can approach each other."""

from __future__ import annotations

import functools
from collections.abc import Callable, Hashable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array
from kinematics.checking.kinematics import BASE, WORLD, BatchedKinematics
from kinematics.checking.solids import Solid, robot_solids, shape_solids
from kinematics.model.robot_model import RobotModel
from kinematics.motion.verdict import FindingKind
from kinematics.scene.planning_scene import FLOOR, PlanningScene, SceneObject, floor

Indices = NDArray[np.intp]

# rows of a rate: the base's path and turn, then the hinges; a hinge's row is its body's index
_BASE_PATH, _BASE_TURN = 0, 1
# what is not the robot alone: by whether something that it holds is one of the two
_BETWEEN = np.array([FindingKind.SCENE_COLLISION, FindingKind.HELD_OBJECT_COLLISION], dtype=object)
# Layouts that are kept: those of the scenes of one task, before, with the object in the hand, and after.
_KEPT = 8


@dataclass(frozen=True, slots=True, eq=False)
class PairLayout:
    """Which pairs a check judges, wherever things are and whatever their size.

    All of the robot's own pairs come first: no scene says which of its links may touch.

    Attributes:
        first, second: Indices of all pairs' solids, shape (p,).
        row: For each pair after the robot's own, the index of its solid that is not the robot's, among those
            that are not.
        kinds: What a pair's contact is called.
    """

    first: Indices
    second: Indices
    row: Indices
    kinds: tuple[FindingKind, ...]


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
        self._self_index = np.array(self._self_pairs, dtype=np.intp).reshape(-1, 2)
        self._solids_of: dict[str, list[int]] = {}
        for number, solid in enumerate(self.robot):
            self._solids_of.setdefault(solid.name, []).append(number)
        self._robot_rates: dict[tuple[int, int], Array] = {}
        self._meetings: dict[tuple[int, int], int] = {}
        self._last: tuple[PlanningScene, Pairs] | None = None
        self._layouts: dict[Hashable, PairLayout] = {}
        self._floor = floor()
        self._known: dict[int, tuple[SceneObject, list[Solid]]] = {}
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
        held: list[Solid] = []
        for body in scene.attached.values():
            frame = self._model.pin.frames[self._model.frame_id(body.frame)]
            joint_T_object = np.array(frame.placement.homogeneous) @ body.frame_T_object
            carrier, shape = int(frame.parentJoint), body.body.shape
            held += shape_solids(body.body.name, carrier, joint_T_object, shape, self._kinematics)
        # looks tell of the same things in other orders
        things = sorted(scene.objects.values(), key=lambda item: item.name)
        if FLOOR not in scene.objects:
            things.append(self._floor)
        around = self._around(things)
        solids = (*self.robot, *held, *(solid for some in around for solid in some))
        layout = self._layout(scene, [solid.name for solid in solids[len(self.robot) :]], len(held))
        counts = [len(some) for some in around]
        margins_m = np.concatenate(
            [np.zeros(len(held)), np.repeat([item.margin_m for item in things], counts)]
        )
        return Pairs(
            solids,
            layout.first,
            layout.second,
            np.concatenate([np.zeros(len(self._self_pairs)), margins_m[layout.row]]),
            layout.kinds,
            functools.cache(lambda: self._every_rate(solids, layout)),
        )

    def _layout(self, scene: PlanningScene, names: Sequence[str], held: int) -> PairLayout:
        """Which pairs are judged; kept, as most scenes of a task differ in where things are alone.

        Args:
            scene: What may touch.
            names: Of the solids that are not the robot's: as many as are held, then the others.
            held: How many are held.
        """
        touching = tuple((item.body.name, item.touch_links) for item in scene.attached.values())
        key = tuple(names), touching, scene.allowed
        known = self._layouts.pop(key, None) or self._laid_out(scene, names, held)
        # behind those that were not asked about for longer
        self._layouts[key] = known
        while len(self._layouts) > _KEPT:
            self._layouts.pop(next(iter(self._layouts)))
        return known

    def _laid_out(self, scene: PlanningScene, names: Sequence[str], held: int) -> PairLayout:
        touch_links = {body.body.name: body.touch_links for body in scene.attached.values()}
        first_held, first_world = len(self.robot), len(self.robot) + held
        may_touch: dict[str, set[str]] = {}
        for pair in scene.allowed:
            for name in pair:
                may_touch.setdefault(name, set()).update(pair)
        solids_of = {name: list(numbers) for name, numbers in self._solids_of.items()}
        for number, name in enumerate(names[:held], first_held):
            solids_of.setdefault(name, []).append(number)
        # which moving solids each of the others has to stay apart from
        apart = np.ones((len(names), first_world), dtype=bool)
        for row, name in enumerate(names):
            free = set(may_touch.get(name, ()))
            if row < held:
                # its other parts go with it
                free |= {*touch_links[name], name}
                apart[row, first_held + row :] = False
            elif name == FLOOR:
                free |= self._sole_links
            for other in free & solids_of.keys():
                apart[row, solids_of[other]] = False
        row_of, those = np.nonzero(apart)
        with_held = (row_of < held) | (those >= first_held)
        kinds = [FindingKind.SELF_COLLISION] * len(self._self_pairs) + _BETWEEN[
            with_held.astype(np.intp)
        ].tolist()
        return PairLayout(
            first=np.concatenate([self._self_index[:, 0], those]),
            second=np.concatenate([self._self_index[:, 1], row_of + first_held]),
            row=row_of,
            kinds=tuple(kinds),
        )

    def _around(self, things: Sequence[SceneObject]) -> list[list[Solid]]:
        """Solids of each object; those of the scene before are kept: scenes of a task share most of them."""
        before, self._known = self._known, {}
        for item in things:
            known = before.get(id(item))
            if known is None or known[0] is not item:
                known = (
                    item,
                    shape_solids(item.name, WORLD, item.world_T_object, item.shape, self._kinematics),
                )
            self._known[id(item)] = known
        return [self._known[id(item)][1] for item in things]

    def _every_rate(self, solids: Sequence[Solid], layout: PairLayout) -> Array:
        count = len(self._self_pairs)
        more = zip(layout.first[count:].tolist(), layout.second[count:].tolist(), strict=True)
        return np.hstack([self._self_rate, self._rates(solids, list(more))])

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
