"""Suites of walking behind somebody, and of losing somebody."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from executive.session.assembly import Assembly
from executive.session.task_result import TaskResult
from robots.scenes.scene_description import Person, RobotStart
from tools.evaluate.people import ways
from tools.evaluate.people.company import BAR, Company
from tools.evaluate.skills import rooms
from tools.evaluate.skills.suite import Figure, SkillSuite, Trial, Verdict
from trees.events import Said
from trees.skills.follow import FollowTask

SPEED_M_S = (0.2, 0.6)
STARTS_S = (3.0, 14.0)
FAR_M = (1.3, 2.2)
BEARING_RAD = math.radians(35.0)
LENGTH_M = (2.0, 7.0)
TO_CHANCE, BYSTANDER_CHANCE = 0.3, 0.5
NEAREST_M, FARTHEST_M = 0.7, 3.0
"""Between the middles of robot and person, at any time after the person has set out."""
STANDS_M = (0.8, 1.45)
"""The same at the end, where the person stands."""
TOLD_S = 3.0
GONE_AFTER_S = (1.5, 6.0)
"""From when she sets out."""


class FollowJudge(Company):
    """Whether the robot kept behind, and stands behind at the end."""

    def __init__(self, assembly: Assembly, trial: Trial, rng: np.random.Generator) -> None:
        super().__init__(assembly, trial, rng)
        self._to: str | None = getattr(trial.tasks[-1], "to", None)

    def verdict(self, results: Sequence[TaskResult]) -> Verdict:
        """Never too near nor too far, and at the end where it should be."""
        to = self._to
        x, y = self.at()
        wrong: list[str] = []
        if self.nearest_m < NEAREST_M:
            wrong.append(f"came as near as {self.nearest_m:.2f} m")
        if self.farthest_m > FARTHEST_M:
            wrong.append(f"was {self.farthest_m:.2f} m behind")
        if to is not None:
            region = next(one for one in self.scene.places if one.name == to)
            if not region.contains(x, y):
                wrong.append(f"{self.person.name} is not in the {to}")
        else:
            off_m = math.dist((x, y), self.person.way_m[-1])
            if off_m > 0.01:
                wrong.append(f"{self.person.name} is still on the way, {off_m:.2f} m from the end")
            if not STANDS_M[0] <= self.apart_m() <= STANDS_M[1]:
                wrong.append(f"stands {self.apart_m():.2f} m from {self.person.name}")
        numbers = self.numbers(results) | {"to": to or ""}
        return Verdict(not wrong, numbers, "; ".join(wrong))


class LostJudge(Company):
    """Takes the person away, and measures how long it takes until the robot says so."""

    def __init__(self, assembly: Assembly, trial: Trial, rng: np.random.Generator) -> None:
        super().__init__(assembly, trial, rng)
        way_s = ways.length_m(self.person.position_m, self.person.way_m) / self.person.speed_m_s
        latest_s = min(GONE_AFTER_S[1], way_s)
        self._gone_s = self.person.starts_s + float(rng.uniform(min(GONE_AFTER_S[0], latest_s), latest_s))
        assembly.world.walkers.gone_s[self.person.name] = self._gone_s
        self._told_s = math.inf

    def on_event(self, event: object) -> None:
        """Hear what is said."""
        if isinstance(event, Said) and event.text.startswith("I lost"):
            self._told_s = min(self._told_s, event.t_s)

    def verdict(self, results: Sequence[TaskResult]) -> Verdict:
        """Told in time, and no earlier than it was so."""
        after_s = self._told_s - self._gone_s
        told = 0.0 <= after_s <= TOLD_S
        numbers: dict[str, Figure] = {
            "told_after_s": min(after_s, 99.0),
            "walked_m": self.walked_m,
            "took_s": results[-1].times.simulated_s,
        }
        why = "" if told else f"told {after_s:.1f} s after {self.person.name} had gone"
        return Verdict(told and results[-1].outcome != "done", numbers, why)


def follow_trial(rng: np.random.Generator) -> Trial:
    """Somebody ahead of the robot, who goes somewhere in the flat."""
    for _ in ways.tries():
        found = _trial(rng)
        if found is not None:
            return found
    raise RuntimeError("nobody's way could be drawn")


def lost_trial(rng: np.random.Generator) -> Trial:
    """The same; on the way the person is gone."""
    return follow_trial(rng)


def _trial(rng: np.random.Generator) -> Trial | None:
    robot = ways.free_place(rng, "living room", 0.95)
    end = ways.free_place(rng, ("kitchen", "living room")[int(rng.integers(2))], 0.8)
    if robot is None or end is None:
        return None
    far, bearing = float(rng.uniform(*FAR_M)), float(rng.uniform(-math.pi, math.pi))
    start = robot[0] + far * math.cos(bearing), robot[1] + far * math.sin(bearing)
    if not LENGTH_M[0] <= math.dist(start, end) <= LENGTH_M[1]:
        return None
    if not ways.is_walked_away(start, (end,), robot) or not ways.is_free(start):
        return None
    way = ways.way_to(start, end)
    if way is None or not LENGTH_M[0] <= ways.length_m(start, way) <= LENGTH_M[1]:
        return None
    if not ways.is_walked_away(start, way, robot):
        return None
    name = rooms.NAMES[int(rng.integers(len(rooms.NAMES)))]
    speed, starts = float(rng.uniform(*SPEED_M_S)), float(rng.uniform(*STARTS_S))
    yaw = float(rng.uniform(-math.pi, math.pi))
    people = [Person(name, start, yaw, way_m=way, speed_m_s=speed, starts_s=starts)]
    if rng.random() < BYSTANDER_CHANCE:
        other = next(one for one in rooms.NAMES if one != name)
        beside = ways.bystander(rng, other, (robot, start, *way))
        if beside is None:
            return None
        people.append(beside)
    heading = bearing + float(rng.uniform(-BEARING_RAD, BEARING_RAD))
    scene = ways.peopled(RobotStart(*robot, heading), people)
    if scene is None:
        return None
    kitchen = next(one for one in scene.places if one.name == "kitchen")
    goes_there = kitchen.contains(*end) and not kitchen.contains(*start)
    if goes_there and rng.random() < TO_CHANCE:
        return Trial(scene, (FollowTask(f"follow {name} to the kitchen", name, to="kitchen"),), name)
    return Trial(scene, (FollowTask(f"follow {name}", name),), name)


FOLLOW = SkillSuite(follow_trial, FollowJudge, stands=False, bar=BAR)
FOLLOW_LOST = SkillSuite(lost_trial, LostJudge, stands=False, ends="failed", bar=BAR)
