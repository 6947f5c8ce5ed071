"""Suite of putting down what nobody here made, on a table or into what is open: ``put_things --scene FILE``.

It goes into something of the scene's own that is open at the top where there is such a thing, in every other
episode; else into a box or a bowl of ours.
"""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from executive.session.assembly import Assembly
from kinematics.geometry import poses
from kinematics.geometry.shapes import Box
from kinematics.scene.free_spots import footprint_radius_m
from robots.scenes.scene_description import Furniture, SceneItem
from robots.scenes.scene_file import load_scene
from tools.evaluate.skills import rooms
from tools.evaluate.skills.placing import PlaceJudge
from tools.evaluate.skills.putting_in import PutInJudge, container_on
from tools.evaluate.skills.suite import SkillJudge, SkillSuite, Trial
from tools.evaluate.upon.takeable import hands_of, workspace_of
from tools.evaluate.upon.things import drawn
from trees.tasks import ObjectDescription, PickTask, PlaceTask, PutInTask, Task

_COUNT = (1, 4)
_INTO_CHANCE, _OWN_CHANCE, _HELD_CHANCE = 0.5, 0.5, 0.6
_MIDDLE, _FLOOR = 0.5, 0.35
"""A thing is open at the top where nothing in its middle, as wide as the first share of its width, is higher
than the second of its height."""
_ROOM_M = 0.01
_LEAST_WIDE_M, _MOST_WIDE_M = 0.12, 0.36


def put_things_trial(rng: np.random.Generator, scene: str, robot: str) -> Trial:
    """Some of a scene's things on a table, the first of them to be put down.

    Raises:
        ValueError: The robot's hands can take none of them.
    """
    where = workspace_of(hands_of(robot).model)
    table = rooms.table(rng, where)
    count = int(rng.integers(_COUNT[0], _COUNT[1] + 1))
    into = bool(rng.random() < _INTO_CHANCE)
    there = [_container(rng, scene, table, where)] if into else []
    objects = drawn(
        rng, scene, robot, table, there, count, lambda item: all(_fits(item, one) for one in there)
    )
    aim = objects[0].name
    meant = ObjectDescription(name=aim)
    if into:
        said = f"put the {aim} into the {there[0].name}"
        put: Task = PutInTask(said, meant, ObjectDescription(name=there[0].name))
    else:
        said = f"put the {aim} on the table"
        put = PlaceTask(said, meant, on="table")
    first = (PickTask(f"pick up the {aim}", meant),) if rng.random() < _HELD_CHANCE else ()
    room = rooms.room("put_things", rng, [table], [*there, *objects])
    return Trial(room, (put,), aim, sentence=said, first=first)


def _container(rng: np.random.Generator, scene: str, table: Furniture, where: rooms.Workspace) -> SceneItem:
    ours = container_on(table, rng, where)
    own = [item for item in load_scene(scene).objects if is_open_at_the_top(item)]
    if not own or rng.random() >= _OWN_CHANCE:
        return ours
    item = own[int(rng.integers(len(own)))]
    turn = poses.rotation_z(float(rng.uniform(-math.pi, math.pi)))
    x, y, _ = ours.world_T_object[:3, 3].tolist()
    pose = poses.transform(turn, (x, y, table.size_m[2] + 0.5 * item.shape.height_m))
    return replace(item, world_T_object=pose)


def _fits(item: SceneItem, container: SceneItem) -> bool:
    """Whether a thing goes into what is open at the top, however it is turned, with a centimetre around."""
    return footprint_radius_m(item.shape) + _ROOM_M < 0.5 * _width_m(container)


def _width_m(item: SceneItem) -> float:
    return min(item.shape.size_m[:2]) if isinstance(item.shape, Box) else 2.0 * item.shape.radius_m


def is_open_at_the_top(item: SceneItem) -> bool:
    """Whether a thing of a mesh is as wide as a bowl, and empty from above down to near its bottom."""
    shape = item.shape
    wide_m = _width_m(item)
    if shape.parts is None or not _LEAST_WIDE_M < wide_m < _MOST_WIDE_M:
        return False
    surface = shape.parts.surface
    near = np.linalg.norm(surface[:, :2], axis=1) < 0.5 * _MIDDLE * wide_m
    return bool(near.any()) and float(surface[near, 2].max()) < (_FLOOR - 0.5) * shape.height_m


def _judge(assembly: Assembly, trial: Trial, rng: np.random.Generator) -> SkillJudge:
    judge = PutInJudge if isinstance(trial.tasks[-1], PutInTask) else PlaceJudge
    return judge(assembly, trial, rng)


PUT_THINGS = SkillSuite(None, _judge, bar=0.9, in_scene=put_things_trial)
