"""Suites of picks among things that nobody here made: ``things --scene FILE``, a scene that has them.

Of the scene's things some are drawn for each episode, and put down at random on a table that suits the robot.
One that a hand of it could take if it stood alone is asked for by its label. In ``in_place --scene FILE``
they stay where the scene has them, and the robot begins about where it has it stand.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from executive.session.assembly import Assembly
from executive.session.task_result import TaskResult
from kinematics.geometry import poses
from kinematics.geometry.shapes import Box
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import stance_at
from kinematics.planning.pick_planner import PickPlanner
from kinematics.requests.pick import PickPlan, PickRequest
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from robots.models.description import load_description
from robots.scenes.scene_description import Furniture, RobotStart, SceneItem
from robots.scenes.scene_file import load_scene
from tools.evaluate.skills import rooms
from tools.evaluate.skills.suite import SkillSuite, Trial, Verdict
from tools.evaluate.skills.watch import Bystanders
from trees.tasks import ObjectDescription, PickTask

LIFTED_M = 0.08
_COUNT = (2, 7)
_APART_M = 0.05
"""Left free between what holds two things."""
_LARGEST_M = 0.16
"""What reaches farther from its middle than this leaves no room for others."""
_DRAWS = 40
_TURNS, _ASIDE_M = 4, 0.2
_TOP_M, _WIDE_M, _MARGIN_M = 0.04, 1.2, 0.01
"""Of a table's top that a thing stands on alone, and what is kept from both."""
_START_OFF_M, _START_TURNED_RAD = 0.03, 0.05
_SMALL_M = 0.9
"""A humanoid whose base is lower than this at home stands before a low table."""


class ThingJudge:
    """Whether the thing is in a hand, above the table; what else was moved is counted."""

    def __init__(self, assembly: Assembly, trial: Trial, _rng: np.random.Generator) -> None:
        self._truth, self._aim = assembly.world.truth, trial.aim
        self._others = Bystanders(self._truth, [trial.aim])

    def on_event(self, event: object) -> None:
        """Nothing to learn from events."""

    def on_period(self) -> None:
        """Only the end counts."""

    def verdict(self, _results: Sequence[TaskResult]) -> Verdict:
        """Lifted, and touched by finger pads alone."""
        lift_m = self._truth.lift_m(self._aim)
        faults = {
            f"{self._aim} lifted by {100.0 * lift_m:.0f} cm": lift_m < LIFTED_M,
            f"{self._aim} is not in the fingers": self._aim not in self._truth.contacts.in_pads_only(),
        }
        wrong = [words for words, so in faults.items() if so]
        return Verdict(
            not wrong,
            {"thing": self._aim, "lift_m": lift_m, "moved": len(self._others.moved())},
            "; ".join(wrong),
        )


def things_trial(rng: np.random.Generator, scene: str, robot: str) -> Trial:
    """Some of a scene's things on a table, the first of them asked for.

    Raises:
        ValueError: The robot's hands can take none of them.
    """
    pool = load_scene(scene)
    hands = _hands_of(robot)
    where = hands.where
    table = rooms.table(rng, where)
    objects: list[SceneItem] = []
    wanted = int(rng.integers(_COUNT[0], _COUNT[1] + 1))
    for index in rng.permutation(len(pool.objects)):
        item = pool.objects[int(index)]
        if _named_alone(item, objects) and _radius_m(item) < _LARGEST_M and (objects or hands.take(item)):
            placed = _placed(rng, item, table, objects, where)
            objects += [] if placed is None else [placed]
        if len(objects) == wanted:
            break
    if not objects:
        raise ValueError(f"{scene}: the hands of {robot} can take nothing of what is in it")
    aim = objects[0].name
    said = f"pick up the {aim}"
    task = PickTask(said, ObjectDescription(name=aim))
    return Trial(rooms.room("things", rng, [table], objects), (task,), aim, sentence=said)


def _named_alone(item: SceneItem, others: Sequence[SceneItem]) -> bool:
    """Whether no other thing's name is a part of its own, or the other way round."""
    return not any(item.name in one.name or one.name in item.name for one in others if one is not item)


def in_place_trial(rng: np.random.Generator, scene: str, robot: str) -> Trial:
    """A scene as it is, and one of its things asked for.

    Raises:
        ValueError: The robot's hands can take none of them.
    """
    there, hands = load_scene(scene), _hands_of(robot)
    takeable = [item for item in there.objects if _named_alone(item, there.objects) and hands.take(item)]
    if not takeable:
        raise ValueError(f"{scene}: the hands of {robot} can take nothing of what is in it")
    aim = takeable[int(rng.integers(len(takeable)))].name
    off_m, start = rng.uniform(-_START_OFF_M, _START_OFF_M, 2), there.robot_start
    turned = start.yaw_rad + float(rng.uniform(-_START_TURNED_RAD, _START_TURNED_RAD))
    began = RobotStart(start.x_m + float(off_m[0]), start.y_m + float(off_m[1]), turned)
    said = f"pick up the {aim}"
    task = PickTask(said, ObjectDescription(name=aim))
    return Trial(replace(there, robot_start=began), (task,), aim, sentence=said)


class _Hands:
    """What a robot's hands can take of what stands alone before it, by its mesh.

    Args:
        robot: Its name.

    Attributes:
        where: What is within its reach.
    """

    def __init__(self, robot: str) -> None:
        self._model = model = RobotModel(load_description(robot))
        self.where = where = _workspace_of(model)
        self._stance, self._planner = stance_at(model, model.q_home), PickPlanner(model)
        edge_m, deep_m, self._high_m = (
            0.5 * sum(ends) for ends in (where.edge_ahead_m, where.table_depth_m, where.table_height_m)
        )
        self._ahead_m = edge_m + 0.5 * where.deepest_m
        at = poses.translation(edge_m + 0.5 * deep_m, 0.0, self._high_m - 0.5 * _TOP_M)
        top = SceneObject("top", Box((deep_m, _WIDE_M, _TOP_M)), at, _MARGIN_M, movable=False)
        self._scene = PlanningScene().with_object(top)
        self._known: dict[str, bool] = {}

    def take(self, item: SceneItem) -> bool:
        """Whether one can, turned some way or other."""
        known = item.mesh or item.name
        if known not in self._known:
            self._known[known] = any(
                self._taken(item, side, float(turn_rad))
                for turn_rad in np.linspace(0.0, math.pi, _TURNS, endpoint=False)
                for side in (_ASIDE_M, -_ASIDE_M)
            )
        return self._known[known]

    def _taken(self, item: SceneItem, aside_m: float, turn_rad: float) -> bool:
        place = (self._ahead_m, aside_m, self._high_m + 0.5 * item.shape.height_m)
        pose = poses.transform(poses.rotation_z(turn_rad), place)
        scene = self._scene.with_object(SceneObject(item.name, item.shape, pose, _MARGIN_M))
        hands = self._model.description.gripping_hands
        request = PickRequest(self._model.q_home, self._stance, scene, item.name, hands)
        return isinstance(self._planner.plan(request), PickPlan)


_hands_of = functools.lru_cache(maxsize=4)(_Hands)
"""A worker runs many episodes of one robot."""


def _workspace_of(model: RobotModel) -> rooms.Workspace:
    if model.description.welded:
        return rooms.BENCH
    return rooms.LOW if model.q_home[2] < _SMALL_M else rooms.STANDING


def _placed(
    rng: np.random.Generator,
    item: SceneItem,
    table: Furniture,
    others: Sequence[SceneItem],
    where: rooms.Workspace,
) -> SceneItem | None:
    """A thing somewhere on the table, turned at random; None when there is hardly any room."""
    for _ in range(_DRAWS):
        place = rooms.spot(rng, table, (), where=where)
        if place is None:
            return None
        free = all(
            math.dist(place, other.world_T_object[:2, 3]) > _radius_m(item) + _radius_m(other) + _APART_M
            for other in others
        )
        if free:
            turn = poses.rotation_z(float(rng.uniform(-math.pi, math.pi)))
            height = table.size_m[2] + 0.5 * item.shape.height_m
            return replace(item, world_T_object=poses.transform(turn, (*place, height)))
    return None


def _radius_m(item: SceneItem) -> float:
    """Of the upright cylinder that holds a thing."""
    shape = item.shape
    return 0.5 * math.hypot(*shape.size_m[:2]) if isinstance(shape, Box) else shape.radius_m


THINGS = SkillSuite(None, ThingJudge, bar=0.93, in_scene=things_trial)
IN_PLACE = SkillSuite(None, ThingJudge, bar=0.93, in_scene=in_place_trial, stands=False)
