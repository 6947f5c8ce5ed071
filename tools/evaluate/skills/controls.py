"""Suites of knobs and buttons on what stands before the robot."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from executive.session.assembly import Assembly
from executive.session.task_result import TaskResult
from robots.scenes.fixture import Control
from robots.scenes.furniture_names import BUTTON, FIXTURE, KNOB
from robots.scenes.scene_description import Furniture, PerceptionModel, SceneDescription
from tools.evaluate.skills.suite import SkillSuite, Trial, Verdict
from trees.tasks import ObjectDescription, PressTask, TurnKnobTask

ON_RAD, OFF_RAD = 0.6, 0.3
"""A knob is on when it is turned by so much, off when by no more."""
PRESSED = 0.8
"""Of a button's way: what is pressed so far has switched."""


@dataclass(frozen=True, slots=True)
class Place:
    """Where knobs and buttons are within a robot's reach; lengths in m.

    Attributes:
        table_m: Depth and width of the table that the things stand on.
        top_m: Its height.
        ahead_m: From the robot to the fronts of the things.
        aside_m: From its middle to the middle of a thing.
        height_m: Of a knob or button, above the floor.
    """

    table_m: tuple[float, float]
    top_m: tuple[float, float]
    ahead_m: tuple[float, float]
    aside_m: tuple[float, float]
    height_m: tuple[float, float]


STANDING = Place((0.6, 1.4), (0.74, 0.84), (0.60, 0.68), (0.10, 0.34), (0.92, 1.08))
"""Before a humanoid of a grown-up's size."""
LOW = Place((0.5, 1.2), (0.66, 0.72), (0.36, 0.42), (0.12, 0.28), (0.78, 0.92))
"""Before a humanoid of a child's size."""


class KnobJudge:
    """Looks how far the knob is turned at the end."""

    def __init__(self, assembly: Assembly, trial: Trial, _rng: np.random.Generator) -> None:
        self._truth, self._aim = assembly.world.truth, trial.aim
        (task,) = trial.tasks
        self._off = isinstance(task, TurnKnobTask) and task.off

    def on_event(self, event: object) -> None:
        """Nothing to learn from events."""

    def on_period(self) -> None:
        """The end counts."""

    def verdict(self, results: Sequence[TaskResult]) -> Verdict:
        """Turned far enough, or back."""
        angle = self._truth.opening(self._aim)
        done = angle <= OFF_RAD if self._off else angle >= ON_RAD
        numbers = {"turned_rad": angle, "took_s": results[-1].times.simulated_s}
        return Verdict(done, numbers, "" if done else f"turned by {angle:.2f} rad")


class ButtonJudge:
    """Notes how far the button was pressed in at most, and whether another one was."""

    def __init__(self, assembly: Assembly, trial: Trial, _rng: np.random.Generator) -> None:
        self._truth, self._aim = assembly.world.truth, trial.aim
        self._ways = {
            f"{piece.name}/{control.name}": control.travel
            for piece in trial.scene.furniture
            for control in piece.controls
            if control.kind == BUTTON
        }
        self._most = dict.fromkeys(self._ways, 0.0)

    def on_event(self, event: object) -> None:
        """Nothing to learn from events."""

    def on_period(self) -> None:
        """Follow all buttons."""
        for name, way in self._ways.items():
            self._most[name] = max(self._most[name], self._truth.opening(name) / way)

    def verdict(self, results: Sequence[TaskResult]) -> Verdict:
        """The one that was meant, and no other."""
        pressed = [name for name, share in self._most.items() if share >= PRESSED]
        done = pressed == [self._aim]
        numbers = {"pressed_share": self._most[self._aim], "took_s": results[-1].times.simulated_s}
        return Verdict(done, numbers, "" if done else f"pressed: {', '.join(pressed) or 'none'}")


def _scene(name: str, rng: np.random.Generator, kind: str, where: Place) -> SceneDescription:
    """A table with two things on it, one to each side, each with a knob or button that faces the robot."""
    top = float(rng.uniform(*where.top_m))
    front = float(rng.uniform(*where.ahead_m))
    table = Furniture("table", "table", (*where.table_m, top), (front - 0.05 + 0.5 * where.table_m[0], 0.0))
    names = ["stove", "oven"] if kind == KNOB else ["coffee machine", "toaster"]
    pieces = [table]
    for side, called in zip(rng.permutation([1.0, -1.0]), names, strict=True):
        deep, wide = float(rng.uniform(0.25, 0.4)), float(rng.uniform(0.18, 0.28))
        yaw, aside = float(rng.uniform(-0.15, 0.15)), float(side * rng.uniform(*where.aside_m))
        high = float(rng.uniform(*where.height_m))
        pieces.append(
            Furniture(
                called,
                FIXTURE,
                (deep, wide, high + float(rng.uniform(0.06, 0.12))),
                (front + 0.5 * deep * math.cos(yaw), aside),
                yaw,
                foot_m=top,
                controls=(_control(rng, kind, deep, wide, high),),
            )
        )
    return SceneDescription(name, perception=PerceptionModel(), furniture=tuple(pieces))


def _control(rng: np.random.Generator, kind: str, deep: float, wide: float, high: float) -> Control:
    at = (-0.5 * deep, float(rng.uniform(-0.2, 0.2)) * wide, high)
    if kind == KNOB:
        long, travel = float(rng.uniform(0.04, 0.05)), float(rng.uniform(1.3, 2.4))
        radius, torque = float(rng.uniform(0.022, 0.03)), float(rng.uniform(0.04, 0.15))
        return Control(KNOB, KNOB, at, "front", radius, long, travel, torque)
    radius, long = float(rng.uniform(0.015, 0.025)), float(rng.uniform(0.010, 0.02))
    travel, force = float(rng.uniform(0.003, 0.007)), float(rng.uniform(2.0, 6.0))
    return Control(BUTTON, BUTTON, at, "front", radius, long, travel, force)


def turn_knob_trial(rng: np.random.Generator) -> Trial:
    """Switch one of two things on, or off."""
    scene = _scene("turn_knob", rng, KNOB, STANDING)
    off = bool(rng.random() < 0.3)
    aim = scene.furniture[1 + int(rng.integers(2))]
    if off:
        turned = replace(aim.controls[0], at=float(rng.uniform(0.8, 1.2)))
        pieces = tuple(
            replace(piece, controls=(turned,)) if piece is aim else piece for piece in scene.furniture
        )
        scene = replace(scene, furniture=pieces)
    text = f"turn {'off' if off else 'on'} the {aim.name}"
    task = TurnKnobTask(text, ObjectDescription(aim.name), off=off)
    return Trial(scene, (task,), f"{aim.name}/{KNOB}")


def press_trial(rng: np.random.Generator, where: Place = STANDING) -> Trial:
    """Press the button of one of two things."""
    scene = _scene("press", rng, BUTTON, where)
    aim = scene.furniture[1 + int(rng.integers(2))]
    task = PressTask(f"press the button of the {aim.name}", ObjectDescription(aim.name))
    return Trial(scene, (task,), f"{aim.name}/{BUTTON}")


TURN_KNOB = SkillSuite(turn_knob_trial, KnobJudge, bar=0.8)
PRESS = SkillSuite(press_trial, ButtonJudge, bar=0.8, on_low=partial(press_trial, where=LOW))
