"""Suite of carries: pick a tall cup up, and walk to somebody some metres away with it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import partial

import numpy as np

from executive.session.assembly import Assembly
from executive.session.events import TaskAccepted
from executive.session.task_result import TaskResult
from kinematics.geometry.shapes import Cylinder
from robots.scenes.scene_description import Person
from tools.evaluate.skills import rooms
from tools.evaluate.skills.suite import SkillSuite, Trial, Verdict
from tools.evaluate.skills.way_walked import WayWalked
from trees.tasks import ObjectDescription, PickTask, WalkToTask

CUP = "red cup"
CUP_RADIUS_M, CUP_HEIGHT_M = 0.035, 0.14
FAR_M = 5.0
"""At least, from the start to the person less where the robot stands before somebody."""
TILT_RAD = math.radians(10.0)
WALKED_M = 4.0
_BEARING_RAD = (math.radians(70.0), math.radians(180.0))
"""The table is ahead."""


class CarryJudge:
    """From the moment that it is told to walk: the cup's tilt, and whether the hand still has it."""

    def __init__(self, assembly: Assembly, trial: Trial, _rng: np.random.Generator) -> None:
        self._assembly, self._truth, self._walk = assembly, assembly.world.truth, trial.tasks[-1].text
        self._way: WayWalked | None = None
        self._tilt_rad = 0.0
        self._dropped = False
        self._periods = 0

    def on_event(self, event: object) -> None:
        """Begin with the walk."""
        if isinstance(event, TaskAccepted) and event.text == self._walk:
            self._way = WayWalked(self._assembly)

    def on_period(self) -> None:
        """Measure the cup each 10 ms."""
        if self._way is None:
            return
        self._way.on_period()
        self._periods += 1
        if self._periods % 5:
            return
        self._tilt_rad = max(self._tilt_rad, self._truth.tilt_rad(CUP))
        self._dropped = self._dropped or CUP not in self._truth.contacts.in_pads_only()

    def verdict(self, _results: Sequence[TaskResult]) -> Verdict:
        """Carried all the way, and level."""
        walked_m = 0.0 if self._way is None else self._way.length_m
        done = not self._dropped and self._tilt_rad <= TILT_RAD and walked_m >= WALKED_M
        numbers = {
            "tilt_deg": math.degrees(self._tilt_rad),
            "dropped": self._dropped,
            "walked_m": walked_m,
        }
        told = f"tilted by {math.degrees(self._tilt_rad):.1f} degrees, walked {walked_m:.1f} m"
        return Verdict(done, numbers, "" if done else told + (", dropped" if self._dropped else ""))


def carry_trial(rng: np.random.Generator, where: rooms.Workspace = rooms.STANDING) -> Trial:
    """A tall cup on the table ahead, and Ana somewhere behind."""
    table = rooms.table(rng, where)
    place = rooms.spot(rng, table, [], where=where)
    if place is None:
        raise RuntimeError("an empty table has room")
    cup = rooms.item(CUP, "cup", "red", Cylinder(CUP_RADIUS_M, CUP_HEIGHT_M), table, place, rng)
    side = 1.0 if rng.random() < 0.5 else -1.0
    bearing = side * float(rng.uniform(*_BEARING_RAD))
    far = FAR_M + 0.9 + float(rng.uniform(0.0, 0.4))
    x, y = far * math.cos(bearing), far * math.sin(bearing)
    ana = Person(rooms.NAMES[0], (x, y), bearing + math.pi)
    scene = rooms.room("carry", rng, (table,), (cup,), (ana,))
    tasks = (
        PickTask("pick up the red cup", ObjectDescription("cup", "red")),
        WalkToTask("walk to Ana", ana.name),
    )
    return Trial(scene, tasks, CUP)


CARRY = SkillSuite(carry_trial, CarryJudge, stands=False, on_low=partial(carry_trial, where=rooms.LOW))
