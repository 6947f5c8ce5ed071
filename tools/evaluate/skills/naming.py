"""Suite of names: things of any kind, with names that nobody knows before, meant by what is said."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from executive.session.assembly import Assembly
from executive.session.events import QuestionAsked, TaskRefused
from executive.session.task_result import TaskResult
from kinematics.arrays import Array
from kinematics.geometry import poses
from kinematics.geometry.shapes import Box, Cylinder, Shape
from robots.scenes.scene_description import Furniture, PerceptionModel, SceneItem
from robots.scenes.scene_words import ANY_LABEL, CYLINDER_KINDS
from tools.evaluate.skills import rooms
from tools.evaluate.skills.suite import ANY_END, Figure, SkillSuite, Trial, Verdict
from trees.tasks import FindTask, ObjectDescription, PickTask

KINDS = (
    *("cup", "can", "bottle", "teapot", "mug", "jar", "spanner", "torch", "sponge", "candle", "stapler"),
    *("kettle", "thermos", "carton", "trophy", "radio", "sprocket", "widget", "gnomon", "astrolabe"),
)
"""Of things: some that every list has, some of few, some of none."""
SORTS = ("snack", "drink", "toy", "tool", "souvenir", "groceries", "cleaning supply", "relic")
NOT_THERE = (
    "harmonica",
    "hammock",
    "accordion",
    "skateboard",
    "trombone",
    "wheelbarrow",
    "snorkel",
    "flimble",
)
"""Words for what no scene of this suite has; the last is no word at all."""
_SYLLABLES = ("zor", "blax", "mi", "tro", "ven", "lu", "kra", "pim", "sol", "dex", "ro", "fen", "gal", "nu")
_TAILS = ("crunch", "prime", "gold", "fresh", "mix", "plus", "one", "classic")
NAMED, OPEN, IN_COLOR = 0.6, 0.35, 0.4
"""Chances: that a thing has a name, that perception tells any word, that a colour is said with a kind."""
PICKED = 0.4
"""Chance that it is to be picked up, not only found."""
SAME_M = 0.10
"""Half of how far apart things stand."""
UNKNOWN_WITHIN_S = 1.0
BAR = 0.97


@dataclass(frozen=True, slots=True)
class NamingTrial(Trial):
    """One word that is said, and what it may mean.

    Attributes:
        fitting: Names in the scene of the things that bear it.
        unknown: Whether nothing bears it, and perception cannot tell it.
        by: How it means them: "name", "kind", "sort", "unknown".
    """

    fitting: tuple[str, ...] = ()
    unknown: bool = False
    by: str = ""


class NamingJudge:
    """The right thing was found, or somebody was asked; what cannot be told was said so at once."""

    def __init__(self, assembly: Assembly, trial: Trial, _rng: np.random.Generator) -> None:
        if not isinstance(trial, NamingTrial):
            raise TypeError(f"the suite of names judges its own trials, not {type(trial).__name__}")
        self._truth, self._trial = assembly.world.truth, trial
        self._world = assembly.session.toolbox.world
        self._asked, self._refused_s = False, math.inf
        self._began_s = self._truth.time_s

    def on_event(self, event: object) -> None:
        """Note questions and refusals."""
        self._asked = self._asked or isinstance(event, QuestionAsked)
        if isinstance(event, TaskRefused):
            self._refused_s = self._truth.time_s - self._began_s

    def on_period(self) -> None:
        """Nothing moves that is asked about."""

    def verdict(self, results: Sequence[TaskResult]) -> Verdict:
        """By what was told to be found, or went into a hand, and where that truly is.

        Who finds one of several that bear the word has found it; of what is picked up somebody says which.
        """
        trial, last = self._trial, results[-1]
        meant = self._meant_by_robot(last)
        numbers: dict[str, Figure] = {
            "by": trial.by,
            "fitting": len(trial.fitting),
            "asked": self._asked,
            "took_s": last.times.simulated_s,
        }
        if trial.unknown:
            answered_s = min(self._refused_s, last.times.simulated_s)
            fine = last.outcome != "done" and answered_s <= UNKNOWN_WITHIN_S
            numbers["answered_s"] = answered_s
            return Verdict(fine, numbers, "" if fine else f"{last.outcome} after {answered_s:.1f} s, {meant}")
        one_will_do = isinstance(trial.tasks[-1], FindTask) or len(trial.fitting) == 1
        right = one_will_do and meant in trial.fitting
        fine = right or (last.outcome == "question" and self._asked)
        why = "" if fine else f"{last.outcome}: {meant or 'nothing'}, meant {', '.join(trial.fitting)}"
        return Verdict(fine, numbers, why)

    def _meant_by_robot(self, result: TaskResult) -> str:
        """The true name of what the robot took for what is meant; empty for nothing."""
        held = self._truth.contacts.in_pads_only()
        if held:
            return sorted(held)[0]
        if "x_m" in result.evidence:
            return self._thing_at(np.array([float(result.evidence[f"{axis}_m"]) for axis in "xyz"]))
        item = self._world.scene.objects.get(result.acted_on or "")
        return "" if item is None else self._thing_at(item.world_T_object[:3, 3])

    def _thing_at(self, odom_m: Array) -> str:
        """What truly is where something is believed to be, shape (3,)."""
        at = (self._truth.world_T_odom() @ [*odom_m, 1.0])[:3]
        away = {
            name: float(np.linalg.norm(self._truth.world_T_object(name)[:3, 3] - at))
            for name in self._truth.objects()
        }
        nearest = min(away, key=away.__getitem__)
        return nearest if away[nearest] <= SAME_M else f"nothing that is there ({100 * away[nearest]:.0f} cm)"


def naming_trial(rng: np.random.Generator) -> NamingTrial:
    """Three to five things on a table, and a word that means one of them, several, or none."""
    table = rooms.table(rng)
    things: list[SceneItem] = []
    for number in range(int(rng.integers(3, 6))):
        place = rooms.spot(rng, table, things)
        if place is not None:
            things.append(_thing(number, table, place, things, rng))
    is_open = bool(rng.random() < OPEN)
    labels = (ANY_LABEL,) if is_open else ()
    scene = rooms.room("names", rng, [table], things, perception=PerceptionModel(labels=labels))
    by = str(rng.choice(["name", "kind", "sort", "unknown"], p=(0.35, 0.25, 0.2, 0.2)))
    by, words, fitting = _said(by, things, is_open, rng)
    if not fitting:
        words, by = NOT_THERE[int(rng.integers(len(NOT_THERE)))], "unknown"
    task: FindTask | PickTask = FindTask(f"find the {words}", ObjectDescription(words))
    if rng.random() < PICKED:
        task = PickTask(f"pick up the {words}", ObjectDescription(words))
    return NamingTrial(scene, (task,), words, task.text, fitting=fitting, unknown=not fitting, by=by)


def _said(
    by: str, things: Sequence[SceneItem], is_open: bool, rng: np.random.Generator
) -> tuple[str, str, tuple[str, ...]]:
    """How a thing is meant, the words for it, and all that bear them."""
    one = things[int(rng.integers(len(things)))]
    if by == "unknown" and not is_open:
        return by, "", ()
    if by == "name" and one.names:
        return by, one.names[0], tuple(item.name for item in things if one.names[0] in item.names)
    if by == "sort" and one.categories:
        sort = one.categories[0]
        return by, sort, tuple(item.name for item in things if sort in item.categories)
    if one.color is not None and rng.random() < IN_COLOR:
        alike = (item for item in things if (item.kind, item.color) == (one.kind, one.color))
        return "kind", f"{one.color} {one.kind}", tuple(item.name for item in alike)
    return "kind", one.kind, tuple(item.name for item in things if item.kind == one.kind)


def _thing(
    number: int,
    table: Furniture,
    place: tuple[float, float],
    others: Sequence[SceneItem],
    rng: np.random.Generator,
) -> SceneItem:
    """Of the kind of another one, now and then."""
    kind = KINDS[int(rng.integers(len(KINDS)))]
    if others and rng.random() < 0.25:
        kind = others[int(rng.integers(len(others)))].kind
    color = rooms.COLORS[int(rng.integers(len(rooms.COLORS)))]
    shape: Shape = Cylinder(float(rng.uniform(0.025, 0.038)), float(rng.uniform(0.08, 0.15)))
    if kind not in CYLINDER_KINDS and rng.random() < 0.5:
        x, y, z = (float(value) for value in rng.uniform((0.04, 0.04, 0.07), (0.07, 0.09, 0.14)))
        shape = Box((x, y, z))
    names = (_invented(rng),) if rng.random() < NAMED else ()
    sorts = tuple(SORTS[int(k)] for k in rng.permutation(len(SORTS))[: int(rng.integers(0, 3))])
    turn = poses.rotation_z(float(rng.uniform(-math.pi, math.pi)) if isinstance(shape, Box) else 0.0)
    pose = poses.transform(turn, (*place, table.size_m[2] + 0.5 * shape.height_m))
    return SceneItem(f"{color} {kind} {number + 1}", kind, color, shape, 0.3, 0.7, pose, None, names, sorts)


def _invented(rng: np.random.Generator) -> str:
    """A brand of one word or two."""
    first = "".join(_SYLLABLES[int(k)] for k in rng.integers(len(_SYLLABLES), size=int(rng.integers(2, 4))))
    return first if rng.random() < 0.3 else f"{first} {_TAILS[int(rng.integers(len(_TAILS)))]}"


NAMES = SkillSuite(naming_trial, NamingJudge, bar=BAR, ends=ANY_END)
