"""Suites of leading somebody to a room, and of leading somebody who stays behind."""

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
from tools.evaluate.skills.suite import SkillSuite, Trial, Verdict
from tools.evaluate.skills.way_walked import feet_of
from trees.skills.guide import GuideTask

SPEED_M_S = (0.4, 0.9)
FAR_M = (1.4, 3.0)
BEARING_RAD = math.radians(40.0)
DOORWAY_M, FROM_DOORWAY_M = (2.4, 0.6), 1.4
"""Nobody stands in the doorway who is to be led through it."""
BYSTANDER_CHANCE = 0.5
NEAREST_M = 0.6
TOGETHER_M = 2.2
"""Who has been led there is so near at the end."""
STAYS_AFTER_S = (10.0, 20.0)
_ROOMS = ("living room", "kitchen")


class GuideJudge(Company):
    """Whether robot and person are together where they were to go."""

    def __init__(self, assembly: Assembly, trial: Trial, rng: np.random.Generator) -> None:
        super().__init__(assembly, trial, rng)
        self._to = str(getattr(trial.tasks[-1], "to", ""))

    def verdict(self, results: Sequence[TaskResult]) -> Verdict:
        """Both are there, and the robot never came too near."""
        feet, wrong = feet_of(self.assembly), list[str]()
        region = next(one for one in self.scene.places if one.name == self._to)
        if not region.contains(feet.x_m, feet.y_m):
            wrong.append(f"the robot is not in the {self._to}")
        if self.apart_m() > TOGETHER_M:
            wrong.append(f"{self.person.name} is {self.apart_m():.2f} m away")
        if self.nearest_m < NEAREST_M:
            wrong.append(f"came as near as {self.nearest_m:.2f} m")
        return Verdict(not wrong, self.numbers(results) | {"to": self._to}, "; ".join(wrong))


class StayingJudge(Company):
    """Has the person stay somewhere on the way; the robot has to notice and to say so."""

    def __init__(self, assembly: Assembly, trial: Trial, rng: np.random.Generator) -> None:
        super().__init__(assembly, trial, rng)
        assembly.world.walkers.stopped_s[self.person.name] = float(rng.uniform(*STAYS_AFTER_S))

    def verdict(self, results: Sequence[TaskResult]) -> Verdict:
        """No claim to have led somebody who is not there."""
        done = results[-1].outcome != "done" and self.nearest_m >= NEAREST_M
        why = "" if done else f"ended as {results[-1].outcome}, came as near as {self.nearest_m:.2f} m"
        return Verdict(done, self.numbers(results), why)


def guide_trial(rng: np.random.Generator) -> Trial:
    """Somebody in one room, who is to be led to the other."""
    for _ in ways.tries():
        found = _trial(rng)
        if found is not None:
            return found
    raise RuntimeError("no guest could be drawn")


def _trial(rng: np.random.Generator) -> Trial | None:
    flat = ways.furnished()
    here = int(rng.integers(2))
    robot = ways.free_place(rng, _ROOMS[here], 0.95)
    place = ways.free_place(rng, _ROOMS[here], 0.7)
    if robot is None or place is None or not FAR_M[0] <= math.dist(robot, place) <= FAR_M[1]:
        return None
    if math.dist(place, DOORWAY_M) < FROM_DOORWAY_M:
        return None
    name = rooms.NAMES[int(rng.integers(len(rooms.NAMES)))]
    speed, yaw = float(rng.uniform(*SPEED_M_S)), float(rng.uniform(-math.pi, math.pi))
    people = [Person(name, place, yaw, speed_m_s=speed, follows=True)]
    if rng.random() < BYSTANDER_CHANCE:
        other = next(one for one in rooms.NAMES if one != name)
        way = ways.way_to(place, flat.places[1 - here].position_m)
        beside = None if way is None else ways.bystander(rng, other, (robot, place, *way))
        if beside is None:
            return None
        people.append(beside)
    heading = math.atan2(place[1] - robot[1], place[0] - robot[0])
    heading += float(rng.uniform(-BEARING_RAD, BEARING_RAD))
    scene = ways.peopled(RobotStart(*robot, heading), people)
    to = _ROOMS[1 - here]
    task = GuideTask(f"guide {name} to the {to}", name, to=to)
    return None if scene is None else Trial(scene, (task,), name)


GUIDE = SkillSuite(guide_trial, GuideJudge, stands=False, bar=BAR)
GUIDE_LEFT = SkillSuite(guide_trial, StayingJudge, stands=False, ends="failed", bar=BAR)
