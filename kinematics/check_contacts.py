"""Collision over the whole of a trajectory, by the compiled certificate; contacts measured by Coal."""

from __future__ import annotations

import coal
import numpy as np
from numpy.typing import NDArray

from kinematics.check_certificate import Course, Limbs, Links, PairList, certify
from kinematics.check_collision import CollisionCheck
from kinematics.check_kinematics import BatchedKinematics
from kinematics.check_pairs import Pairs
from kinematics.check_settings import CheckSettings
from kinematics.check_solids import Solid
from kinematics.check_timeline import Timeline
from kinematics.kernel import solids as kernel
from kinematics.trajectory import Finding

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

# A contact's depth is the deepest of this many looks after it, and of as many around the deepest.
_DEPTH_LOOKS = 16
# So much may Coal's distance and the kernel's depart from each other where both say touching.
_AGREEMENT_M = 1e-5


class ContactFinder:
    """Finds contacts of one robot; what depends on the robot alone is prepared once."""

    def __init__(self, kinematics: BatchedKinematics, settings: CheckSettings) -> None:
        self._kinematics = kinematics
        self._settings = settings
        self._links = Links(
            parent=np.array(kinematics.parent, np.int64),
            offset=np.ascontiguousarray(kinematics.offset_m),
            axis=np.ascontiguousarray(kinematics.axis),
            fixed=kinematics.fixed,
            sine=kinematics.sine,
            versine=kinematics.versine,
        )
        self._hulls: dict[int, tuple[Solid, kernel.Solid]] = {}
        self._levels: dict[tuple[int, int], tuple[int, int]] = {}
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
        least = np.full(len(pairs.first), np.inf)
        inside = jumps_s[(jumps_s > 0.0) & (jumps_s < timeline.duration_s)]
        certify(
            Course(*timeline.course()),
            self._links,
            limbs,
            solids,
            listed,
            np.unique(np.concatenate([[0.0], inside, [timeline.duration_s]])),
            np.ascontiguousarray(jumps_s),
            self._settings.collision_m,
            contact,
            least,
        )
        touching = np.flatnonzero(np.isfinite(contact))
        findings = self._measured(timeline, pairs, touching, contact, jumps_s) if len(touching) else []
        return findings, float(least.min(initial=np.inf))

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
            if coarse[row, 0] > limit + 2.0 * self._settings.collision_m + _AGREEMENT_M:
                doubted.append(pair)
                continue
            names = tuple(pairs.solids[int(side[pair])].name for side in (pairs.first, pairs.second))
            findings.append(Finding(pairs.kinds[pair], float(contact[pair]), names, float(value[row]), limit))
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
        request = coal.DistanceRequest()
        request.enable_signed_distance = True
        for row, pair in enumerate(touching):
            two = [pairs.solids[int(side[pair])] for side in (pairs.first, pairs.second)]
            function = coal.ComputeDistance(two[0].geometry, two[1].geometry)
            for column in range(times_s.shape[1]):
                at = row * times_s.shape[1] + column
                places = [
                    coal.Transform3s(
                        rotation @ solid.body_T_solid[:3, :3],
                        rotation @ solid.body_T_solid[:3, 3] + placed.origin_m[solid.body, at],
                    )
                    for solid in two
                    for rotation in (placed.rotation[solid.body, at],)
                ]
                found[row, column] = function(places[0], places[1], request, coal.DistanceResult())
        return found

    def _arrays(self, pairs: Pairs) -> tuple[Limbs, kernel.Solids, PairList]:
        if self._last is None or self._last[0] is not pairs:
            chains = [self._kinematics.chain(solid.body) for solid in pairs.solids]
            depth = max(1, max(map(len, chains), default=1))
            body = np.zeros((len(chains), depth), np.int64)
            reach = np.zeros((len(chains), depth))
            for k, chain in enumerate(chains):
                body[k, : len(chain)] = chain
                reach[k, : len(chain)] = self._kinematics.reaches(
                    pairs.solids[k].body, pairs.solids[k].reach_m, pairs.solids[k].axis_reach_m
                )
            limbs = Limbs(body, reach, np.array([len(chain) for chain in chains], np.int64))
            bodies = np.array([solid.body for solid in pairs.solids], np.int64)
            levels = np.array(
                [
                    self._level(int(i), int(j))
                    for i, j in zip(bodies[pairs.first], bodies[pairs.second], strict=True)
                ],
                np.int64,
            ).reshape(-1, 2)
            listed = PairList(
                pairs.first.astype(np.int64),
                pairs.second.astype(np.int64),
                np.ascontiguousarray(levels[:, 0]),
                np.ascontiguousarray(levels[:, 1]),
                pairs.clearance_m,
            )
            solids = kernel.flatten([self._solid(solid) for solid in pairs.solids])
            self._last = (pairs, limbs, solids, listed)
        return self._last[1:]

    def _solid(self, solid: Solid) -> kernel.Solid:
        if solid.shape is not None:
            return kernel.plain_solid(solid.body, solid.body_T_solid, solid.shape)
        known = self._hulls.get(id(solid))
        if known is None:
            known = (solid, kernel.link_solid(solid.body, solid.body_T_solid, solid.geometry))
            self._hulls[id(solid)] = known
        return known[1]

    def _level(self, first: int, second: int) -> tuple[int, int]:
        """How many bodies are between each of two and the one that carries both."""
        if (first, second) not in self._levels:
            one, other = self._kinematics.chain(first), self._kinematics.chain(second)
            shared = set(one) & set(other)
            self._levels[first, second] = (
                len([body for body in one if body not in shared]),
                len([body for body in other if body not in shared]),
            )
        return self._levels[first, second]

