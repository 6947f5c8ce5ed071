"""Suite of place: on a table, or beside something on it."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from functools import partial

import numpy as np

from executive.session.assembly import Assembly
from executive.session.task_result import TaskResult
from kinematics.geometry import poses
from kinematics.geometry.shapes import Box
from robots.scenes.scene_description import Furniture, SceneItem
from tools.evaluate.skills import rooms
from tools.evaluate.skills.room_beside import has_room
from tools.evaluate.skills.suite import Figure, SkillSuite, Trial, Verdict
from tools.evaluate.skills.watch import Bystanders
from trees.events import Measured
from trees.tasks import ObjectDescription, PickTask, PlaceTask, Relation, RelationKind, Task

OFF_M = 0.02
TURNED_RAD = math.radians(5.0)
STANDING_M = 0.005
# Beside something: no farther from it than this, and so near to the named direction.
BESIDE_M = 0.30
DIRECTION_RAD = math.radians(50.0)
RELATIONS: tuple[RelationKind, ...] = ("left_of", "right_of", "in_front_of", "behind", "next_to")
_AHEAD = {"left_of": 0.5 * math.pi, "right_of": -0.5 * math.pi, "in_front_of": math.pi, "behind": 0.0}
_BESIDE_CHANCE = 0.5
_SQUARE_M = 0.004
"""A box whose edges differ by less than this is square to whoever sees it."""
_HELD_CHANCE = 0.7


class PlaceJudge:
    """Compares where the object stands with the robot's last plan, and with what was asked."""

    def __init__(self, assembly: Assembly, trial: Trial, _rng: np.random.Generator) -> None:
        self._truth, self._trial = assembly.world.truth, trial
        self._gripped = assembly.model.description.grippers
        self._others = Bystanders(self._truth, [trial.aim, *trial.given])
        self._world = assembly.session.toolbox.world
        self._plan: Mapping[str, Figure] = {}
        self._believed: Box | None = None

    def on_event(self, event: object) -> None:
        """The last plan of a place counts."""
        if isinstance(event, Measured) and event.where.endswith("plan place"):
            self._plan = dict(event.numbers)
            self._believed = self._believed_box()

    def _believed_box(self) -> Box | None:
        """The box in a hand as it is believed to be; the other hand may hold something as well."""
        aim = next(one for one in self._trial.scene.objects if one.name == self._trial.aim)
        for held in self._world.scene.attached.values():
            shape, label = held.body.shape, held.body.label
            if isinstance(shape, Box) and label is not None and label.color == aim.color:
                return shape
        return None

    def on_period(self) -> None:
        """Only the end counts."""

    def verdict(self, _results: Sequence[TaskResult]) -> Verdict:
        """Where it was meant to be, upright, let go, and nothing else moved."""
        if not self._plan:
            return Verdict(False, {}, "never planned")
        name = self._trial.aim
        pose = self._truth.world_T_object(name)
        planned = self._truth.world_T_odom() @ poses.transform(
            poses.rotation_z(float(self._plan["yaw_rad"])),
            (float(self._plan["x_m"]), float(self._plan["y_m"]), float(self._plan["z_m"])),
        )
        off_m = float(np.linalg.norm((pose - planned)[:2, 3]))
        item = next(one for one in self._trial.scene.objects if one.name == name)
        turned = 0.0
        if isinstance(item.shape, Box):
            yaw_rad = poses.yaw_of(planned[:3, :3].T @ pose[:3, :3])
            turned = turned_rad(item.shape, yaw_rad, self._believed)
        tilt, lift_m = self._truth.tilt_rad(name), self._truth.lift_m(name)
        touching = self._truth.contacts.of_object(name)
        pads = {link for gripper in self._gripped.values() for link in gripper.touch_links}
        moved = self._others.moved()
        faults = {
            f"{1e3 * off_m:.0f} mm from the plan": off_m > OFF_M,
            f"turned by {math.degrees(turned):.0f} degrees": turned > TURNED_RAD,
            f"leans by {math.degrees(tilt):.0f} degrees": tilt > TURNED_RAD,
            f"{1e3 * lift_m:.0f} mm above the table": abs(lift_m) > STANDING_M,
            "still in the hand": bool(pads & set(touching)),
            f"moved: {', '.join(sorted(moved))}": bool(moved),
            "not beside what was named": not self._as_asked(item),
        }
        wrong = [words for words, so in faults.items() if so]
        numbers = {"off_m": off_m, "turned_rad": turned, "tilt_rad": tilt}
        return Verdict(not wrong, numbers, "; ".join(wrong))

    def _as_asked(self, item: SceneItem) -> bool:
        task = self._trial.tasks[-1]
        to = getattr(task, "to", None)
        if not isinstance(to, ObjectDescription) or to.relation is None:
            return True
        reference = to.relation.to
        assert isinstance(reference, ObjectDescription)
        other = self._truth.world_T_object(f"{reference.color} {reference.kind}")[:2, 3]
        way = self._truth.world_T_object(item.name)[:2, 3] - other
        if float(np.linalg.norm(way)) > BESIDE_M:
            return False
        if to.relation.kind == "next_to":
            return True
        heading = self._trial.scene.robot_start.yaw_rad + _AHEAD[to.relation.kind]
        off = math.remainder(math.atan2(way[1], way[0]) - heading, 2.0 * math.pi)
        return abs(off) <= DIRECTION_RAD


def turned_rad(box: Box, yaw_rad: float, believed: Box | None = None) -> float:
    """By how much a plain box looks turned: half a turn is none, nor is a quarter of a square one.

    Args:
        box: As it is.
        yaw_rad: From the frame in which it is believed to be to its own one.
        believed: As it is believed to be: its frame's x is along what is y of the other where that is longer.
    """
    longer_m, seen_m = (one.size_m[0] - one.size_m[1] for one in (box, believed or box))
    if longer_m * seen_m < 0.0:
        yaw_rad += 0.5 * math.pi
    same_rad = 0.5 * math.pi if min(abs(longer_m), abs(seen_m)) < _SQUARE_M else math.pi
    return abs(math.remainder(yaw_rad, same_rad))


def place_trial(rng: np.random.Generator, where: rooms.Workspace = rooms.STANDING) -> Trial:
    """A table with two to four things; one of them is put where there is room by the truth."""
    table = rooms.table(rng, where)
    objects = rooms.things(rng, table, int(rng.integers(2, 5)), where=where)
    item = objects[0]
    meant = _meant(item)
    kind = None
    if len(objects) > 1 and rng.random() < _BESIDE_CHANCE:
        kind = _with_room(int(rng.integers(len(RELATIONS))), objects, table, where.farthest_m)
    if kind is not None:
        to = ObjectDescription(relation=Relation(kind, _meant(objects[1])))
        words = f"{kind.replace('_', ' ')} the {objects[1].name}"
        place = PlaceTask(f"put the {item.name} {words}", meant, to=to)
    else:
        place = PlaceTask(f"put the {item.name} on the table", meant, on="table")
    tasks: tuple[Task, ...] = (place,)
    if rng.random() < _HELD_CHANCE:
        tasks = (PickTask(f"pick up the {item.name}", meant), place)
    return Trial(rooms.room("place", rng, [table], objects), tasks, item.name)


def _with_room(
    drawn: int, objects: Sequence[SceneItem], table: Furniture, farthest_m: float
) -> RelationKind | None:
    """The relation that was drawn, or else the next in turn for which there is room; None without any."""
    for kind in RELATIONS[drawn:] + RELATIONS[:drawn]:
        headings = [_AHEAD[kind]] if kind in _AHEAD else list(_AHEAD.values())
        if has_room(objects[0], objects[1], objects, table, headings, DIRECTION_RAD, BESIDE_M, farthest_m):
            return kind
    return None


def _meant(item: SceneItem) -> ObjectDescription:
    return ObjectDescription(item.kind, item.color)


PLACE = SkillSuite(
    place_trial,
    PlaceJudge,
    on_bench=partial(place_trial, where=rooms.BENCH),
    on_low=partial(place_trial, where=rooms.LOW),
)
