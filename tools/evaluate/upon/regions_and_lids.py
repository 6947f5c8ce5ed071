"""Suite of named parts of furniture that things are put on or into, and of lids that close what is open."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from executive.session.assembly import Assembly
from executive.session.task_result import TaskResult
from kinematics.arrays import Array
from kinematics.geometry import poses
from kinematics.geometry.shapes import Box, Cylinder, Shape
from robots.scenes.fixture import FixedBox
from robots.scenes.furniture import floor_pose
from robots.scenes.furniture_names import FIXTURE
from robots.scenes.named_region import NamedRegion
from robots.scenes.scene_description import Furniture, SceneItem
from tools.evaluate.skills import rooms
from tools.evaluate.skills.suite import SkillJudge, SkillSuite, Trial, Verdict
from tools.evaluate.skills.watch import TIPPED_RAD, Bystanders
from tools.evaluate.upon.stacking import StackJudge
from trees.tasks import ObjectDescription, PickTask, PlaceTask, PutInTask, Task

RESTS_M = 0.004
WALL_M = 0.006
_HELD_CHANCE = 0.5
_AHEAD_M, _ASIDE_M = (0.15, 0.22), 0.2
_STOVE_M = ((0.18, 0.34, 0.03), (0.24, 0.42, 0.06))
_CADDY_M = ((0.15, 0.28, 0.06), (0.18, 0.34, 0.09))
_BURNER_M = 0.15
_POT_RADIUS_M, _POT_HEIGHT_M, _POT_WALL_M = (0.028, 0.031), (0.07, 0.10), 0.004
_LID_WIDER_M, _LID_HEIGHT_M = 0.007, (0.04, 0.05)


class RegionJudge:
    """The thing is over the part that was named, on it or between its walls, and let go."""

    def __init__(self, assembly: Assembly, trial: Trial, _rng: np.random.Generator) -> None:
        self._truth, self._trial = assembly.world.truth, trial
        self._piece, self._region = region_of(trial)
        self._into = isinstance(trial.tasks[-1], PutInTask)
        self._others = Bystanders(self._truth, [trial.aim, *trial.given])

    def on_event(self, event: object) -> None:
        """Nothing to learn from events."""

    def on_period(self) -> None:
        """Only the end counts."""

    def verdict(self, _results: Sequence[TaskResult]) -> Verdict:
        """Within the part along the floor; on it upright, or below the rim."""
        truth, aim, region = self._truth, self._trial.aim, self._region
        local = poses.inverse(floor_pose(self._piece)) @ truth.world_T_object(aim)
        off = np.abs(local[:2, 3] - region.position_m[:2])
        above_m = truth.lowest_m(aim) - region.position_m[2]
        touching, moved = truth.contacts.of_object(aim), self._others.moved()
        faults = {
            f"not in the {region.name}": bool(np.any(off > 0.5 * np.array(region.size_m[:2]))),
            f"touches {', '.join(touching) or 'nothing'}": not self._by_furniture_alone(touching),
            f"moved: {', '.join(sorted(moved))}": bool(moved),
        }
        if self._into:
            faults[f"over the rim, {1e3 * above_m:.0f} mm above its floor"] = (
                above_m > region.size_m[2] - 0.01
            )
        else:
            faults[f"{1e3 * above_m:.0f} mm above it"] = abs(above_m) > RESTS_M
            faults["leans"] = truth.tilt_rad(aim) > TIPPED_RAD
        wrong = [words for words, so in faults.items() if so]
        return Verdict(not wrong, {"off_m": float(off.max())}, "; ".join(wrong))

    def _by_furniture_alone(self, touching: Sequence[str]) -> bool:
        pieces = {piece.name for piece in self._trial.scene.furniture}
        return bool(touching) and {name.split("/", 1)[0] for name in touching} <= pieces


def region_of(trial: Trial) -> tuple[Furniture, NamedRegion]:
    """The part that the last task names, with its piece."""
    task = trial.tasks[-1]
    to = task.to if isinstance(task, PutInTask) else getattr(task, "on", None)
    assert isinstance(to, ObjectDescription)
    pieces = trial.scene.furniture
    return next((piece, part) for piece in pieces for part in piece.regions if part.name == to.kind)


def _judge(assembly: Assembly, trial: Trial, rng: np.random.Generator) -> SkillJudge:
    has_region = any(piece.regions for piece in trial.scene.furniture)
    return RegionJudge(assembly, trial, rng) if has_region else StackJudge(assembly, trial, rng)


def stove(rng: np.random.Generator, table: Furniture) -> Furniture:
    """A flat stove on a table, with two burners."""
    size = rng.uniform(*_STOVE_M)
    top = table.size_m[2] + float(size[2])
    aside = 0.25 * float(size[1])
    burners = tuple(
        NamedRegion(f"{side} burner", (_BURNER_M, _BURNER_M, 0.01), (0.0, sign * aside, top))
        for side, sign in (("left", 1.0), ("right", -1.0))
    )
    return _fixture("stove", rng, table, size, (), burners)


def caddy(rng: np.random.Generator, table: Furniture) -> Furniture:
    """Two compartments side by side on a table, open at the top."""
    size = rng.uniform(*_CADDY_M)
    deep, wide, high = (float(value) for value in size)
    foot = table.size_m[2]
    walls = [FixedBox((deep, wide, WALL_M), (0.0, 0.0, foot + 0.5 * WALL_M))]
    tall, middle = high - WALL_M, foot + WALL_M + 0.5 * (high - WALL_M)
    across = (0.5 * (wide - WALL_M), 0.0, -0.5 * (wide - WALL_M))
    walls += [FixedBox((deep, WALL_M, tall), (0.0, y, middle)) for y in across]
    along = (0.5 * (deep - WALL_M), -0.5 * (deep - WALL_M))
    walls += [FixedBox((WALL_M, wide, tall), (x, 0.0, middle)) for x in along]
    room = (deep - 2.0 * WALL_M, 0.5 * (wide - 3.0 * WALL_M), tall)
    parts = tuple(
        NamedRegion(f"{side} compartment", room, (0.0, sign * 0.5 * (room[1] + WALL_M), foot + WALL_M))
        for side, sign in (("left", 1.0), ("right", -1.0))
    )
    return _fixture("caddy", rng, table, size, tuple(walls), parts)


def _fixture(
    name: str,
    rng: np.random.Generator,
    table: Furniture,
    size: Array,
    boxes: tuple[FixedBox, ...],
    regions: tuple[NamedRegion, ...],
) -> Furniture:
    deep, wide, high = (float(value) for value in size)
    edge = table.position_m[0] - 0.5 * table.size_m[0]
    place = (edge + float(rng.uniform(*_AHEAD_M)), float(rng.uniform(-_ASIDE_M, _ASIDE_M)))
    foot = table.size_m[2]
    yaw = float(rng.uniform(-0.2, 0.2))
    return Furniture(
        name, FIXTURE, (deep, wide, foot + high), place, yaw, foot_m=foot, boxes=boxes, regions=regions
    )


def _beside(
    rng: np.random.Generator, table: Furniture, piece: Furniture, count: int
) -> list[SceneItem] | None:
    """Cups and cans on a table, beside a piece that stands on it."""
    away_m = 0.5 * math.hypot(*piece.size_m[:2]) + 0.06
    objects: list[SceneItem] = []
    for number in range(count):
        kind = ("cup", "can")[int(rng.integers(2))]
        place = rooms.spot(rng, table, objects, 0.2)
        if place is None or math.dist(place, piece.position_m) < away_m:
            continue
        color, shape = rooms.COLORS[number], rooms.shape_of(kind, rng)
        objects.append(rooms.item(f"{color} {kind}", kind, color, shape, table, place, rng))
    return objects or None


def region_trial(rng: np.random.Generator) -> Trial:
    """Something is put on a burner, or into a compartment."""
    table = rooms.table(rng)
    into = bool(rng.random() < 0.5)
    piece = caddy(rng, table) if into else stove(rng, table)
    objects = _beside(rng, table, piece, int(rng.integers(2, 5)))
    if objects is None:
        return region_trial(rng)
    item, part = objects[0], piece.regions[int(rng.integers(2))]
    meant, to = ObjectDescription(item.kind, item.color), ObjectDescription(part.name)
    words = f"put the {item.name} {'into' if into else 'on'} the {part.name}"
    put: Task = PutInTask(words, meant, to) if into else PlaceTask(words, meant, on=to)
    tasks: tuple[Task, ...] = (put,)
    if rng.random() < _HELD_CHANCE:
        tasks = (PickTask(f"pick up the {item.name}", meant), put)
    return Trial(rooms.room("regions", rng, [table, piece], objects), tasks, item.name)


def lid_trial(rng: np.random.Generator) -> Trial:
    """A lid is put on what is open at the top."""
    table = rooms.table(rng)
    radius = float(rng.uniform(*_POT_RADIUS_M))
    place = rooms.spot(rng, table, [])
    assert place is not None
    pot_shape: Shape = Cylinder(radius, float(rng.uniform(*_POT_HEIGHT_M)))
    if round_pot := bool(rng.random() < 0.5):
        lid_shape: Shape = Cylinder(radius + _LID_WIDER_M, float(rng.uniform(*_LID_HEIGHT_M)))
    else:
        long = radius + float(rng.uniform(0.005, 0.015))
        pot_shape = Box((2.0 * radius, 2.0 * long, pot_shape.height_m))
        wide, deep = 2.0 * (radius + _LID_WIDER_M), 2.0 * (long + _LID_WIDER_M)
        lid_shape = Box((wide, deep, float(rng.uniform(*_LID_HEIGHT_M))))
    kind = "bowl" if round_pot else "box"
    solid = rooms.item(f"white {kind}", kind, "white", pot_shape, table, place, rng)
    pot = SceneItem(solid.name, kind, "white", pot_shape, 0.5, 0.7, solid.world_T_object, _POT_WALL_M)
    beside = rooms.spot(rng, table, [pot], 0.24)
    if beside is None:
        return lid_trial(rng)
    lid = rooms.item("red lid", "lid", "red", lid_shape, table, beside, rng)
    meant = ObjectDescription("lid", "red")
    put = PlaceTask(f"put the lid on the {pot.name}", meant, on=ObjectDescription(kind, "white"))
    return Trial(rooms.room("lids", rng, [table], [pot, lid]), (put,), lid.name)


def trial(rng: np.random.Generator) -> Trial:
    """A named part, or each third time a lid."""
    return lid_trial(rng) if rng.random() < 1.0 / 3.0 else region_trial(rng)


REGIONS = SkillSuite(trial, _judge, bar=0.75)
