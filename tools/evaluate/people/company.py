"""What suites about people who walk measure: how far apart robot and person are."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from executive.session.assembly import Assembly
from executive.session.task_result import TaskResult
from tools.evaluate.people import ways
from tools.evaluate.skills.suite import Figure, Trial
from tools.evaluate.skills.way_walked import WayWalked, feet_of
from trees.events import NodeChanged

BAR = 0.9
"""Share of episodes that have to be truly done."""
_EVERY = 25
_LAST = ("walk behind", "/lead")
"""Leaves after which everybody may go on alone."""


class Company:
    """Measures how far apart robot and person are, from when the person sets out until the robot is done.

    Attributes:
        assembly: The robot and its world.
        truth: The simulator's.
        scene: What there is.
        person: Whom the task is about.
        nearest_m, farthest_m: Between the middles of both.
    """

    def __init__(self, assembly: Assembly, trial: Trial, _rng: np.random.Generator) -> None:
        self.assembly, self.truth, self.scene = assembly, assembly.world.truth, trial.scene
        self.person = next(one for one in trial.scene.people if one.name == trial.aim)
        self._way = WayWalked(assembly)
        self._periods = 0
        self._ended = False
        self.nearest_m, self.farthest_m = math.inf, 0.0

    def on_event(self, event: object) -> None:
        """Note when the robot holds that it is done: then everybody may go on alone."""
        done = isinstance(event, NodeChanged) and event.status == "success"
        self._ended = self._ended or (done and getattr(event, "where", "").endswith(_LAST))

    def on_period(self) -> None:
        """Measure from time to time."""
        self._way.on_period()
        self._periods += 1
        if not self._ended and self._periods % _EVERY == 0 and self.truth.time_s >= self.person.starts_s:
            apart_m = self.apart_m()
            self.nearest_m = min(self.nearest_m, apart_m)
            self.farthest_m = max(self.farthest_m, apart_m)

    def at(self) -> ways.Point:
        """Where the person truly is."""
        solid = self.truth.person(self.person.name)
        return float(solid.world_T_object[0, 3]), float(solid.world_T_object[1, 3])

    def apart_m(self) -> float:
        """Between the middles of both."""
        feet = feet_of(self.assembly)
        return math.dist((feet.x_m, feet.y_m), self.at())

    @property
    def walked_m(self) -> float:
        """How far the robot went."""
        return self._way.length_m

    def numbers(self, results: Sequence[TaskResult]) -> dict[str, Figure]:
        """What every suite about company tells."""
        return {
            "speed_m_s": self.person.speed_m_s,
            "way_m": ways.length_m(self.person.position_m, self.person.way_m),
            "walked_m": self._way.length_m,
            "nearest_m": min(self.nearest_m, 99.0),
            "farthest_m": self.farthest_m,
            "apart_m": self.apart_m(),
            "took_s": results[-1].times.simulated_s,
        }
