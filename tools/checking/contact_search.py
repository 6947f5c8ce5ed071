"""When solids touch during a motion, to half a millisecond and, where they come near, 0.2 mm.

Everything is looked at on that grid but what cannot matter: between two looks a pair cannot touch whose
distances there add up to more than it can move, and cannot come nearer than the half of what is left.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array
from kinematics.model.robot_model import RobotModel
from tools.checking.farthest import Farthest
from tools.checking.solid_world import SolidWorld

Pairs = NDArray[np.intp]

STEP_S = 0.0005
STEP_M = 0.0002
# Steps between two looks at what may come near.
STRIDE = 40
_MOST_PARTS = 50


@dataclass
class Contact:
    """One pair that touches: when for the first and the last time, s, and how deep, m."""

    first_s: float
    last_s: float
    depth_m: float


@dataclass(frozen=True)
class _Grid:
    """Instants that may be looked at, with what has been travelled until each."""

    times_s: Array
    rows: Array
    gone: Array


@dataclass
class ContactSearch:
    """One motion in one world.

    Attributes:
        motion: Configurations, shape (n, nq), by times, shape (n,).
        duration_s: Of the motion.
        contacts: What was found, by number of the pair.
        least_m: Smallest gap of a pair that moves, right to 0.2 mm.
    """

    model: RobotModel
    world: SolidWorld
    motion: Callable[[Array], Array]
    duration_s: float
    contacts: dict[int, Contact] = field(default_factory=dict)
    least_m: float = np.inf

    def __post_init__(self) -> None:
        self._farthest = Farthest(self.model, self.world)
        count = int(np.ceil(self.duration_s / STEP_S))
        grid = self._grid(np.linspace(0.0, self.duration_s, count + 1))
        gaps = self._look(grid, 0, np.arange(len(self.world.names)), counts=False)
        moving = self._farthest.moving(grid.gone[-1])
        for pair in set(self.contacts) - set(moving.tolist()):
            self.contacts[pair].last_s = self.duration_s
        if len(moving):
            self.least_m = float(gaps[moving].min())
            self._follow(grid, moving, gaps[moving])

    def _grid(self, times_s: Array) -> _Grid:
        rows = self.motion(times_s)
        return _Grid(times_s, rows, self._farthest.travelled(rows))

    def _follow(self, grid: _Grid, pairs: Pairs, gaps: Array) -> None:
        """Go along the motion, looking at each pair before it could touch, and between where it could."""
        last = len(grid.times_s) - 1
        looks = np.append(np.arange(0, last, STRIDE), last)
        strides_m = self._farthest.apart_m(np.diff(grid.gone[looks], axis=0).T, pairs).T
        # what no pair can be nearer than before the next look
        left = gaps - strides_m[0]
        at = np.zeros(len(pairs), np.intp)
        for number, k in enumerate(looks[1:].tolist(), start=1):
            due = np.ones(len(pairs), bool)
            if k < last:
                left -= strides_m[number]
                due = left < max(0.0, self.least_m)
            chosen = np.flatnonzero(due)
            if not len(chosen):
                continue
            found = self._look(grid, k, pairs[chosen])
            for since in np.unique(at[chosen]).tolist():
                part = at[chosen] == since
                which = chosen[part]
                self._between(grid, (since, k), pairs[which], gaps[which], found[part])
            at[chosen], gaps[chosen] = k, found
            if k < last:
                left[chosen] = found - strides_m[number][chosen]

    def _between(self, grid: _Grid, ends: tuple[int, int], pairs: Pairs, first: Array, last: Array) -> None:
        """Bisect an interval for those pairs that could touch in it, or be nearer than any was."""
        waiting = [(*ends, pairs, first, last)]
        while waiting:
            i, j, pairs, first, last = waiting.pop()
            matters = self._matters(grid, i, j, pairs, first, last)
            if not matters.any():
                continue
            pairs, first, last = pairs[matters], first[matters], last[matters]
            if j - i == 1:
                self._finer(grid, i, pairs, first, last)
                continue
            middle = (i + j) // 2
            found = self._look(grid, middle, pairs)
            waiting += [(middle, j, pairs, found, last), (i, middle, pairs, first, found)]

    def _matters(
        self, grid: _Grid, i: int, j: int, pairs: Pairs, first: Array, last: Array
    ) -> NDArray[np.bool_]:
        most = self._farthest.apart_m(grid.gone[j] - grid.gone[i], pairs)
        least = 0.5 * (first + last - most)
        matters = (least <= 0.0) | (least < self.least_m - STEP_M)
        # touching at both ends, it tells nothing new unless it is deeper between
        for k in np.flatnonzero((first <= 0.0) & (last <= 0.0)):
            known = self.contacts.get(int(pairs[k]))
            matters[k] = known is None or -least[k] > known.depth_m + STEP_M
        return np.asarray(matters)

    def _finer(self, grid: _Grid, i: int, pairs: Pairs, first: Array, last: Array) -> None:
        """Between two steps, 0.2 mm at a time, for what is apart at both."""
        apart = (first > 0.0) & (last > 0.0)
        moved = float(np.abs(grid.rows[i + 1] - grid.rows[i]).sum())
        parts = int(np.clip(moved / STEP_M, 1, _MOST_PARTS))
        if parts == 1 or not apart.any():
            return
        times_s = np.linspace(grid.times_s[i], grid.times_s[i + 1], parts + 1)
        finest = self._grid(times_s)
        self._between(finest, (0, parts), pairs[apart], first[apart], last[apart])

    def _look(self, grid: _Grid, k: int, pairs: Pairs, counts: bool = True) -> Array:
        """Gaps at one instant; what touches is noted."""
        gaps = self.world.gaps(grid.rows[k], pairs)
        for pair, gap in zip(pairs[gaps <= 0.0].tolist(), gaps[gaps <= 0.0].tolist(), strict=True):
            self._note(pair, gap, float(grid.times_s[k]))
        if counts:
            self.least_m = min(self.least_m, float(gaps.min()))
        return gaps

    def _note(self, pair: int, gap: float, t_s: float) -> None:
        if gap == 0.0 and self.world.margins[pair] > 0.0:
            return
        known = self.contacts.setdefault(pair, Contact(t_s, t_s, -gap))
        known.first_s, known.last_s = min(known.first_s, t_s), max(known.last_s, t_s)
        known.depth_m = max(known.depth_m, -gap)
