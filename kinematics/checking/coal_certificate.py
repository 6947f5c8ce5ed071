"""Collision over the whole of a trajectory, proven between the instants that are looked at.

The motion is cut into cells of time. In the middle of a cell a pair of solids is apart by at least
some distance; within the cell the two approach by no more than the path lengths of the joints
between them allow. Where the first exceeds the second, no instant of the cell can hold a contact.
The distance comes, cheapest first, from bounding balls, from a separating plane found at another
cell, and from Coal. A cell that cannot be proven is split. A pair nearer than
``CheckSettings.collision_m`` beyond its clearance is a finding, so the splitting ends.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import coal
import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array
from kinematics.checking.kinematics import WORLD, BatchedKinematics, BodyPoses
from kinematics.checking.nearest_points import touching_place
from kinematics.checking.pairs import Pairs
from kinematics.checking.settings import CheckSettings
from kinematics.checking.solids import Solid, distance_to_shape
from kinematics.checking.timeline import Timeline
from kinematics.motion.verdict import Finding

Indices = NDArray[np.intp]

Cell = tuple[float, float]
"""Start and end of an interval of time, s."""


_DEPTH_LOOKS = 16


_ROUNDING_S = 1e-9


@dataclass(slots=True)
class _Contact:
    t_s: float
    distance_m: float


@dataclass(slots=True)
class _Level:
    """The cells of one fineness and what is known about them."""

    starts_s: Array
    ends_s: Array
    middles_s: Array
    lengths: Array
    poses: BodyPoses
    transforms: dict[tuple[int, int], coal.Transform3s] = field(default_factory=dict)


class CollisionCheck:
    """One run of the collision check; made for one trajectory in one scene.

    Attributes:
        min_distance_m: Smallest exact distance seen so far; infinite where bounding balls alone proved that
            nothing comes near.
        queries: How many exact distances were computed.
    """

    def __init__(
        self,
        kinematics: BatchedKinematics,
        timeline: Timeline,
        pairs: Pairs,
        settings: CheckSettings,
        jumps_s: Array,
    ) -> None:
        """Prepare.

        Args:
            kinematics: Of the robot.
            timeline: The motion.
            pairs: What must not touch.
            settings: Tolerances.
            jumps_s: Beginnings and ends of segments that are no motion, shape (n, 2): findings
                already, they are looked at but not refined, which could go on for long.
        """
        self._kinematics = kinematics
        self._timeline = timeline
        self._pairs = pairs
        self._clearance_m = pairs.clearance_m + settings.spare_m
        self._settings = settings
        self._jumps_s = jumps_s
        self._contacts: dict[int, _Contact] = {}
        self._request = coal.DistanceRequest()
        self._request.enable_signed_distance = True
        self._functions: dict[int, coal.ComputeDistance] = {}
        self.min_distance_m = float("inf")
        self.queries = 0

    def findings(self) -> list[Finding]:
        """Every pair that touches, at the first instant at which it was seen to."""
        knots = self._timeline.knots(0.5 * self._settings.cell_s)
        level = self._level(knots[:-2:2], knots[2::2])
        every = np.arange(len(level.middles_s))
        open_cells = dict.fromkeys(range(len(self._pairs.first)), every)
        while open_cells:
            unproven = self._judge(level, open_cells)
            level, open_cells = self._split(level, unproven)
        return [
            Finding(
                self._pairs.kinds[pair],
                contact.t_s,
                (self._pairs.solids[self._pairs.first[pair]].name, self._second(pair).name),
                contact.distance_m,
                float(self._pairs.clearance_m[pair]),
                touching_place(self._kinematics, self._timeline, self._two(pair), contact.t_s),
            )
            for pair, contact in self._contacts.items()
        ]

    def _two(self, pair: int) -> tuple[Solid, Solid]:
        return self._pairs.solids[int(self._pairs.first[pair])], self._second(pair)

    def _second(self, pair: int) -> Solid:
        return self._pairs.solids[int(self._pairs.second[pair])]

    def _level(self, starts_s: Array, ends_s: Array) -> _Level:
        """Look at cells, given in order of time and free of overlap, in their middles."""
        middles = 0.5 * (starts_s + ends_s)
        knots = np.union1d(np.concatenate([starts_s, ends_s]), middles)
        halves = self._timeline.path_lengths(knots)
        first = np.searchsorted(knots, starts_s)
        lengths = np.maximum(halves[first], halves[first + 1])
        poses = self._kinematics.poses(self._timeline.at(middles))
        return _Level(starts_s, ends_s, middles, lengths, poses)

    def _split(self, level: _Level, unproven: dict[int, Indices]) -> tuple[_Level, dict[int, Indices]]:
        if len(self._jumps_s):
            begin, end = self._jumps_s.T[:, :, None] + [[[-_ROUNDING_S]], [[_ROUNDING_S]]]
            jumping = ((begin <= level.starts_s) & (level.ends_s <= end)).any(axis=0)
            unproven = {pair: cells[~jumping[cells]] for pair, cells in unproven.items()}
            unproven = {pair: cells for pair, cells in unproven.items() if len(cells)}
        if not unproven:
            return level, {}
        parts = self._settings.subdivision
        cells = np.unique(np.concatenate(list(unproven.values())))
        edges = np.linspace(level.starts_s[cells], level.ends_s[cells], parts + 1, axis=1)
        finer = self._level(edges[:, :-1].ravel(), edges[:, 1:].ravel())
        steps = np.arange(parts)
        return finer, {
            pair: (np.searchsorted(cells, mine)[:, None] * parts + steps).ravel()
            for pair, mine in unproven.items()
        }

    def _judge(self, level: _Level, open_cells: dict[int, Indices]) -> dict[int, Indices]:
        """Prove cells; return those of each pair that remain open."""
        pairs = np.array(list(open_cells), dtype=np.intp)
        used = np.unique(np.concatenate([open_cells[pair] for pair in open_cells]))
        need = level.lengths[used] @ self._pairs.rate[:, pairs] + self._clearance_m[pairs]
        apart = self._ball_distances(level, used, pairs)
        proven = apart > need
        unproven = {}
        for column, pair in enumerate(pairs):
            if proven[:, column].all():
                continue
            mine = open_cells[int(pair)]
            where = np.searchsorted(used, mine)
            keep = ~proven[where, column]
            if keep.any():
                rest = self._judge_pair(level, int(pair), mine[keep], need[where[keep], column])
                if len(rest):
                    unproven[int(pair)] = rest
        return unproven

    def _ball_distances(self, level: _Level, cells: Indices, pairs: Indices) -> Array:
        """Lower bounds from bounding balls, shape (cells, pairs)."""
        solids = self._pairs.solids
        first, second = self._pairs.first[pairs], self._pairs.second[pairs]
        bodies = np.array([solid.body for solid in solids])
        centres = np.array([solid.centre_m for solid in solids])
        radius = np.array([solid.radius_m for solid in solids])
        rotation, origin = level.poses.rotation[:, cells], level.poses.origin_m[:, cells]
        placed = np.empty((len(solids), len(cells), 3))
        needed = np.union1d(first, second)
        placed[needed] = np.matmul(rotation[bodies[needed]], centres[needed][:, None, :, None])[..., 0]
        placed[needed] += origin[bodies[needed]]
        apart = np.empty((len(cells), len(pairs)))
        free = bodies[second] != WORLD
        gap = placed[first[free]] - placed[second[free]]
        distance = np.sqrt(np.einsum("pni,pni->pn", gap, gap))
        apart[:, free] = (distance - (radius[first[free]] + radius[second[free]])[:, None]).T
        for thing in np.unique(second[~free]):
            columns = np.flatnonzero(second == thing)
            solid = solids[thing]
            relative = placed[first[columns]] - solid.body_T_solid[:3, 3]
            if solid.shape is not None:
                inside = distance_to_shape(solid.shape, relative @ solid.body_T_solid[:3, :3])
                apart[:, columns] = (inside - radius[first[columns]][:, None]).T
        return apart

    def _judge_pair(self, level: _Level, pair: int, cells: Indices, need: Array) -> Indices:
        """Prove what planes and exact distances can prove; return the cells that must be split."""
        unproven: list[int] = []
        limit = self._clearance_m[pair] + self._settings.collision_m
        contact = self._contacts.get(pair)
        if contact is not None:
            keep = level.starts_s[cells] < contact.t_s
            cells, need = cells[keep], need[keep]
        while len(cells):
            pick = len(cells) // 2
            distance, normal = self._exact(level, pair, int(cells[pick]))
            if distance < limit:
                t_s = float(level.middles_s[cells[pick]])
                before = self._contacts.get(pair)
                if before is None:
                    distance = min(distance, self._deepest(level, pair, cells[pick + 1 :]))
                else:
                    distance = min(distance, before.distance_m)
                self._contacts[pair] = _Contact(t_s, distance)
                # the cell itself may hold an earlier contact: split it too
                if need[pick] - self._clearance_m[pair] > self._settings.collision_m:
                    unproven.append(int(cells[pick]))
                cells, need = cells[:pick], need[:pick]
                continue
            proven = np.zeros(len(cells), dtype=np.bool_)
            if distance > need[pick]:
                proven = self._plane_distances(level, pair, cells, normal, int(cells[pick])) > need
            else:
                unproven.append(int(cells[pick]))
            proven[pick] = True
            cells, need = cells[~proven], need[~proven]
        contact = self._contacts.get(pair)
        rest = np.array(sorted(unproven), dtype=np.intp)
        return rest if contact is None else rest[level.starts_s[rest] < contact.t_s]

    def _deepest(self, level: _Level, pair: int, cells: Indices) -> float:
        """Smallest distance at some of the cells after a first contact, to tell how bad it is."""
        some = cells[:: max(1, len(cells) // _DEPTH_LOOKS)]
        return min((self._exact(level, pair, int(cell))[0] for cell in some), default=float("inf"))

    def _exact(self, level: _Level, pair: int, cell: int) -> tuple[float, Array]:
        """Signed distance of a pair, and the world's direction from the first to the second."""
        function = self._functions.get(pair)
        i, j = int(self._pairs.first[pair]), int(self._pairs.second[pair])
        if function is None:
            function = coal.ComputeDistance(self._pairs.solids[i].geometry, self._pairs.solids[j].geometry)
            self._functions[pair] = function
        result = coal.DistanceResult()
        distance = float(
            function(self._placed(level, i, cell), self._placed(level, j, cell), self._request, result)
        )
        self.queries += 1
        self.min_distance_m = min(self.min_distance_m, distance)
        return distance, np.array(result.normal)

    def _placed(self, level: _Level, index: int, cell: int) -> coal.Transform3s:
        known = level.transforms.get((index, cell))
        if known is None:
            solid = self._pairs.solids[index]
            rotation = level.poses.rotation[solid.body, cell]
            local = solid.body_T_solid
            known = coal.Transform3s(
                rotation @ local[:3, :3], rotation @ local[:3, 3] + level.poses.origin_m[solid.body, cell]
            )
            level.transforms[index, cell] = known
        return known

    def _plane_distances(self, level: _Level, pair: int, cells: Indices, normal: Array, seen: int) -> Array:
        """Lower bounds at several cells from a plane that separated the pair at the cell ``seen``.

        The plane is carried along by the solid with more points, whose support is then one number.
        """
        first, second = self._pairs.solids[self._pairs.first[pair]], self._second(pair)
        carrier, other, direction = first, second, normal
        if second.detail > first.detail:
            carrier, other, direction = second, first, -normal
        rotation, origin = level.poses.rotation, level.poses.origin_m
        in_body = rotation[carrier.body, seen].T @ direction
        local = carrier.body_T_solid
        extent = carrier.support((local[:3, :3].T @ in_body)[None])[0] + in_body @ local[:3, 3]
        directions = rotation[carrier.body, cells] @ in_body
        in_other = np.einsum("nij,ni->nj", rotation[other.body, cells], directions)
        place = other.body_T_solid
        near = -other.support(-in_other @ place[:3, :3]) + in_other @ place[:3, 3]
        between = origin[other.body, cells] - origin[carrier.body, cells]
        return np.asarray(near - extent + np.einsum("ni,ni->n", directions, between))
