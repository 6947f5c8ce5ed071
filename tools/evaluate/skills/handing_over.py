"""Suite of hand_over: a person's hand, on a spring with a force limit, takes the object and pulls."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from functools import partial

import numpy as np

from executive.session.assembly import Assembly
from executive.session.task_result import TaskResult
from robots.control.period import PERIOD_S
from robots.simulated.people.taking_person import TakingPerson
from tools.evaluate.skills import rooms
from tools.evaluate.skills.suite import SkillSuite, Trial, Verdict
from trees.events import Offered
from trees.tasks import HandOverTask, ObjectDescription, PickTask, Task

CARRIED_M = 0.15
DROPPED_BELOW_M = 0.5
PULL_N = (10.0, 18.0)
REACTION_S = (0.3, 1.5)
BEARING_RAD = math.radians(30.0)
_HELD_CHANCE = 0.6


class TakingJudge:
    """Plays the person who takes, and measures how far the object is carried."""

    def __init__(self, assembly: Assembly, trial: Trial, rng: np.random.Generator) -> None:
        self._truth, self._trial = assembly.world.truth, trial
        person = getattr(trial.tasks[-1], "to", "")
        self._fingers = f"{person}/"
        self._pull_n, reaction_s = float(rng.uniform(*PULL_N)), float(rng.uniform(*REACTION_S))
        self._person = TakingPerson(assembly.world.physics, self._truth, person, self._pull_n, reaction_s)

    def on_event(self, event: object) -> None:
        """The person sees that something is offered."""
        if isinstance(event, Offered):
            self._person.offer(self._trial.aim, self._truth.time_s)

    def on_period(self) -> None:
        """Reach, close, pull."""
        self._person.tick(PERIOD_S)

    def verdict(self, _results: Sequence[TaskResult]) -> Verdict:
        """Carried away and not dropped."""
        place = self._truth.world_T_object(self._trial.aim)[:3, 3]
        touching = self._truth.contacts.of_object(self._trial.aim)
        faults = {
            f"the person got to {self._person.stage}": self._person.stage != "pulling",
            f"carried {self._person.carried_m:.2f} m": self._person.carried_m < CARRIED_M,
            "dropped": place[2] < DROPPED_BELOW_M,
            "not in the person's hand": not any(name.startswith(self._fingers) for name in touching),
            "still in the robot's hand": any("gripper" in name for name in touching),
        }
        wrong = [words for words, so in faults.items() if so]
        return Verdict(
            not wrong, {"carried_m": self._person.carried_m, "pull_n": self._pull_n}, "; ".join(wrong)
        )


def hand_over_trial(rng: np.random.Generator, where: rooms.Workspace = rooms.STANDING) -> Trial:
    """Things on a table, and one or two people behind it; one of them gets one of the things."""
    table = rooms.table(rng, where)
    objects = rooms.things(rng, table, int(rng.integers(1, 4)), where=where)
    crowd = rooms.people(rng, int(rng.integers(1, 3)), [table], BEARING_RAD)
    item, person = objects[0], crowd[int(rng.integers(len(crowd)))]
    meant = ObjectDescription(item.kind, item.color)
    give = HandOverTask(f"give the {item.name} to {person.name}", meant, person.name)
    tasks: tuple[Task, ...] = (give,)
    if rng.random() < _HELD_CHANCE:
        tasks = (PickTask(f"pick up the {item.name}", meant), give)
    return Trial(rooms.room("hand_over", rng, [table], objects, crowd), tasks, item.name)


def to_somebody_seen(trial: Trial) -> Trial:
    """The same, where whoever gets the thing is meant by where the person stands, not by a name."""
    give, people = trial.tasks[-1], trial.scene.people
    name = getattr(give, "to", "")
    bearing = {one.name: math.atan2(one.position_m[1], one.position_m[0]) for one in people}
    who = "the person"
    if len(people) > 1:
        who += f" on the {'left' if bearing[name] == max(bearing.values()) else 'right'}"
    return replace(trial, sentence=f"give the {trial.aim} to {who}", first=trial.tasks[:-1])


HAND_OVER = SkillSuite(
    hand_over_trial,
    TakingJudge,
    on_low=partial(hand_over_trial, where=rooms.LOW),
    unnamed=to_somebody_seen,
)
