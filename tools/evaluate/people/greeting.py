"""Suite of greeting: people in the rooms of the flat, some of whom walk; one of them is greeted."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from executive.session.assembly import Assembly
from executive.session.task_result import TaskResult
from kinematics.arrays import Array
from kinematics.model.robot_description import Hand
from robots.scenes.scene_description import Person, SceneDescription
from tools.evaluate.people.crowd import ends_at, peopled_flat, room_of
from tools.evaluate.skills.gestures import FACING_RAD, SWINGS, AimedAt, turns
from tools.evaluate.skills.suite import SkillSuite, Trial, Verdict
from trees.beliefs.scene.believed_thing import PERSON
from trees.events import Said
from trees.skills.greet import GreetTask
from trees.tasks import ObjectDescription

WITHIN_M = 2.2
"""From the middle of the robot to that of the person when it says hello."""
STOPS_AT_M = 1.2
"""So far from the robot's middle people who walk stop, rather than walk into its arms."""
BAR = 0.90
_EVERY = 5


class GreetingJudge:
    """Whether the right person was greeted: near by, faced, with a wave where one is told."""

    def __init__(self, assembly: Assembly, trial: Trial, _rng: np.random.Generator) -> None:
        self._world, self._aim = assembly.world, trial.aim
        self._see = _LivePerson(assembly, trial)
        self._walkers = [person.name for person in trial.scene.people if person.way_m]
        self._periods = 0
        self._aside: dict[Hand, list[float]] = {hand: [] for hand in self._see.truth.hands}
        self._swings = 0
        self._greeted: list[tuple[str, float, float]] = []

    def on_event(self, event: object) -> None:
        """Note to whom hello is said, from how far, and how far off the robot faces."""
        if isinstance(event, Said) and event.text.startswith("Hello"):
            self._greeted.append((event.to, self._see.away_m(), self._see.off_facing_rad()))

    def on_period(self) -> None:
        """Follow both hands; have people stop before they walk into the robot."""
        self._periods += 1
        if self._periods % _EVERY:
            return
        now_s, base = self._world.truth.time_s, self._world.truth.world_T_base()[:2, 3]
        for name in self._walkers:
            near = float(np.linalg.norm(self._see.place(name)[:2] - base)) < STOPS_AT_M
            if near and name not in self._world.walkers.stopped_s:
                self._world.walkers.stopped_s[name] = now_s
        self._follow_hands()

    def _follow_hands(self) -> None:
        off, aim = self._see.off_facing_rad(), self._see.aim()
        for hand in self._see.truth.hands:
            place, shoulder = self._see.truth.world_T_tcp(hand)[:3, 3], self._see.joint_place(hand, 1)
            if place[2] <= shoulder[2] or off > FACING_RAD:
                self._aside[hand].clear()
                continue
            x, y = (aim - shoulder)[:2] / np.linalg.norm((aim - shoulder)[:2])
            self._aside[hand].append(float(-y * place[0] + x * place[1]))
            self._swings = max(self._swings, turns(self._aside[hand]))

    def verdict(self, results: Sequence[TaskResult]) -> Verdict:
        """Said once, to the right one, near and faced; waved to if that is told."""
        told = int(results[-1].evidence.get("swings", 0))
        to, away_m, off_rad = self._greeted[0] if self._greeted else ("", math.inf, math.pi)
        wrong = [
            (len(self._greeted) != 1, f"said hello {len(self._greeted)} times"),
            (to != self._aim, f"greeted {to or 'nobody'}, not {self._aim}"),
            (away_m > WITHIN_M, f"from {away_m:.2f} m"),
            (off_rad > FACING_RAD, f"faced {math.degrees(off_rad):.0f} degrees beside"),
            (told > 0 and self._swings < SWINGS, f"{self._swings} swings, told {told}"),
        ]
        why = "; ".join(words for is_so, words in wrong if is_so)
        numbers = {
            "away_m": min(away_m, 99.0),
            "off_facing_deg": math.degrees(off_rad),
            "swings": self._swings,
            "took_s": sum(result.times.simulated_s for result in results),
        }
        return Verdict(not why, numbers, why)


class _LivePerson(AimedAt):
    """The same as for gestures, for people who walk."""

    def place(self, name: str) -> Array:
        """Where somebody is now, shape (3,)."""
        return np.array(self.truth.person(name).world_T_object[:3, 3])

    def aim(self) -> Array:
        """The middle of the person who is to be greeted."""
        return self.place(self.trial.aim)

    def away_m(self) -> float:
        """From the robot to that person, along the floor."""
        return float(np.linalg.norm(self.aim()[:2] - self.truth.world_T_base()[:2, 3]))


def greet_trial(rng: np.random.Generator) -> Trial:
    """Two or three people; one is greeted by name, with or without the room, or by what is seen of them."""
    scene = peopled_flat(rng, int(rng.integers(2, 4)))
    person = scene.people[int(rng.integers(len(scene.people)))]
    room = room_of(scene, *ends_at(person))
    introducing = bool(rng.random() < 0.3)
    way = int(rng.choice(3, p=(0.4, 0.3, 0.3)))
    described = _description(person, scene) if way == 2 else None
    if described is not None:
        task = GreetTask(f"greet the {described} in the {room}", described, room, introducing)
    elif way == 0:
        task = GreetTask(f"greet {person.name}", person.name, None, introducing)
    else:
        task = GreetTask(f"greet {person.name} in the {room}", person.name, room, introducing)
    return Trial(scene, (task,), person.name, as_errand=True)


def _description(person: Person, scene: SceneDescription) -> ObjectDescription | None:
    """One thing that is seen of nobody else in that room; None where there is none."""
    room = room_of(scene, *ends_at(person))
    others = [one for one in scene.people if one is not person and room_of(scene, *ends_at(one)) == room]
    for trait in (*([] if person.gesture is None else [person.gesture]), *person.clothes, person.posture):
        if not any(trait in (one.posture, one.gesture, *one.clothes) for one in others):
            return ObjectDescription(PERSON, traits=(trait,))
    return None


GREET = SkillSuite(greet_trial, GreetingJudge, stands=False, bar=BAR)
