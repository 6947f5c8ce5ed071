"""Collision over the whole of a trajectory, by the compiled certificate; contacts measured by Coal."""

from __future__ import annotations

from collections.abc import Sequence

import coal
import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array, as_float64
from kinematics.checking.certificate import Limbs, PairList, certify
from kinematics.checking.coal_certificate import CollisionCheck
from kinematics.checking.compiled_course import Course, running_lengths
from kinematics.checking.compiled_kinematics import CompiledKinematics
from kinematics.checking.kinematics import WORLD
from kinematics.checking.nearest_points import measured, touching_place
from kinematics.checking.pairs import Pairs
from kinematics.checking.settings import CheckSettings
from kinematics.checking.solids import Solid
from kinematics.checking.timeline import Timeline
from kinematics.compiled.loose_arrays import in_one_piece
from kinematics.distance import solids as kernel
from kinematics.distance.link_solids import link_solid
from kinematics.motion.verdict import Finding

_MOST_CUTS = 100
# A contact's depth is the deepest of this many looks after it, and of as many around the deepest.
_DEPTH_LOOKS = 16
# So much may Coal's distance and the kernel's depart from each other where both say touching.
_AGREEMENT_M = 1e-5


class ContactFinder:
    """Finds contacts of one robot; what depends on the robot alone is prepared once."""

    def __init__(
        self, kinematics: CompiledKinematics, robot: Sequence[Solid], settings: CheckSettings
    ) -> None:
        """Prepare.

        Args:
            kinematics: Of the robot.
            robot: Its solids, with which those of all pairs begin.
            settings: Tolerances.
        """
        self._kinematics = kinematics
        self._settings = settings
        self._chains = [kinematics.chain(body) for body in range(kinematics.count)]
        levels = np.array([[_levels(one, other) for other in self._chains] for one in self._chains], np.int64)
        self._first_level, self._second_level = levels[..., 0], levels[..., 1]
        self._own = len(robot)
        self._robot = (self._limbs(robot), self._flat(robot))
        self._last: tuple[Pairs, Limbs, kernel.Solids, PairList] | None = None

    def findings(self, timeline: Timeline, pairs: Pairs, jumps_s: Array) -> tuple[list[Finding], float]:
        """Every pair that touches, at the first instant at which it does.

        Args:
            timeline: The motion.
            pairs: What must not touch.
            jumps_s: Beginnings and ends of segments that are no motion, shape (n, 2): findings
                already, they are looked at but not refined.

        Returns:
            The findings, and the smallest distance that was computed, in m.
        """
        limbs, solids, listed = self._arrays(pairs)
        contact = np.full(len(pairs.first), np.inf)
        least = np.array([np.inf])
        inside = jumps_s[(jumps_s > 0.0) & (jumps_s < timeline.duration_s)]
        course = _course(timeline)
        cuts = min(_MOST_CUTS, max(1, int(np.ceil(course.so_far[-1].max() / self._settings.cut_rad))))
        links, jumps = self._kinematics.links, as_float64(jumps_s)
        in_one_piece(course, links, limbs, solids, listed, jumps)
        certify(
            course,
            links,
            limbs,
            solids,
            listed,
            np.unique(np.concatenate([np.linspace(0.0, timeline.duration_s, cuts + 1), inside])),
            jumps,
            self._settings.collision_m,
            contact,
            least,
        )
        touching = np.flatnonzero(np.isfinite(contact))
        findings = self._measured(timeline, pairs, touching, contact, jumps_s) if len(touching) else []
        return findings, float(least[0])

    def _measured(
        self, timeline: Timeline, pairs: Pairs, touching: NDArray[np.intp], contact: Array, jumps_s: Array
    ) -> list[Finding]:
        """Coal says how deep contacts are; where it sees none, its own certificate decides."""
        findings, doubted = [], []
        looks = np.linspace(contact[touching], timeline.duration_s, _DEPTH_LOOKS + 1, axis=1)
        coarse = self._distances(timeline, pairs, touching, looks)
        # between the neighbours of the deepest look
        deepest = coarse.argmin(axis=1)
        rows = np.arange(len(touching))
        before = looks[rows, np.maximum(deepest - 1, 0)]
        after = looks[rows, np.minimum(deepest + 1, _DEPTH_LOOKS)]
        fine = self._distances(
            timeline, pairs, touching, np.linspace(before, after, _DEPTH_LOOKS + 1, axis=1)
        )
        value = np.minimum(coarse.min(axis=1), fine.min(axis=1))
        for row, pair in enumerate(touching):
            limit = float(pairs.clearance_m[pair])
            touching_m = limit + self._settings.spare_m + 2.0 * self._settings.collision_m
            if coarse[row, 0] > touching_m + _AGREEMENT_M:
                doubted.append(pair)
                continue
            names = tuple(pairs.solids[int(side[pair])].name for side in (pairs.first, pairs.second))
            t_s = float(contact[pair])
            two = [pairs.solids[int(side[pair])] for side in (pairs.first, pairs.second)]
            place_m = touching_place(self._kinematics, timeline, two, t_s)
            findings.append(Finding(pairs.kinds[pair], t_s, names, float(value[row]), limit, place_m))
        if doubted:
            some = pairs.only(np.array(doubted, np.intp))
            findings += CollisionCheck(self._kinematics, timeline, some, self._settings, jumps_s).findings()
        return findings

    def _distances(
        self, timeline: Timeline, pairs: Pairs, touching: NDArray[np.intp], times_s: Array
    ) -> Array:
        """Coal's signed distances of some pairs, each at times of its own, shape of ``times_s``."""
        placed = self._kinematics.poses(timeline.at(times_s.ravel()))
        found = np.empty(times_s.shape)
        for row, pair in enumerate(touching):
            two = [pairs.solids[int(side[pair])] for side in (pairs.first, pairs.second)]
            function = coal.ComputeDistance(two[0].geometry, two[1].geometry)
            for column in range(times_s.shape[1]):
                at = row * times_s.shape[1] + column
                found[row, column] = measured(function, two, placed, at)[0]
        return found

    def _arrays(self, pairs: Pairs) -> tuple[Limbs, kernel.Solids, PairList]:
        if self._last is None or self._last[0] is not pairs:
            limbs, solids, rest = *self._robot, pairs.solids[self._own :]
            if rest:
                held = [solid for solid in rest if solid.body != WORLD]
                around = rest[len(held) :]
                solids = kernel.with_more(solids, *([_loose(held)] if held else []), _loose(around))
                still = np.zeros((len(around), limbs.body.shape[1]))
                nothing = Limbs(still.astype(np.int64), still, np.zeros(len(around), np.int64))
                all_limbs = [limbs, *([self._limbs(held)] if held else []), nothing]
                limbs = Limbs(*(np.concatenate(part) for part in zip(*all_limbs, strict=True)))
            bodies = solids.body[pairs.first], solids.body[pairs.second]
            listed = PairList(
                pairs.first.astype(np.int64, copy=False),
                pairs.second.astype(np.int64, copy=False),
                self._first_level[bodies],
                self._second_level[bodies],
                pairs.clearance_m + self._settings.spare_m,
            )
            self._last = (pairs, limbs, solids, listed)
        return self._last[1:]

    def _limbs(self, solids: Sequence[Solid]) -> Limbs:
        depth = max(len(chain) for chain in self._chains)
        body, reach = np.zeros((len(solids), depth), np.int64), np.zeros((len(solids), depth))
        for k, solid in enumerate(solids):
            chain = self._chains[solid.body]
            body[k, : len(chain)] = chain
            reach[k, : len(chain)] = self._kinematics.reaches(solid.body, solid.reach_m, solid.axis_reach_m)
        return Limbs(body, reach, np.array([len(self._chains[solid.body]) for solid in solids], np.int64))

    @staticmethod
    def _flat(solids: Sequence[Solid]) -> kernel.Solids:
        return kernel.flatten(
            [
                kernel.plain_solid(solid.body, solid.body_T_solid, solid.shape)
                if solid.shape is not None
                else link_solid(solid.body, solid.body_T_solid, solid.geometry)
                for solid in solids
            ]
        )


def _loose(solids: Sequence[Solid]) -> kernel.Solids:
    """Solids that are not the robot's: objects, parts of them, furniture."""
    shapes = [solid.shape for solid in solids if solid.shape is not None]
    if len(shapes) == len(solids) and all(solid.body == WORLD for solid in solids):
        poses = np.array([solid.body_T_solid for solid in solids]).reshape(-1, 4, 4)
        return kernel.plain_solids(WORLD, poses, shapes)
    return kernel.flatten(
        [
            kernel.plain_solid(solid.body, solid.body_T_solid, solid.shape)
            if solid.shape is not None
            else kernel.hull_of_few(solid.body, _corners(solid))
            for solid in solids
        ]
    )


def _corners(solid: Solid) -> Array:
    """Corners of a hull in its body's frame, shape (n, 3)."""
    pose = solid.body_T_solid
    return np.asarray(solid.geometry.points() @ pose[:3, :3].T + pose[:3, 3])


def _course(timeline: Timeline) -> Course:
    t_s, values, rates, quaternions = (as_float64(array) for array in timeline.arrays())
    so_far = np.empty((len(t_s), values.shape[1] - 1))
    running_lengths(t_s, values, rates, quaternions, so_far)
    return Course(t_s, values, rates, quaternions, so_far)


def _levels(one: list[int], other: list[int]) -> tuple[int, int]:
    """How many bodies are on each of two chains to the base before they meet."""
    shared = set(one) & set(other)
    return len(one) - len(shared), len(other) - len(shared)
