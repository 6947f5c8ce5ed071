"""Suites of picks among things that nobody here made: ``things --scene FILE``, a scene that has them.

Of the scene's things some are drawn for each episode, and put down at random on a table that suits the robot.
One that a hand of it could take if it stood alone is asked for by its label. In ``in_place --scene FILE``
they stay where the scene has them, and the robot begins about where it has it stand.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from executive.session.assembly import Assembly
from executive.session.task_result import TaskResult
from kinematics.geometry import poses
from kinematics.geometry.shapes import Box
from robots.scenes.scene_description import Furniture, RobotStart, SceneItem
from robots.scenes.scene_file import load_scene
from robots.scenes.scene_rules import START_HALF_WIDTH_M, START_REACH_M
from tools.evaluate.skills import rooms
from tools.evaluate.skills.suite import SkillSuite, Trial, Verdict
from tools.evaluate.skills.watch import Bystanders
from tools.evaluate.upon.takeable import asked_for_in, bolted_before, hands_of, named_alone, workspace_of
from trees.tasks import ObjectDescription, PickTask

LIFTED_M = 0.08
_COUNT = (2, 7)
_APART_M = 0.05
"""Left free between what holds two things."""
_LARGEST_M = 0.16
"""What reaches farther from its middle than this leaves no room for others."""
_TALL_M, _HANDS_M = 0.2, 0.2
"""What is taller than the first stands so much farther ahead: hands begin over the edge of a table."""
_START_M = START_REACH_M[1] + rooms.START_OFFSET_M + START_HALF_WIDTH_M * math.sin(rooms.START_YAW_RAD)
"""How far ahead a robot is at most that begins beside its place, and turned."""
_DRAWS = 40
_START_OFF_M, _START_TURNED_RAD = 0.03, 0.05


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
    where = workspace_of(hands_of(robot).model)
    table = rooms.table(rng, where)
    wanted = int(rng.integers(_COUNT[0], _COUNT[1] + 1))
    objects = drawn(rng, scene, robot, table, [], wanted)
    aim = objects[0].name
    said = f"pick up the {aim}"
    task = PickTask(said, ObjectDescription(name=aim))
    return Trial(rooms.room("things", rng, [table], objects), (task,), aim, sentence=said)


def drawn(
    rng: np.random.Generator,
    scene: str,
    robot: str,
    table: Furniture,
    there: Sequence[SceneItem],
    wanted: int,
    suits: Callable[[SceneItem], bool] = lambda _item: True,
) -> list[SceneItem]:
    """Some of a scene's things somewhere on a table; a hand can take the first of them.

    Args:
        rng: Draws them.
        scene: Name or file of the scene that has them.
        robot: Whose hands are to take the first.
        table: Where they are put.
        there: What stands on it already.
        wanted: How many, where there is room.
        suits: Whether what is to be done can be done with a thing; the first one suits.

    Raises:
        ValueError: The robot's hands can take none of them, or there is no room for one.
    """
    pool, hands = load_scene(scene), hands_of(robot)
    where = workspace_of(hands.model)
    objects: list[SceneItem] = []
    for index in rng.permutation(len(pool.objects)):
        item = pool.objects[int(index)]
        if (
            named_alone(item, [*there, *objects])
            and _radius_m(item) < _LARGEST_M
            and (objects or (suits(item) and hands.take_alone(item)))
        ):
            placed = _placed(rng, item, table, [*there, *objects], where)
            objects += [] if placed is None else [placed]
        if len(objects) == wanted:
            break
    if not objects:
        raise ValueError(f"{scene}: the hands of {robot} can take nothing of what is in it")
    return objects


def in_place_trial(rng: np.random.Generator, scene: str, robot: str) -> Trial:
    """A scene as it is, and one of its things asked for; an arm is bolted down where it reaches that.

    Raises:
        ValueError: The robot's hands can take none of them.
    """
    there, takeable = load_scene(scene), asked_for_in(scene, robot)
    aim = takeable[int(rng.integers(len(takeable)))]
    start = there.robot_start
    if hands_of(robot).model.description.welded:
        start = bolted_before(next(item for item in there.objects if item.name == aim), there)[0]
    off_m = rng.uniform(-_START_OFF_M, _START_OFF_M, 2)
    turned = start.yaw_rad + float(rng.uniform(-_START_TURNED_RAD, _START_TURNED_RAD))
    began = RobotStart(start.x_m + float(off_m[0]), start.y_m + float(off_m[1]), turned)
    said = f"pick up the {aim}"
    task = PickTask(said, ObjectDescription(name=aim))
    return Trial(replace(there, robot_start=began), (task,), aim, sentence=said)


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
        before_m = _START_M + (_HANDS_M if item.shape.height_m > _TALL_M else 0.0)
        free = place[0] - _radius_m(item) > before_m and all(
            math.dist(place, other.world_T_object[:2, 3]) > _radius_m(item) + _radius_m(other) + _APART_M
            for other in others
        )
        if free:
            turn = poses.rotation_z(float(rng.uniform(-math.pi, math.pi)))
            height = table.size_m[2] + 0.5 * item.shape.height_m
            return replace(item, world_T_object=poses.transform(turn, (*place, height)))
    return None


def _radius_m(item: SceneItem) -> float:
    """Of the upright cylinder that holds a thing; what sticks out of an outline counts."""
    shape = item.shape
    if shape.parts is not None:
        return float(np.linalg.norm(shape.parts.corners[:, :2], axis=1).max())
    return 0.5 * math.hypot(*shape.size_m[:2]) if isinstance(shape, Box) else shape.radius_m


THINGS = SkillSuite(None, ThingJudge, bar=0.93, in_scene=things_trial)
IN_PLACE = SkillSuite(None, ThingJudge, bar=0.93, in_scene=in_place_trial, stands=False)
