"""Suites of find, count and describe."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import partial

import numpy as np

from executive.session.assembly import Assembly
from executive.session.task_result import TaskResult
from kinematics.geometry import poses
from kinematics.geometry.shapes import Box, Cylinder
from robots.scenes.scene_description import Furniture, PerceptionModel, SceneItem
from tools.evaluate.skills import rooms
from tools.evaluate.skills.suite import SkillSuite, Trial, Verdict
from trees.tasks import CountTask, DescribeTask, FindTask, ObjectDescription

NO_NOISE = PerceptionModel(
    bias_m=0.0,
    noise_m=0.0,
    orientation_noise_rad=0.0,
    size_noise=0.0,
    dropout=0.0,
    false_rate=0.0,
    merge_chance=0.0,
)
FOUND_M = 0.05
_HIDDEN_CHANCE = 0.6


class AnswerJudge:
    """Compares what was told with what is there."""

    def __init__(self, assembly: Assembly, trial: Trial, _rng: np.random.Generator) -> None:
        self._truth, self._trial = assembly.world.truth, trial

    def on_event(self, event: object) -> None:
        """The evidence says it all."""

    def on_period(self) -> None:
        """Nothing moves but the robot."""

    def verdict(self, results: Sequence[TaskResult]) -> Verdict:
        """The number, the names, or the place."""
        task, evidence = self._trial.tasks[-1], results[-1].evidence
        confidence = float(evidence.get("confidence", 0.0))
        if isinstance(task, FindTask):
            return self._found(evidence, confidence)
        objects = self._trial.scene.objects
        if isinstance(task, CountTask):
            wanted = task.object
            there = [o for o in objects if o.kind == wanted.kind and wanted.color in (None, o.color)]
            told = int(evidence.get("count", -1))
            why = "" if told == len(there) else f"told {told}, there are {len(there)}"
            return Verdict(not why, {"told": told, "there": len(there), "confidence": confidence}, why)
        names = sorted(name for name in str(evidence.get("names", "")).split(", ") if name)
        seen = sorted(name.rstrip("0123456789 ") for name in names)
        real = sorted(f"{o.color} {o.kind}" for o in objects)
        why = "" if seen == real else f"told {seen}, there are {real}"
        return Verdict(not why, {"told": len(seen), "there": len(real), "confidence": confidence}, why)

    def _found(self, evidence: object, confidence: float) -> Verdict:
        told = dict(evidence) if isinstance(evidence, dict) else {}
        if "x_m" not in told:
            return Verdict(False, {"confidence": confidence}, "not found")
        odom = self._truth.world_T_odom()
        point = odom @ np.array([float(told["x_m"]), float(told["y_m"]), float(told["z_m"]), 1.0])
        off_m = float(np.linalg.norm(point[:3] - self._truth.world_T_object(self._trial.aim)[:3, 3]))
        why = "" if off_m <= FOUND_M else f"told {off_m:.2f} m beside it"
        return Verdict(not why, {"off_m": off_m, "confidence": confidence}, why)


def count_trial(rng: np.random.Generator, where: rooms.Workspace = rooms.STANDING) -> Trial:
    """Some things, of which several are alike; perception without noise in half of the episodes."""
    table, objects = _many(rng, where)
    alike = objects[int(rng.integers(len(objects)))]
    color = alike.color if rng.random() < 0.5 else None
    kind = alike.kind if rng.random() < 0.9 else "ball"
    noise = NO_NOISE if rng.random() < 0.5 else None
    scene = rooms.room("count", rng, [table], objects, perception=noise)
    task = CountTask(f"how many {color or ''} {kind}s are there", ObjectDescription(kind, color))
    return Trial(scene, (task,))


def describe_trial(rng: np.random.Generator, where: rooms.Workspace = rooms.STANDING) -> Trial:
    """Some things on a table; perception without noise in half of the episodes."""
    table, objects = _many(rng, where)
    noise = NO_NOISE if rng.random() < 0.5 else None
    scene = rooms.room("describe", rng, [table], objects, perception=noise)
    return Trial(scene, (DescribeTask("what is on the table", source="table"),))


def find_trial(rng: np.random.Generator, where: rooms.Workspace = rooms.STANDING) -> Trial:
    """Something on a table, in most episodes right behind something larger."""
    table = rooms.table(rng, where)
    objects = rooms.things(rng, table, 1, ("cup", "can"), where)
    target = objects[0]
    if rng.random() < _HIDDEN_CHANCE:
        hider = _hider(rng, target, table)
        if hider is not None:
            objects = [target, hider]
    scene = rooms.room("find", rng, [table], objects)
    meant = ObjectDescription(target.kind, target.color)
    return Trial(scene, (FindTask(f"find the {target.name}", meant),), target.name)


def _hider(rng: np.random.Generator, target: SceneItem, table: Furniture) -> SceneItem | None:
    """A box between the robot's eyes and the target."""
    x, y = (float(value) for value in target.world_T_object[:2, 3])
    far = math.hypot(x, y)
    size = Box((0.06, float(rng.uniform(0.12, 0.20)), float(rng.uniform(0.20, 0.30))))
    assert isinstance(target.shape, Cylinder)
    apart = 0.03 + target.shape.radius_m + float(rng.uniform(0.02, 0.06))
    edge = table.position_m[0] - 0.5 * table.size_m[0]
    place = ((far - apart) / far * x, (far - apart) / far * y)
    if place[0] - 0.09 < edge:
        return None
    made = rooms.item("brown box", "box", "brown", size, table, place, rng)
    turn = math.atan2(y, x)
    pose = made.world_T_object.copy()
    pose[:3, :3] = poses.rotation_z(turn)
    return SceneItem(made.name, "box", "brown", size, 1.0, made.friction, pose)


def _many(rng: np.random.Generator, where: rooms.Workspace) -> tuple[Furniture, list[SceneItem]]:
    table = rooms.table(rng, where)
    objects: list[SceneItem] = []
    looks = [(kind, color) for kind in ("cup", "box", "can") for color in ("red", "blue", "green")]
    for number in range(int(rng.integers(1, 7))):
        kind, color = looks[int(rng.integers(len(looks)))]
        place = rooms.spot(rng, table, objects, 0.14, where)
        if place is not None:
            shape = rooms.shape_of(kind, rng, where)
            objects.append(rooms.item(f"{color} {kind} {number + 1}", kind, color, shape, table, place, rng))
    return table, objects


FIND = SkillSuite(
    find_trial,
    AnswerJudge,
    on_bench=partial(find_trial, where=rooms.BENCH),
    on_low=partial(find_trial, where=rooms.LOW),
)
COUNT = SkillSuite(
    count_trial,
    AnswerJudge,
    on_bench=partial(count_trial, where=rooms.BENCH),
    on_low=partial(count_trial, where=rooms.LOW),
)
DESCRIBE = SkillSuite(
    describe_trial,
    AnswerJudge,
    on_bench=partial(describe_trial, where=rooms.BENCH),
    on_low=partial(describe_trial, where=rooms.LOW),
)
