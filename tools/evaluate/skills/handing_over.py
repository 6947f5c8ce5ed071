"""Suite of hand_over: a person's hand, on a spring with a force limit, takes the object and pulls."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from executive.assembly import Assembly
from executive.lockstep import PERIOD_S
from executive.task_result import TaskResult
from robots.simulated.person_hand import PersonHand
from tools.evaluate.skills import rooms
from tools.evaluate.skills.pinching import BEFORE_M, SPARE_M, Pinch, choose_pinch
from tools.evaluate.skills.suite import SkillSuite, Trial, Verdict
from trees.events import NodeChanged
from trees.tasks import HandOverTask, ObjectDescription, PickTask, Task

Array = NDArray[np.float64]

CARRIED_M = 0.15
DROPPED_BELOW_M = 0.5
PULL_N = (10.0, 18.0)
REACTION_S = (0.3, 1.5)
BEARING_RAD = math.radians(30.0)
_HELD_CHANCE = 0.6
_SETTLE_S = 0.4


class TakingJudge:
    """Plays the person who takes, and measures how far the object is carried."""

    def __init__(self, assembly: Assembly, trial: Trial, rng: np.random.Generator) -> None:
        self._truth, self._trial = assembly.world.truth, trial
        self._task = trial.tasks[-1]
        person = next(one for one in trial.scene.people if one.name == getattr(self._task, "to", ""))
        self._person = np.array([*person.position_m, 0.0])
        self._hand = PersonHand(assembly.world.physics, person.name)
        self._fingers = f"{person.name}/"
        self._hand.force_n = 20.0
        self._pull_n, self._reaction_s = float(rng.uniform(*PULL_N)), float(rng.uniform(*REACTION_S))
        item = next(one for one in trial.scene.objects if one.name == trial.aim)
        self._shape = item.shape
        self._pinch: Pinch | None = None
        self._offered_s: float | None = None
        self._stage, self._since_s = "waiting", 0.0
        self._offered = np.zeros(3)
        self._carried_m = 0.0

    def on_event(self, event: object) -> None:
        """The person sees that something is offered."""
        if not isinstance(event, NodeChanged) or self._offered_s is not None:
            return
        if event.where.endswith("wait for the pull") and event.status == "running":
            self._offered_s = event.t_s

    def on_period(self) -> None:
        """Reach, close, pull."""
        now_s = self._truth.time_s
        place = self._truth.world_T_object(self._trial.aim)[:3, 3]
        towards = self._person - place
        towards[2] = 0.0
        towards /= np.linalg.norm(towards)
        if self._pinch is None:
            if self._offered_s is not None and now_s >= self._offered_s + self._reaction_s:
                self._pinch = choose_pinch(self._hand, place, self._shape, towards)
                self._hand.roll_rad = self._pinch.roll_rad
                self._hand.open_m = self._pinch.half_m + SPARE_M
                self._stage, self._since_s = "reaching", now_s
            self._hand.tick(PERIOD_S)
            return
        goal = place + self._pinch.offset_m
        if self._stage == "reaching":
            self._hand.move_to(goal + BEFORE_M * towards)
            self._next("closing in", now_s, goal + BEFORE_M * towards, 0.03)
        elif self._stage == "closing in":
            self._hand.move_to(goal)
            if self._next("pinching", now_s, goal, 0.01):
                self._hand.pinching = True
        elif self._stage == "pinching" and now_s >= self._since_s + _SETTLE_S:
            self._stage, self._since_s = "pulling", now_s
            self._hand.force_n = self._pull_n
            self._offered = place.copy()
            self._hand.move_to(goal + 0.40 * towards)
        if self._stage == "pulling":
            self._carried_m = max(self._carried_m, float(np.linalg.norm((place - self._offered)[:2])))
        self._hand.tick(PERIOD_S)

    def verdict(self, _results: Sequence[TaskResult]) -> Verdict:
        """Carried away and not dropped."""
        place = self._truth.world_T_object(self._trial.aim)[:3, 3]
        touching = self._truth.object_contacts(self._trial.aim)
        faults = {
            f"the person got to {self._stage}": self._stage != "pulling",
            f"carried {self._carried_m:.2f} m": self._carried_m < CARRIED_M,
            "dropped": place[2] < DROPPED_BELOW_M,
            "not in the person's hand": not any(name.startswith(self._fingers) for name in touching),
            "still in the robot's hand": any("gripper" in name for name in touching),
        }
        wrong = [words for words, so in faults.items() if so]
        return Verdict(not wrong, {"carried_m": self._carried_m, "pull_n": self._pull_n}, "; ".join(wrong))

    def _next(self, stage: str, now_s: float, goal: Array, within_m: float) -> bool:
        if now_s >= self._since_s + _SETTLE_S and np.linalg.norm(self._hand.place() - goal) <= within_m:
            self._stage, self._since_s = stage, now_s
            return True
        return False


def hand_over_trial(rng: np.random.Generator) -> Trial:
    """Things on a table, and one or two people behind it; one of them gets one of the things."""
    table = rooms.table(rng)
    objects = rooms.things(rng, table, int(rng.integers(1, 4)))
    crowd = rooms.people(rng, int(rng.integers(1, 3)), [table], BEARING_RAD)
    item, person = objects[0], crowd[int(rng.integers(len(crowd)))]
    meant = ObjectDescription(item.kind, item.color)
    give = HandOverTask(f"give the {item.name} to {person.name}", meant, person.name)
    tasks: tuple[Task, ...] = (give,)
    if rng.random() < _HELD_CHANCE:
        tasks = (PickTask(f"pick up the {item.name}", meant), give)
    return Trial(rooms.room("hand_over", rng, [table], objects, crowd), tasks, item.name)


HAND_OVER = SkillSuite(hand_over_trial, TakingJudge)
