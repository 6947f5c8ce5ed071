"""What a command should have brought about, judged by the simulator's truth."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Mapping, Sequence

import numpy as np

from executive.session.assembly import Assembly
from executive.session.task_result import TaskResult
from robots.control.period import PERIOD_S
from robots.scenes.scene_description import SceneDescription, SceneItem
from robots.scenes.usual_properties import inside_m3
from robots.simulated.people.taking_person import TakingPerson
from robots.simulated.truth.truth import SimulatorTruth
from tools.evaluate.gpsr.arena import carrier_of, region_of
from tools.evaluate.gpsr.command_trial import CommandTrial
from tools.evaluate.skills.gestures import WaveJudge
from tools.evaluate.skills.suite import Figure, Trial, Verdict
from trees.events import Offered, Said
from trees.skills.telling.tell import SEEN_WHOLE

LIFTED_M = 0.05
STANDS_M = 0.03
NEAR_M = 2.5
"""From the middle of the robot to that of the person to whom it speaks or waves."""
CARRIED_M = 0.15
_ALIKE = 1.5
"""Ratio of true volumes up to which two things may be told as of one size: each may be misjudged."""
_PULL_N = (10.0, 18.0)
_REACTION_S = (0.3, 1.5)


class Oracle:
    """Plays whoever takes what is offered, notes what is said, and knows what should be at the end."""

    def __init__(
        self,
        truth: SimulatorTruth,
        trial: CommandTrial,
        people: Mapping[str, TakingPerson],
        wave: WaveJudge | None,
    ) -> None:
        """Begin before the command is given.

        Args:
            truth: Of the world.
            trial: The command, and where it is given.
            people: Who takes what is offered, by name.
            wave: Follows the hands, where somebody is to be waved to.
        """
        self._truth, self._trial, self._people, self._wave = truth, trial, people, wave
        self._said: list[tuple[str, float]] = []
        self._taken: list[tuple[str, str]] = []

    def on_event(self, event: object) -> None:
        """Note what is said, and have people take what is offered to them."""
        if isinstance(event, Said):
            self._said.append((event.text, self._away_m(self._trial.person)))
        if isinstance(event, Offered) and event.to in self._people:
            item = self._in_hand()
            if item is not None:
                self._taken.append((item, event.to))
                self._people[event.to].offer(item, self._truth.time_s)

    def on_period(self) -> None:
        """Reach, close, pull; follow the hands where somebody is to be waved to."""
        if self._wave is not None:
            self._wave.on_period()
        for _, person in self._taken[-1:]:
            self._people[person].tick(PERIOD_S)

    def verdict(self, results: Sequence[TaskResult]) -> Verdict:
        """Whether each step brought about what it should have, as far as the end shows it."""
        wrong: list[str] = []
        thing = ""
        steps = self._trial.does
        for number, (action, named) in enumerate(steps):
            last = number == len(steps) - 1
            if action in ("pick", "find") and named in self._trial.words.things:
                thing = named
            wrong += filter(None, [self._fault(action, named, thing, last, results)])
        numbers: dict[str, Figure] = {"command": self._trial.sentence, "steps": len(steps)}
        return Verdict(not wrong, numbers, "; ".join(wrong), reserved=_with_reserve(results))

    def _fault(self, action: str, named: str, thing: str, last: bool, results: Sequence[TaskResult]) -> str:
        """What is wrong about one step; empty when nothing is, or when a later step shows it."""
        if action == "pick" and last:
            return self._held(thing)
        if action == "place":
            return self._placed(thing, named)
        if action == "hand_over":
            given = named if named in self._trial.words.things else thing
            return self._given(given, None if named in ("me", given) else named)
        if action == "walk_to" and last:
            return self._there(named)
        if action == "count":
            return self._counted(named, results)
        if action == "describe":
            return self._ranked(results)
        if action == "wave":
            return self._waved(results)
        return self._spoken(action, named) if action in ("say", "answer", "greet") else ""

    def _held(self, thing: str) -> str:
        if thing not in self._truth.contacts.in_pads_only():
            return f"the {thing} is in no hand"
        return "" if self._truth.lift_m(thing) >= LIFTED_M else f"the {thing} is not lifted"

    def _placed(self, thing: str, place: str) -> str:
        pose, scene = self._truth.world_T_object(thing), self._trial.scene
        piece = next(piece for piece in scene.furniture if piece.name == place)
        along, across = _within(piece.yaw_rad, pose[:2, 3] - np.array(piece.position_m))
        if abs(along) > 0.5 * piece.size_m[0] or abs(across) > 0.5 * piece.size_m[1]:
            return f"the {thing} is not on the {place}"
        if any("gripper" in name for name in self._truth.contacts.of_object(thing)):
            return f"the {thing} is still in the hand"
        return "" if abs(self._truth.lift_m(thing)) <= STANDS_M else f"the {thing} does not stand"

    def _given(self, thing: str, to: str | None) -> str:
        """``to`` is None for whoever speaks: the person nearest to the robot at the beginning."""
        person = to or self._trial.speaker
        if (thing, person) not in self._taken:
            return f"the {thing} was not offered to {person}"
        fingers = [name for name in self._truth.contacts.of_object(thing) if name.startswith(f"{person}/")]
        if self._people[person].carried_m < CARRIED_M or not fingers:
            return f"{person} did not get the {thing}"
        return ""

    def _there(self, place: str) -> str:
        base = self._truth.world_T_base()[:2, 3]
        room = next((one for one in self._trial.scene.places if one.name == place), None)
        if room is not None:
            return "" if room.contains(float(base[0]), float(base[1])) else f"the robot is not in the {place}"
        return ""

    def _counted(self, named: str, results: Sequence[TaskResult]) -> str:
        told = [int(result.evidence["count"]) for result in results if "count" in result.evidence]
        scene, words = self._trial.scene, self._trial.words
        if named in words.rooms:
            there = sum(region_of(scene, person.position_m) == named for person in scene.people)
        else:
            there = sum(item.kind == named for item in self._on_the_named_piece())
        return "" if told[-1:] == [there] else f"told {told or 'nothing'}, there are {there}"

    def _ranked(self, results: Sequence[TaskResult]) -> str:
        items = self._on_the_named_piece()
        size = next(word for word in ("smallest", "biggest", "largest") if word in self._trial.sentence)
        volumes_m3 = {item.name: inside_m3(item.shape) for item in items}
        pick = min if size == "smallest" else max
        right = pick(volumes_m3, key=volumes_m3.__getitem__, default="")
        told = str(results[-1].evidence.get("names", "")) if results else ""
        names = told.split(", ")
        if right not in names or any(_is_of_another_size(volumes_m3, name, right) for name in names):
            return f"told {told!r}, it is the {right}"
        return ""

    def _waved(self, results: Sequence[TaskResult]) -> str:
        assert self._wave is not None
        person, verdict = self._trial.person, self._wave.verdict(results)
        if not verdict.done:
            return f"did not wave to {person}: {verdict.why}"
        return "" if self._away_m(person) <= NEAR_M else f"waved too far from {person}"

    def _spoken(self, action: str, named: str) -> str:
        told = [far for text, far in self._said if action != "say" or named in text]
        if not told:
            return f"did not say {named!r}" if action == "say" else "said nothing"
        return "" if min(told) <= NEAR_M else f"said it too far from {self._trial.person}"

    def _on_the_named_piece(self) -> list[SceneItem]:
        scene: SceneDescription = self._trial.scene
        named = [name for name in self._trial.words.furniture if f"the {name}" in self._trial.sentence]
        place = max(named, key=len, default="")
        return [item for item in scene.objects if carrier_of(scene, item).name == place]

    def _away_m(self, person: str) -> float:
        """From the robot to somebody; infinite where a command names nobody."""
        base = self._truth.world_T_base()[:2, 3]
        meant = [one for one in self._trial.scene.people if one.name == person]
        return min((math.dist(base, one.position_m) for one in meant), default=math.inf)

    def _in_hand(self) -> str | None:
        return next(iter(self._truth.contacts.in_pads_only()), None)


def _is_of_another_size(volumes_m3: Mapping[str, float], name: str, other: str) -> bool:
    """Whether a thing that was told beside the right one is none that could be taken for it."""
    if name == other:
        return False
    one_m3, other_m3 = volumes_m3.get(name, 0.0), volumes_m3[other]
    return max(one_m3, other_m3) > _ALIKE * min(one_m3, other_m3)


def oracle_for(assembly: Assembly, trial: Trial, rng: np.random.Generator) -> Oracle:
    """The oracle of a trial, with the people of its scene."""
    assert isinstance(trial, CommandTrial)
    truth, physics = assembly.world.truth, assembly.world.physics
    pull_n, reaction_s = float(rng.uniform(*_PULL_N)), float(rng.uniform(*_REACTION_S))
    people = {
        person.name: TakingPerson(physics, truth, person.name, pull_n, reaction_s)
        for person in trial.scene.people
    }
    waves = any(action == "wave" for action, _ in trial.does)
    aimed = dataclasses.replace(trial, aim=trial.person)
    return Oracle(truth, trial, people, WaveJudge(assembly, aimed, rng) if waves else None)


def _with_reserve(results: Sequence[TaskResult]) -> bool:
    """Whether the last answer told that not all was seen."""
    return bool(results) and results[-1].evidence.get(SEEN_WHOLE) is False


def _within(yaw_rad: float, off: np.ndarray) -> tuple[float, float]:
    """Along and across of a piece that is turned."""
    c, s = math.cos(yaw_rad), math.sin(yaw_rad)
    return float(c * off[0] + s * off[1]), float(-s * off[0] + c * off[1])
