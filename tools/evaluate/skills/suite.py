"""What a skill's suite is made of."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Protocol

import numpy as np

from executive.session.assembly import Assembly
from executive.session.task_result import TaskResult
from robots.scenes.scene_description import SceneDescription
from tools.evaluate.records import SUCCESS_BAR
from trees.tasks import Task

Figure = float | int | str | bool

ANY_END = "any"
"""Of suites in which a question or a no may be what is right."""


@dataclass(frozen=True, slots=True)
class Verdict:
    """What the truth says about an episode.

    Attributes:
        done: Whether what was asked for really happened.
        numbers: What was measured; keys carry their unit.
        why: What was wrong, for people; empty when nothing was.
        reserved: Whether the robot said that there may be more than it saw.
    """

    done: bool
    numbers: Mapping[str, Figure] = field(default_factory=dict)
    why: str = ""
    reserved: bool = False


class SkillJudge(Protocol):
    """Watches the truth beside the run and never tells the robot."""

    def on_event(self, event: object) -> None:
        """Take one event of any kind."""
        ...

    def on_period(self) -> None:
        """Look at the world; called after each control period."""
        ...

    def verdict(self, results: Sequence[TaskResult]) -> Verdict:
        """After the last task."""
        ...


@dataclass(frozen=True, slots=True)
class Trial:
    """One episode: what is there, and what is asked.

    Attributes:
        scene: The world.
        tasks: Asked one after the other; the last one is what the suite is about.
        aim: Name of the object, person or furniture that the last task is about.
        sentence: What is said instead; ``tasks`` then only tell the judge what is meant by it.
        first: Asked before the sentence.
        given: Names of what people were given before; it moves with their hands.
        opened: Piece whose doors and drawers fingers may touch.
        as_errand: Whether ``tasks`` are one errand, with what has to be done before each.
    """

    scene: SceneDescription
    tasks: tuple[Task, ...]
    aim: str = ""
    sentence: str = ""
    first: tuple[Task, ...] = ()
    given: tuple[str, ...] = ()
    opened: str = ""
    as_errand: bool = False


@dataclass(frozen=True, slots=True)
class SkillSuite:
    """How to make and judge the episodes of one skill.

    Attributes:
        trial: Makes an episode from a generator; None where a scene has to be named.
        judge: Makes its judge, before the first task; the generator is another one than the trial's.
        stands: Whether the robot stands all the while, so that its CoM must stay inside its feet.
        bar: Share of episodes that have to be truly done.
        ends: How the last task is to end; an episode that ends so counts as claimed. "any" leaves it to the
            judge: a question or a no may be what is right.
        on_bench: Makes an episode before an arm that is bolted down; None where there is none for it.
        on_low: Makes an episode before a low table; None where there is none for it.
        in_scene: Makes an episode of what a scene has, by its name or file, for a robot, by its name; None
            where it makes its own.
        unnamed: Makes of an episode the same one where nobody can see what people are called.
    """

    trial: Callable[[np.random.Generator], Trial] | None
    judge: Callable[[Assembly, Trial, np.random.Generator], SkillJudge]
    stands: bool = True
    ends: str = "done"
    bar: float = SUCCESS_BAR
    on_bench: Callable[[np.random.Generator], Trial] | None = None
    on_low: Callable[[np.random.Generator], Trial] | None = None
    in_scene: Callable[[np.random.Generator, str, str], Trial] | None = None
    unnamed: Callable[[Trial], Trial] | None = None

    def makes(self, scene: str | None, robot: str) -> Callable[[np.random.Generator], Trial] | None:
        """What makes its episodes in a scene, for a robot, both by their names; None where nothing does."""
        made = self.in_scene
        own = {None: self.trial, "bench": self.on_bench, "low_tabletop": self.on_low}
        if made is not None and (scene is None or own.get(scene) is None):
            return self.trial if scene is None else lambda rng: made(rng, scene, robot)
        return own.get(scene)
