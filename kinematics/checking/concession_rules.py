"""How much of what a planner asks to be overlooked the checker does overlook: rules of its own.

Distances are the checker's own, by Coal, at the motion's first sample and along it. A concession within
the rules takes a pair out of the judgement or lowers what it has to keep; one beyond them is a finding,
and the pair is judged by the scene. Never conceded: two links of the robot, and two things of the world.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import coal
import numpy as np

from kinematics.arrays import Array
from kinematics.checking.kinematics import WORLD, BatchedKinematics, BodyPoses
from kinematics.checking.pairs import PairBuilder, Pairs
from kinematics.checking.solids import Solid
from kinematics.checking.timeline import Timeline
from kinematics.geometry.shapes import Box
from kinematics.model.robot_model import RobotModel
from kinematics.motion.verdict import Finding, FindingKind
from kinematics.scene.concessions import Concession, ConcessionReason
from kinematics.scene.planning_scene import FLOOR, Pair, PlanningScene

NEAR_AT_START_M = 0.06
"""A pair may keep less than its margin when it starts at no more than this beyond that."""
NEAREST_AT_START_M = 0.006
"""... and something of the robot starts at no more than this beyond it: whoever plans keeps 5 mm in hand."""
LEAST_SHARE, LEAST_LESS_M = 0.5, 0.005
"""Of the nearest distance at the start at least this share is kept, less a reserve and rounding."""
CONTACT_M = 0.006
"""A pair is in contact at the start when it is this near."""
DEEPER_M = 0.01
"""A contact at the start may be believed to become this much deeper: the error of two looks."""
REST_M = 0.001
"""What is at rest comes nearer by no more than this."""
DEEPEST_IN_SUPPORT_M = 0.06
"""A held object may be believed to be this deep in what carries it, which is felt for."""
# Along the motion, at which contacts are looked at: how deep they are changes slowly.
_LOOKS = 17


@dataclass(frozen=True, slots=True)
class Conceded:
    """What is left to judge of a motion, once the concessions that its planner asked for were weighed.

    Attributes:
        scene: The scene, in which the pairs that may touch are allowed.
        lowered: Of each pair that may come nearer but not touch, the distance that it keeps instead of its
            margin, m.
        findings: The concessions that the rules do not grant: each is a defect of the motion.
    """

    scene: PlanningScene
    lowered: dict[Pair, float]
    findings: tuple[Finding, ...]


class ConcessionJudge:
    """Says how much is granted of the concessions that the planner of a motion asks for, for one robot."""

    def __init__(self, model: RobotModel, kinematics: BatchedKinematics, pairs: PairBuilder) -> None:
        self._kinematics, self._pairs = kinematics, pairs
        self._links = frozenset(solid.name for solid in pairs.robot)
        self._hands = [frozenset(gripper.touch_links) for gripper in model.description.grippers.values()]
        self._last: tuple[PlanningScene, frozenset[Pair], PlanningScene] | None = None

    def judge(self, timeline: Timeline, scene: PlanningScene, concessions: Sequence[Concession]) -> Conceded:
        """Take what is within the rules; concessions about things that are not there say nothing."""
        known = self._links | scene.attached.keys() | scene.objects.keys() | {FLOOR}
        asked = [one for one in concessions if one.pair <= known]
        # most of what is asked is granted: its pairs are made at once, and their solids looked at
        wished = frozenset(one.pair for one in asked if one.distance_m is None)
        course = _Course(self._kinematics, timeline, self._pairs.pairs(self._with(scene, wished)))
        nearest = self._nearest(course, scene, asked)
        touching: set[Pair] = set()
        lowered: dict[Pair, float] = {}
        findings = []
        hand = self._hand(asked)
        for one in asked:
            thing = self._thing(one, scene)
            refused = (
                _refusal(one, scene, "")
                if thing is None
                else self._beyond(one, thing, scene, course, nearest, hand)
            )
            if refused is not None:
                findings.append(refused)
            elif one.distance_m is None:
                touching.add(one.pair)
            else:
                lowered[one.pair] = min(one.distance_m, lowered.get(one.pair, np.inf))
        return Conceded(self._with(scene, frozenset(touching)), lowered, tuple(findings))

    def lowered(self, pairs: Pairs, lowered: dict[Pair, float]) -> Pairs:
        """The same pairs, of which some keep less."""
        if not lowered:
            return pairs
        clearance_m = pairs.clearance_m.copy()
        numbers: dict[str, list[int]] = {}
        for number, solid in enumerate(pairs.solids):
            numbers.setdefault(solid.name, []).append(number)
        for pair, keeps_m in lowered.items():
            one, other = (numbers[name] for name in pair)
            rows = np.isin(pairs.first, one) & np.isin(pairs.second, other)
            rows |= np.isin(pairs.first, other) & np.isin(pairs.second, one)
            clearance_m[rows] = np.minimum(clearance_m[rows], keeps_m)
        return replace(pairs, clearance_m=clearance_m)

    def _with(self, scene: PlanningScene, touching: frozenset[Pair]) -> PlanningScene:
        """The scene in which pairs may touch; the last one is kept, as pairs are by scene."""
        if not touching:
            return scene
        if self._last is None or self._last[0] is not scene or self._last[1] != touching:
            more = (tuple(sorted(pair)) for pair in touching)
            self._last = scene, touching, scene.allowing((first, second) for first, second in more)
        return self._last[2]

    def _thing(self, one: Concession, scene: PlanningScene) -> str | None:
        """The object of the world in a pair whose other one is a link or held; None when it is no such."""
        moving = [name for name in one.pair if name in self._links or name in scene.attached]
        things = [name for name in one.pair if name in scene.objects or name == FLOOR]
        return things[0] if len(moving) == len(things) == 1 else None

    def _hand(self, asked: Sequence[Concession]) -> frozenset[str]:
        """Links of the one hand that may take hold of something: that of the first such concession."""
        for one in asked:
            if one.reason in (ConcessionReason.GRASPED_OBJECT, ConcessionReason.HANDLE_IN_HAND):
                return next((links for links in self._hands if not links.isdisjoint(one.pair)), frozenset())
        return frozenset()

    def _nearest(
        self, course: _Course, scene: PlanningScene, asked: Sequence[Concession]
    ) -> dict[str, float]:
        """How near each thing is at the start to what is asked to be near to it."""
        nearest: dict[str, float] = {}
        at_start = (ConcessionReason.STARTS_NEAR, ConcessionReason.STARTS_IN_CONTACT)
        for one in asked:
            if one.reason in at_start and (thing := self._thing(one, scene)) is not None:
                nearest[thing] = min(course.at_start_m(one.pair), nearest.get(thing, np.inf))
        return nearest

    def _beyond(
        self,
        one: Concession,
        thing: str,
        scene: PlanningScene,
        course: _Course,
        nearest: dict[str, float],
        hand: frozenset[str],
    ) -> Finding | None:
        """The finding that a concession is, or None when it is within the rules."""
        (moving,) = one.pair - {thing}
        item = scene.objects.get(thing)
        margin_m = 0.0 if item is None else item.margin_m
        movable = item is not None and item.movable
        if (one.distance_m is not None) != (one.reason is ConcessionReason.STARTS_NEAR):
            return _refusal(one, scene, thing)
        match one.reason:
            case ConcessionReason.STARTS_NEAR:
                start_m = course.at_start_m(one.pair)
                if start_m > margin_m + NEAR_AT_START_M:
                    return _finding(one, 0.0, start_m, margin_m + NEAR_AT_START_M)
                if nearest[thing] > margin_m + NEAREST_AT_START_M:
                    return _finding(one, 0.0, nearest[thing], margin_m + NEAREST_AT_START_M)
                least_m = min(margin_m, max(0.0, LEAST_SHARE * nearest[thing] - LEAST_LESS_M))
                keeps_m = one.distance_m if one.distance_m is not None else 0.0
                return None if keeps_m >= least_m else _finding(one, 0.0, keeps_m, least_m)
            case ConcessionReason.STARTS_IN_CONTACT:
                start_m = course.at_start_m(one.pair)
                if not movable:
                    return _refusal(one, scene, thing)
                if start_m > CONTACT_M:
                    return _finding(one, 0.0, start_m, CONTACT_M)
                if moving in scene.attached and start_m < -DEEPER_M:
                    return None  # no two things are in the same place: it is the held one, seen twice
                return course.deeper_than(one, min(0.0, start_m) - DEEPER_M)
            case ConcessionReason.AT_REST:
                return course.deeper_than(one, course.at_start_m(one.pair) - REST_M)
            case ConcessionReason.SUPPORT_OF_HELD_OBJECT:
                if moving not in scene.attached:
                    return _refusal(one, scene, thing)
                return course.deeper_than(one, -DEEPEST_IN_SUPPORT_M)
            case ConcessionReason.GRASPED_OBJECT:
                return None if moving in hand and movable else _refusal(one, scene, thing)
            case ConcessionReason.HANDLE_IN_HAND:
                fixed = thing != FLOOR and not movable
                return None if moving in hand and fixed else _refusal(one, scene, thing)


class _Course:
    """Distances of some pairs along a motion, by Coal."""

    def __init__(self, kinematics: BatchedKinematics, timeline: Timeline, pairs: Pairs) -> None:
        self._kinematics, self._timeline, self._pairs = kinematics, timeline, pairs
        self._numbers: dict[str, list[int]] = {}
        for number, solid in enumerate(pairs.solids):
            self._numbers.setdefault(solid.name, []).append(number)
        self._starts_m: dict[Pair, float] = {}
        self._request = coal.DistanceRequest()
        self._request.enable_signed_distance = True

    def at_start_m(self, pair: Pair) -> float:
        """At the first sample; below 0 where the two are in each other."""
        if pair not in self._starts_m:
            self._starts_m[pair] = float(self._distances(pair, np.zeros(1))[0])
        return self._starts_m[pair]

    def deeper_than(self, one: Concession, least_m: float) -> Finding | None:
        """Whether a pair comes nearer than it may, where it is looked at."""
        looks = np.linspace(0.0, self._timeline.duration_s, _LOOKS)
        distances_m = self._distances(one.pair, looks, least_m)
        beyond = np.flatnonzero(distances_m < least_m)
        if not len(beyond):
            return None
        return _finding(one, float(looks[beyond[0]]), float(distances_m.min()), least_m)

    def _distances(self, pair: Pair, times_s: Array, least_m: float = np.inf) -> Array:
        """Distances at some times, roughly where a ball about one is farther than ``least_m``."""
        first, second = (self._numbers[name] for name in pair)
        solids = self._pairs.solids
        found = np.full(len(times_s), np.inf)
        bodies = frozenset(solids[k].body for k in (*first, *second))
        placed = self._kinematics.poses(self._timeline.at(times_s), bodies)
        result = coal.DistanceResult()
        for i in first:
            for j in second:
                rough_m = np.maximum(
                    _rough_m(placed, solids[i], solids[j]), _rough_m(placed, solids[j], solids[i])
                )
                if least_m < rough_m.min():
                    found = np.minimum(found, rough_m)
                    continue
                function = coal.ComputeDistance(solids[i].geometry, solids[j].geometry)
                ways = zip(_way(placed, solids[i]), _way(placed, solids[j]), strict=True)
                for at, (one, other) in enumerate(ways):
                    result.clear()
                    found[at] = min(found[at], function(one, other, self._request, result))
        return found


def _rough_m(placed: BodyPoses, ball: Solid, box: Solid) -> Array:
    """At least how far a solid's ball is from a box of the world, shape (n,); minus infinity for others."""
    rotation, origin_m = placed.rotation[ball.body], placed.origin_m[ball.body]
    if box.body != WORLD or not isinstance(box.shape, Box):
        return np.full(len(origin_m), -np.inf)
    centres_m = rotation @ ball.centre_m + origin_m
    local_m = (centres_m - box.body_T_solid[:3, 3]) @ box.body_T_solid[:3, :3]
    beyond_m = np.abs(local_m) - 0.5 * np.array(box.shape.size_m)
    outside_m = np.linalg.norm(np.maximum(beyond_m, 0.0), axis=1)
    return np.asarray(outside_m + np.minimum(beyond_m.max(axis=1), 0.0) - ball.radius_m)


def _way(placed: BodyPoses, solid: Solid) -> list[coal.Transform3s]:
    """Where a solid is at some instants."""
    rotation, origin_m = placed.rotation[solid.body], placed.origin_m[solid.body]
    turned = rotation @ solid.body_T_solid[:3, :3]
    moved = rotation @ solid.body_T_solid[:3, 3] + origin_m
    if solid.body == WORLD:
        return [coal.Transform3s(turned[0], moved[0])] * len(turned)
    return [coal.Transform3s(one, other) for one, other in zip(turned, moved, strict=True)]


def _finding(one: Concession, t_s: float, value: float, limit: float) -> Finding:
    return Finding(FindingKind.CONCESSION, t_s, one.names, value, limit)


def _refusal(one: Concession, scene: PlanningScene, thing: str) -> Finding:
    """A concession of a kind that is never made: what was asked, and what the pair has to keep."""
    item = scene.objects.get(thing)
    asked_m = 0.0 if one.distance_m is None else one.distance_m
    return _finding(one, 0.0, asked_m, 0.0 if item is None else item.margin_m)
