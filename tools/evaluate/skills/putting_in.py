"""Suite of put_in: into an open box or a bowl on the table."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

import numpy as np

from executive.session.assembly import Assembly
from executive.session.task_result import TaskResult
from kinematics.geometry import poses
from kinematics.geometry.shapes import Box, Cylinder, Shape
from robots.scenes.scene_description import Furniture, SceneItem
from tools.evaluate.skills import rooms
from tools.evaluate.skills.suite import SkillSuite, Trial, Verdict
from tools.evaluate.skills.watch import TIPPED_RAD, Bystanders
from trees.tasks import ObjectDescription, PickTask, PutInTask, Task

PUSHED_M = 0.02
BOX_M = ((0.15, 0.15, 0.07), (0.20, 0.20, 0.11))
BOWL_RADIUS_M, BOWL_HEIGHT_M = (0.085, 0.105), (0.06, 0.085)
WALL_M = 0.006
CONTAINER_KG = (0.4, 0.9)
_BOWL_CHANCE = 0.4
_HELD_CHANCE = 0.6


class PutInJudge:
    """The object is between the walls, the container where it was."""

    def __init__(self, assembly: Assembly, trial: Trial, _rng: np.random.Generator) -> None:
        self._truth, self._trial = assembly.world.truth, trial
        self._container = container_of(trial)
        grippers = assembly.model.description.grippers.values()
        self._fingers = {link for gripper in grippers for link in gripper.links}
        self._stood = self._truth.world_T_object(self._container.name)
        self._others = Bystanders(self._truth, [trial.aim, self._container.name, *trial.given])

    def on_event(self, event: object) -> None:
        """Nothing to learn from events."""

    def on_period(self) -> None:
        """Only the end counts."""

    def verdict(self, _results: Sequence[TaskResult]) -> Verdict:
        """Inside, with nothing pushed."""
        truth, container = self._truth, self._container
        now = truth.world_T_object(container.name)
        local = (poses.inverse(now) @ truth.world_T_object(self._trial.aim))[:3, 3]
        shape = container.shape
        if isinstance(shape, Box):
            inside = bool(np.all(np.abs(local[:2]) <= 0.5 * np.array(shape.size_m[:2])))
        else:
            inside = float(np.linalg.norm(local[:2])) <= shape.radius_m
        pushed_m = float(np.linalg.norm((now - self._stood)[:3, 3]))
        moved = self._others.moved()
        held = bool(self._fingers & set(truth.contacts.of_object(self._trial.aim)))
        faults = {
            "beside it": not inside,
            "over its rim": truth.lowest_m(self._trial.aim) > float(now[2, 3]) + 0.5 * shape.height_m,
            f"pushed the container by {1e3 * pushed_m:.0f} mm": pushed_m > PUSHED_M,
            "tipped the container": truth.tilt_rad(container.name) > TIPPED_RAD,
            "still in the hand": held,
            f"moved: {', '.join(sorted(moved))}": bool(moved),
        }
        wrong = [words for words, so in faults.items() if so]
        return Verdict(not wrong, {"pushed_m": pushed_m}, "; ".join(wrong))


def container_of(trial: Trial) -> SceneItem:
    """What something is put into."""
    task = trial.tasks[-1]
    assert isinstance(task, PutInTask)
    assert isinstance(task.to, ObjectDescription)
    to = task.to
    if to.name is not None:
        return next(item for item in trial.scene.objects if item.name == to.name)
    return next(item for item in trial.scene.objects if (item.kind, item.color) == (to.kind, to.color))


def put_in_trial(rng: np.random.Generator, where: rooms.Workspace = rooms.STANDING) -> Trial:
    """A table with a container, something that fits in, and perhaps other things."""
    table = rooms.table(rng, where)
    container = container_on(table, rng, where)
    objects = [container]
    for number in range(int(rng.integers(1, 4))):
        kind = ("cup", "can")[int(rng.integers(2))]
        place = rooms.spot(rng, table, objects, 0.24, where)
        if place is not None:
            shape = rooms.shape_of(kind, rng, where)
            color = rooms.COLORS[number]
            objects.append(rooms.item(f"{color} {kind}", kind, color, shape, table, place, rng))
    if len(objects) < 2:
        return put_in_trial(rng, where)
    item = objects[1]
    meant = ObjectDescription(item.kind, item.color)
    words = f"put the {item.name} into the {container.name}"
    put = PutInTask(words, meant, ObjectDescription(container.kind, container.color))
    tasks: tuple[Task, ...] = (put,)
    if rng.random() < _HELD_CHANCE:
        tasks = (PickTask(f"pick up the {item.name}", meant), put)
    return Trial(rooms.room("put_in", rng, [table], objects), tasks, item.name)


def container_on(
    table: Furniture, rng: np.random.Generator, where: rooms.Workspace = rooms.STANDING
) -> SceneItem:
    """An open box or a bowl on a table."""
    shape: Shape
    if rng.random() < _BOWL_CHANCE:
        kind, color = "bowl", "white"
        shape = Cylinder(float(rng.uniform(*BOWL_RADIUS_M)), float(rng.uniform(*BOWL_HEIGHT_M)))
    else:
        kind, color = "box", "brown"
        x, y, z = (float(value) for value in rng.uniform(*BOX_M))
        shape = Box((x, y, z))
    edge = table.position_m[0] - 0.5 * table.size_m[0]
    ahead_m = float(rng.uniform(*where.container_ahead_m))
    place = (edge + ahead_m, float(rng.uniform(-where.container_aside_m, where.container_aside_m)))
    pose = poses.transform(
        poses.rotation_z(float(rng.uniform(-0.5, 0.5)) if kind == "box" else 0.0),
        (*place, table.size_m[2] + 0.5 * shape.height_m),
    )
    mass = float(rng.uniform(*CONTAINER_KG))
    return SceneItem(f"{color} {kind}", kind, color, shape, mass, 0.7, pose, WALL_M)


PUT_IN = SkillSuite(
    put_in_trial,
    PutInJudge,
    on_bench=partial(put_in_trial, where=rooms.BENCH),
    on_low=partial(put_in_trial, where=rooms.LOW),
)
