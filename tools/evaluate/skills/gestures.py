"""Suites of gestures: wave, point at, look at."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import partial

import numpy as np

from executive.session.assembly import Assembly
from executive.session.task_result import TaskResult
from kinematics.arrays import Array
from kinematics.ik.arm_frames import beside_ray_m, link_moved_by
from kinematics.model.robot_description import Hand
from robots.scenes.scene_description import Person, SceneDescription
from tools.evaluate.skills import rooms
from tools.evaluate.skills.suite import SkillSuite, Trial, Verdict
from trees.events import NodeChanged
from trees.tasks import LookAtTask, ObjectDescription, PointAtTask, WaveTask

SWING_M = 0.15
SWINGS = 3
FACING_RAD = math.radians(20.0)
POINTING_M = 0.10
CENTRED = 0.10
FACE_M = 1.62
TABLE_CHANCE = 0.6
_EVERY = 5


class AimedAt:
    """Where the robot's parts and the aim are."""

    def __init__(self, assembly: Assembly, trial: Trial) -> None:
        self.truth, self.trial = assembly.world.truth, trial
        self._model = assembly.model
        description = assembly.model.description
        torso = description.groups["torso"]
        self._chest = link_moved_by(assembly.model, torso[-1]) if torso else description.base_link
        self._home = self.truth.world_T_link(self._chest)[:3, :3]
        self._camera = assembly.model.description.camera
        self._heading = trial.scene.robot_start.yaw_rad

    def aim(self) -> Array:
        """The face of a person, the middle of a thing, the middle of a top."""
        for person in self.trial.scene.people:
            if person.name == self.trial.aim:
                return np.array([*person.position_m, FACE_M])
        for solid in self.truth.solids():
            if solid.name in (self.trial.aim, f"{self.trial.aim}/top"):
                return np.array(solid.world_T_object[:3, 3])
        raise KeyError(self.trial.aim)

    def off_facing_rad(self) -> float:
        """Angle between where the chest faces and the aim, seen from above."""
        world_T_chest = self.truth.world_T_link(self._chest)
        ahead = (world_T_chest[:3, :3] @ self._home.T) @ (math.cos(self._heading), math.sin(self._heading), 0)
        x, y = (self.aim() - world_T_chest[:3, 3])[:2]
        off = math.atan2(ahead[1], ahead[0]) - math.atan2(y, x)
        return abs(math.remainder(off, 2.0 * math.pi))

    def joint_place(self, hand: Hand, number: int) -> Array:
        """Where the origin of the link that an arm's joint moves is."""
        joint = self._model.description.groups[f"{hand}_arm"][number]
        return self.truth.world_T_link(link_moved_by(self._model, joint))[:3, 3]

    def beside_m(self, hand: Hand) -> float:
        """By how much the line through forearm and hand misses the aim."""
        return beside_ray_m(self.joint_place(hand, 3), self.truth.world_T_tcp(hand)[:3, 3], self.aim())

    def off_centre(self) -> float:
        """How far from the picture's centre the aim is, as a share of half the picture."""
        pose = self.truth.world_T_camera()
        x, y, z = pose[:3, :3].T @ (self.aim() - pose[:3, 3])
        if z <= 0.0:
            return math.inf
        tan = math.tan(0.5 * self._camera.horizontal_fov_rad), math.tan(0.5 * self._camera.vertical_fov_rad)
        return float(max(abs(x / z) / tan[0], abs(y / z) / tan[1]))


class WaveJudge:
    """Counts swings of a hand above its shoulder while the chest faces the person."""

    def __init__(self, assembly: Assembly, trial: Trial, _rng: np.random.Generator) -> None:
        self._see = AimedAt(assembly, trial)
        self._periods = 0
        self._aside: dict[Hand, list[float]] = {hand: [] for hand in self._see.truth.hands}
        self._most: dict[Hand, int] = dict.fromkeys(self._see.truth.hands, 0)
        self._facing_rad = math.inf

    def on_event(self, event: object) -> None:
        """Nothing to learn from events."""

    def on_period(self) -> None:
        """Follow both hands."""
        self._periods += 1
        if self._periods % _EVERY:
            return
        off = self._see.off_facing_rad()
        aim = self._see.aim()
        for hand in self._see.truth.hands:
            place, shoulder = self._see.truth.world_T_tcp(hand)[:3, 3], self._see.joint_place(hand, 1)
            if place[2] <= shoulder[2] or off > FACING_RAD:
                self._aside[hand].clear()
                continue
            x, y = (aim - shoulder)[:2] / np.linalg.norm((aim - shoulder)[:2])
            self._aside[hand].append(float(-y * place[0] + x * place[1]))
            if (count := turns(self._aside[hand])) > self._most[hand]:
                self._most[hand] = count
                self._facing_rad = off

    def verdict(self, _results: Sequence[TaskResult]) -> Verdict:
        """Enough swings with one of the hands."""
        swings = max(self._most.values())
        return Verdict(
            swings >= SWINGS,
            {"swings": swings, "off_facing_rad": min(self._facing_rad, math.pi)},
            "" if swings >= SWINGS else f"{swings} swings",
        )


def turns(places: Sequence[float], least_m: float = SWING_M) -> int:
    """Number of ways of at least so much between one reversal and the next."""
    count, lowest, highest, extreme, way = 0, places[0], places[0], places[0], 0
    for place in places[1:]:
        if way == 0:
            lowest, highest = min(lowest, place), max(highest, place)
            if highest - lowest >= least_m:
                way, extreme, count = (1 if place == highest else -1), place, 1
        elif (place - extreme) * way > 0.0:
            extreme = place
        elif abs(place - extreme) >= least_m:
            way, extreme, count = -way, place, count + 1
    return count


class PointJudge:
    """Measures where an arm points while it is held out."""

    def __init__(self, assembly: Assembly, trial: Trial, _rng: np.random.Generator) -> None:
        self._see = AimedAt(assembly, trial)
        self._holding = False
        self._worst: dict[Hand, float] = {}

    def on_event(self, event: object) -> None:
        """The arm is held out while the leaf of that name runs."""
        if isinstance(event, NodeChanged) and event.where.endswith("/hold"):
            self._holding = event.status == "running"

    def on_period(self) -> None:
        """Measure."""
        if self._holding:
            for hand in self._see.truth.hands:
                self._worst[hand] = max(self._worst.get(hand, 0.0), self._see.beside_m(hand))

    def verdict(self, _results: Sequence[TaskResult]) -> Verdict:
        """One of the hands never pointed beside it."""
        off = min(self._worst.values(), default=math.inf)
        finite = min(off, 99.0)
        return Verdict(
            off <= POINTING_M, {"off_m": finite}, "" if off <= POINTING_M else f"off by {off:.2f} m"
        )


class LookJudge:
    """Measures where the camera looks at the end."""

    def __init__(self, assembly: Assembly, trial: Trial, _rng: np.random.Generator) -> None:
        self._see = AimedAt(assembly, trial)

    def on_event(self, event: object) -> None:
        """Nothing to learn from events."""

    def on_period(self) -> None:
        """Only the end counts."""

    def verdict(self, _results: Sequence[TaskResult]) -> Verdict:
        """The aim is in the middle of the picture."""
        off = self._see.off_centre()
        why = "" if off <= CENTRED else f"off the centre by {off:.2f} of half the picture"
        return Verdict(off <= CENTRED, {"off_centre": min(off, 99.0)}, why)


def wave_trial(rng: np.random.Generator, where: rooms.Workspace = rooms.STANDING) -> Trial:
    """One to three people, perhaps a table; wave at one of them."""
    furniture = [rooms.table(rng, where)] if rng.random() < TABLE_CHANCE else []
    crowd = rooms.people(rng, int(rng.integers(1, 4)), furniture)
    person = _chosen(crowd, rng)
    scene = rooms.room("wave", rng, furniture, crowd=crowd)
    return Trial(scene, (WaveTask(f"wave at {person.name}", person.name),), person.name)


def point_trial(rng: np.random.Generator, where: rooms.Workspace = rooms.STANDING) -> Trial:
    """A table with things and people behind it; point at one of all."""
    scene, aim, kind = _room_with_aim("point_at", rng, where)
    slot: dict[str, ObjectDescription | str] = {"person" if kind == "person" else "object": _meant(aim, kind)}
    return Trial(scene, (PointAtTask(f"point at {aim}", **slot),), aim)  # type: ignore[arg-type]


def look_trial(rng: np.random.Generator, where: rooms.Workspace = rooms.STANDING) -> Trial:
    """A table with things and people behind it; look at one of all."""
    scene, aim, kind = _room_with_aim("look_at", rng, where)
    slot: dict[str, ObjectDescription | str] = {"person" if kind == "person" else "object": _meant(aim, kind)}
    return Trial(scene, (LookAtTask(f"look at {aim}", **slot),), aim)  # type: ignore[arg-type]


def _room_with_aim(
    name: str, rng: np.random.Generator, where: rooms.Workspace
) -> tuple[SceneDescription, str, str]:
    table = rooms.table(rng, where)
    objects = rooms.things(rng, table, int(rng.integers(1, 5)), where=where)
    crowd = rooms.people(rng, int(rng.integers(0, where.most_people + 1)), [table])
    scene = rooms.room(name, rng, [table], objects, crowd)
    aims = [(thing.name, "object") for thing in objects] + [(person.name, "person") for person in crowd]
    aim, kind = aims[int(rng.integers(len(aims)))]
    return scene, aim, kind


def _meant(aim: str, kind: str) -> ObjectDescription | str:
    if kind == "person":
        return aim
    color, word = aim.split()
    return ObjectDescription(word, color)


def _chosen(crowd: Sequence[Person], rng: np.random.Generator) -> Person:
    return crowd[int(rng.integers(len(crowd)))]


WAVE = SkillSuite(wave_trial, WaveJudge, on_low=partial(wave_trial, where=rooms.LOW))
POINT_AT = SkillSuite(
    point_trial,
    PointJudge,
    on_bench=partial(point_trial, where=rooms.BENCH),
    on_low=partial(point_trial, where=rooms.LOW),
)
LOOK_AT = SkillSuite(look_trial, LookJudge, on_low=partial(look_trial, where=rooms.LOW))
