"""Suite of doors and drawers of fixtures that stand on a table, drawn at random or those of a scene's pieces.

Each episode opens one of a piece's doors and drawers, or closes one that is open, as a person says it: "open
the middle drawer of the cabinet".
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import Literal

import numpy as np

from executive.session.assembly import Assembly
from executive.session.task_result import TaskResult
from robots.scenes.fixture import Control, FixedBox, Size
from robots.scenes.furniture_names import FIXTURE
from robots.scenes.opening import Bar, Opening
from robots.scenes.scene_description import Furniture
from robots.scenes.scene_file import load_scene
from tools.evaluate.opening.scenes import BENCH_DRAWERS
from tools.evaluate.skills import rooms
from tools.evaluate.skills.suite import Figure, SkillSuite, Trial, Verdict
from tools.evaluate.upon.takeable import hands_of, workspace_of
from trees.beliefs.openings.handles import OPEN_ENOUGH, OPEN_TO
from trees.tasks import CloseTask, ObjectDescription, OpenTask

SHARE = 0.75
"""What is opened so far, of its way or of what is usual, is open."""
SHUT = {"drawer": 0.02, "door": math.radians(3.0)}
_OPEN_SHARE = (0.5, 0.85)
_CLOSES = 0.4
_CLEAR_OF_DOOR_M = 0.10
"""What is open begins so much farther away: nobody stands in a door."""
_BEHIND_EDGE_M, _ASIDE_M, _TURNED_RAD = (0.06, 0.14), 0.25, 0.3
_BEFORE_ARM_M = 0.15
"""So much farther from one that is bolted down: it does not reach back to its own foot."""
_FOOT_M = (0.06, 0.12)
"""Of a cabinet: a hand that takes a bar reaches below it."""
_NAMES = {1: ("",), 2: ("top ", "bottom "), 3: ("top ", "middle ", "bottom ")}
_WALL_M = 0.008
_SIZE_M = ((0.18, 0.20), (0.28, 0.34))
"""Depth and width, the least and the most."""
_FRONT_M, _DOOR_M = (0.09, 0.15), (0.20, 0.32)
"""Heights of a drawer's front, and of a door."""
_STANDOFF_M, _RADIUS_M, _LENGTH_M = (0.028, 0.045), (0.005, 0.009), (0.08, 0.13)


class OpeningJudge:
    """How far the door or drawer is open at the end, and whether another one was moved."""

    def __init__(self, assembly: Assembly, trial: Trial, _rng: np.random.Generator) -> None:
        self._truth, self._aim = assembly.world.truth, trial.aim
        self._opens = isinstance(trial.tasks[-1], OpenTask)
        piece = next(one for one in trial.scene.furniture if one.openings)
        self._parts = {f"{piece.name}/{one.name}": one for one in piece.openings}

    def on_event(self, event: object) -> None:
        """Nothing to learn from events."""

    def on_period(self) -> None:
        """The end counts."""

    def verdict(self, results: Sequence[TaskResult]) -> Verdict:
        """Open far enough, or shut; and the others as they were."""
        part = self._parts[self._aim]
        opening = self._truth.opening(self._aim)
        enough = SHARE * min(OPEN_TO[part.kind], part.travel)
        done = opening >= min(enough, OPEN_ENOUGH[part.kind]) if self._opens else opening <= SHUT[part.kind]
        moved = [
            name
            for name, one in self._parts.items()
            if name != self._aim and abs(self._truth.opening(name) - one.opening) > SHUT[one.kind]
        ]
        faults = {f"open by {opening:.3f} of {part.travel:.2f}": not done, f"moved: {moved}": bool(moved)}
        wrong = [words for words, so in faults.items() if so]
        numbers: dict[str, Figure] = {
            "part": self._aim,
            "opening": opening,
            "took_s": results[-1].times.simulated_s,
        }
        return Verdict(not wrong, numbers, "; ".join(wrong))


def opening_trial(rng: np.random.Generator) -> Trial:
    """Drawers or a door of any size, before a humanoid."""
    return _trial(rng, _drawn(rng), rooms.STANDING)


def bench_trial(rng: np.random.Generator) -> Trial:
    """The same before an arm that is bolted down."""
    return _trial(rng, _drawn(rng), rooms.BENCH)


def low_trial(rng: np.random.Generator) -> Trial:
    """The same before a small humanoid."""
    return _trial(rng, _drawn(rng), rooms.LOW)


def scene_trial(rng: np.random.Generator, scene: str, robot: str) -> Trial:
    """One of a scene's pieces with doors or drawers, put on a table.

    Raises:
        ValueError: The scene has none.
    """
    pieces = [one for one in load_scene(scene).furniture if any(part.bar for part in one.openings)]
    if not pieces:
        raise ValueError(f"{scene}: it has no fixture with a door or drawer that has a handle")
    return _trial(rng, pieces[int(rng.integers(len(pieces)))], workspace_of(hands_of(robot).model))


def _trial(rng: np.random.Generator, piece: Furniture, where: rooms.Workspace) -> Trial:
    table = rooms.table(rng, where)
    closes = bool(rng.random() < _CLOSES)
    farther_m = (_CLEAR_OF_DOOR_M if closes else 0.0) + (_BEFORE_ARM_M if where is rooms.BENCH else 0.0)
    there = _placed(rng, piece, table, farther_m)
    with_bars = [one for one in there.openings if one.bar is not None]
    part = with_bars[int(rng.integers(len(with_bars)))]
    if closes:
        usual = min(OPEN_TO[part.kind], part.travel)
        part = replace(part, opening=float(rng.uniform(*_OPEN_SHARE)) * usual)
    openings = tuple(part if one.name == part.name else one for one in there.openings)
    there = replace(there, openings=openings)
    thing = f"the {part.name} of the {piece.name}" if len(openings) > 1 else f"the {piece.name}"
    said = f"{'close' if closes else 'open'} {thing}"
    meant = ObjectDescription(part.kind)
    task = CloseTask(said, meant) if closes else OpenTask(said, meant)
    scene = rooms.room("openings", rng, [table, there])
    if where is rooms.BENCH:
        scene = replace(scene, cameras=load_scene(BENCH_DRAWERS).cameras)
    return Trial(scene, (task,), f"{there.name}/{part.name}", sentence=said, opened=there.name)


def _placed(rng: np.random.Generator, piece: Furniture, table: Furniture, farther_m: float) -> Furniture:
    """A piece on a table, its front near the edge, turned a little."""
    up_m = table.size_m[2] - piece.foot_m
    edge_m = table.position_m[0] - 0.5 * table.size_m[0]
    ahead_m = edge_m + 0.5 * piece.size_m[0] + float(rng.uniform(*_BEHIND_EDGE_M)) + farther_m
    deep, wide, high = piece.size_m

    def raised(place: Size) -> Size:
        return place[0], place[1], place[2] + up_m

    def box(one: FixedBox) -> FixedBox:
        return FixedBox(one.size_m, raised(one.position_m))

    def opening(one: Opening) -> Opening:
        bar = None if one.bar is None else replace(one.bar, position_m=raised(one.bar.position_m))
        return replace(one, boxes=tuple(map(box, one.boxes)), bar=bar)

    def control(one: Control) -> Control:
        return replace(one, position_m=raised(one.position_m))

    return replace(
        piece,
        size_m=(deep, wide, high + up_m),
        position_m=(ahead_m, float(rng.uniform(-_ASIDE_M, _ASIDE_M))),
        yaw_rad=float(rng.uniform(-_TURNED_RAD, _TURNED_RAD)),
        foot_m=table.size_m[2],
        boxes=tuple(map(box, piece.boxes)),
        controls=tuple(map(control, piece.controls)),
        openings=tuple(map(opening, piece.openings)),
        regions=(),
    )


def _drawn(rng: np.random.Generator) -> Furniture:
    """One, two or three drawers above each other, or a box with a door."""
    deep, wide = (float(value) for value in rng.uniform(*_SIZE_M))
    if rng.random() < 0.5:
        count = int(rng.integers(1, 4))
        high = float(rng.uniform(*_FRONT_M))
        fronts = [(f"{name}drawer", high) for name in _NAMES[count]]
        foot = float(rng.uniform(*_FOOT_M))
        drawers = [_drawer(rng, k, fronts, deep, wide, foot) for k in range(count)]
        return _carcass("cabinet", deep, wide, drawers)
    high = float(rng.uniform(*_DOOR_M))
    return _carcass("microwave", deep, wide, [_door(rng, deep, wide, high)])


def _carcass(name: str, deep: float, wide: float, openings: list[Opening]) -> Furniture:
    """Bottom, top, sides and back, open at the front where the parts are; on a foot where drawers are low."""
    high = max(one.boxes[0].position_m[2] + 0.5 * one.boxes[0].size_m[2] for one in openings) + _WALL_M
    low = min(one.boxes[0].position_m[2] - 0.5 * one.boxes[0].size_m[2] for one in openings)
    side, middle = 0.5 * (wide - _WALL_M), 0.5 * high
    back = 0.5 * (deep - _WALL_M)
    boxes = (
        FixedBox((deep, wide, _WALL_M), (0.0, 0.0, high - 0.5 * _WALL_M)),
        FixedBox((deep, wide, low), (0.0, 0.0, 0.5 * low)),
        FixedBox((deep, _WALL_M, high), (0.0, side, middle)),
        FixedBox((deep, _WALL_M, high), (0.0, -side, middle)),
        FixedBox((_WALL_M, wide, high), (back, 0.0, middle)),
    )
    return Furniture(name, FIXTURE, (deep, wide, high), (0.0, 0.0), boxes=boxes, openings=tuple(openings))


def _front(deep: float, wide: float, low: float, high: float) -> FixedBox:
    return FixedBox((0.012, wide, high), (-0.5 * deep - 0.007, 0.0, low + 0.5 * high))


def _bar(rng: np.random.Generator, front: FixedBox, aside_m: float, upright: bool) -> Bar:
    out_m = float(rng.uniform(*_STANDOFF_M))
    x, _, z = front.position_m
    place = (x - 0.5 * front.size_m[0] - out_m, aside_m, z)
    return Bar(place, float(rng.uniform(*_LENGTH_M)), float(rng.uniform(*_RADIUS_M)), upright)


def _drawer(
    rng: np.random.Generator,
    row: int,
    fronts: Sequence[tuple[str, float]],
    deep: float,
    wide: float,
    foot: float,
) -> Opening:
    name, high = fronts[row]
    low = foot + (len(fronts) - 1 - row) * (high + 0.002)
    front = _front(deep, wide, low, high)
    long, inner, walls = 0.85 * deep, wide - 4.0 * _WALL_M, 0.6 * high
    x, z = -0.5 * deep + 0.5 * long, low + 0.5 * walls
    boxes = (
        front,
        FixedBox((long, inner, 0.004), (x, 0.0, low + 0.01)),
        FixedBox((long, 0.004, walls), (x, 0.5 * inner, z)),
        FixedBox((long, 0.004, walls), (x, -0.5 * inner, z)),
        FixedBox((0.004, inner, walls), (x + 0.5 * long, 0.0, z)),
    )
    bar = _bar(rng, front, float(rng.uniform(-0.05, 0.05)), upright=False)
    friction = float(rng.uniform(0.5, 6.0))
    return Opening(name, "drawer", 0.8 * long, boxes, bar, mass_kg=1.0, friction=friction)


def _door(rng: np.random.Generator, deep: float, wide: float, high: float) -> Opening:
    front = _front(deep, wide, _WALL_M, high)
    hinge: Literal["left", "right"] = ("left", "right")[int(rng.integers(2))]
    free = -1.0 if hinge == "left" else 1.0
    bar = _bar(rng, front, free * (0.5 * wide - float(rng.uniform(0.02, 0.05))), upright=True)
    friction = float(rng.uniform(0.1, 1.0))
    return Opening("door", "door", 1.7, (front,), bar, hinge, mass_kg=1.2, friction=friction)


OPENINGS = SkillSuite(
    opening_trial,
    OpeningJudge,
    stands=False,
    bar=0.85,
    on_bench=bench_trial,
    on_low=low_trial,
    in_scene=scene_trial,
)
