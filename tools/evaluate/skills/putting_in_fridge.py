"""Suite of put_in behind a door: what stands on a table, or is in a hand, goes onto a board of a fridge."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Literal

import numpy as np

from executive.session.assembly import Assembly
from executive.session.task_result import TaskResult
from kinematics.geometry import poses
from kinematics.geometry.shapes import Cylinder
from robots.scenes.articulated import fixed_boxes
from robots.scenes.furniture import floor_pose
from robots.scenes.scene_description import Furniture, MovingPart, SceneItem
from tools.evaluate.skills import rooms
from tools.evaluate.skills.suite import Figure, SkillSuite, Trial, Verdict
from tools.evaluate.skills.watch import Bystanders
from tools.evaluate.skills.way_walked import WayWalked
from trees.tasks import ObjectDescription, PickTask, PutInTask

Side = Literal["left", "right"]

FAR_M = (2.3, 2.8)
BEARING_RAD = (math.radians(80.0), math.radians(150.0))
TURNED_RAD = 0.2
SIZE_M = ((0.60, 0.56, 1.60), (0.68, 0.64, 1.80))
MASS_KG, FRICTION_NM, SEAL_N = (8.0, 20.0), (1.0, 3.0), (20.0, 40.0)
HANDLE_HEIGHT_M = (0.95, 1.10)
OPEN_RAD = (math.radians(68.0), math.radians(75.0))
STANDS_RAD = math.radians(5.0)
ON_BOARD_M = 0.005
_OPEN_CHANCE = _HELD_CHANCE = _FILLED_CHANCE = 0.5


class PutInFridgeJudge:
    """The object stands on a board behind the door; nothing else was moved."""

    def __init__(self, assembly: Assembly, trial: Trial, _rng: np.random.Generator) -> None:
        self._truth, self._trial = assembly.world.truth, trial
        self._piece = _fridge_of(trial)
        self._others = Bystanders(self._truth, [trial.aim])
        self._way = WayWalked(assembly)

    def on_event(self, event: object) -> None:
        """Nothing to learn from events."""

    def on_period(self) -> None:
        """Add up the way that was walked."""
        self._way.on_period()

    def verdict(self, results: Sequence[TaskResult]) -> Verdict:
        """On a board, upright, let go, nothing else touched."""
        truth, name, piece = self._truth, self._trial.aim, self._piece
        local = poses.inverse(floor_pose(piece)) @ truth.world_T_object(name)
        lowest_m, tilt_rad = truth.lowest_m(name), truth.tilt_rad(name)
        on = [
            board
            for board, size, place in _boards(piece)
            if abs(local[0, 3] - place[0]) < 0.5 * size[0]
            and abs(local[1, 3] - place[1]) < 0.5 * size[1]
            and abs(lowest_m - place[2] - 0.5 * size[2]) <= ON_BOARD_M
        ]
        moved = self._others.moved()
        faults = {
            "on no board of the fridge": not on,
            f"leans by {math.degrees(tilt_rad):.0f} degrees": tilt_rad > STANDS_RAD,
            "still in the hand": any("gripper" in link for link in truth.contacts.of_object(name)),
            f"moved: {', '.join(sorted(moved))}": bool(moved),
        }
        wrong = [words for words, so in faults.items() if so]
        numbers: dict[str, Figure] = {
            "board": on[0] if on else "",
            "tilt_rad": tilt_rad,
            "opening_deg": math.degrees(truth.opening(piece.name)),
            "walked_m": self._way.length_m,
            "tasks": ", ".join(result.action for result in results),
        }
        return Verdict(not wrong, numbers, "; ".join(wrong))


def put_in_fridge_trial(rng: np.random.Generator, always_open: bool = False) -> Trial:
    """A table ahead with a few things on it, and a fridge to one side or behind, shut or open."""
    table = rooms.table(rng)
    objects = rooms.things(rng, table, int(rng.integers(1, 4)), ("cup", "can"))
    item = objects[0]
    hinge: Side = "left" if rng.random() < 0.5 else "right"
    held, shut = bool(rng.random() < _HELD_CHANCE), bool(rng.random() >= _OPEN_CHANCE) and not always_open
    hand: Side | None = None
    if held and shut:  # one hand holds it, the other one is on the side of the hinge
        hand = "left" if item.world_T_object[1, 3] > 0.0 else "right"
        hinge = "right" if hand == "left" else "left"
    fridge = _fridge(rng, hinge, shut)
    if rng.random() < _FILLED_CHANCE:
        objects.append(_bottle_in(fridge, rng))
    meant = ObjectDescription(item.kind, item.color)
    sentence = f"put the {item.name} into the fridge"
    first = (PickTask(f"pick up the {item.name}", meant, hand=hand),) if held else ()
    tasks = (PutInTask(sentence, meant, "fridge"),)
    scene = rooms.room("put_in_fridge", rng, [table, fridge], objects)
    return Trial(scene, tasks, item.name, sentence, first)


def _fridge(rng: np.random.Generator, hinge: Side, shut: bool) -> Furniture:
    def draw(low_high: tuple[float, float]) -> float:
        return float(rng.uniform(*low_high))

    side = 1.0 if rng.random() < 0.5 else -1.0
    bearing, far = side * draw(BEARING_RAD), draw(FAR_M)
    depth, width, height = (float(value) for value in rng.uniform(*SIZE_M))
    part = MovingPart(
        hinge=hinge,
        mass_kg=draw(MASS_KG),
        friction=draw(FRICTION_NM),
        seal_n=draw(SEAL_N),
        opening=0.0 if shut else draw(OPEN_RAD),
        handle_height_m=draw(HANDLE_HEIGHT_M),
    )
    place = (far * math.cos(bearing), far * math.sin(bearing))
    yaw = bearing + draw((-TURNED_RAD, TURNED_RAD))
    return Furniture("fridge", "fridge", (depth, width, height), place, yaw, opens=part)


def _bottle_in(fridge: Furniture, rng: np.random.Generator) -> SceneItem:
    """A bottle towards one side of the upper board."""
    _, size, place = _boards(fridge)[-1]
    shape = Cylinder(float(rng.uniform(0.028, 0.036)), float(rng.uniform(0.15, 0.20)))
    deep = float(rng.uniform(0.08, 0.20))
    aside = float(rng.uniform(0.12, 0.5 * size[1] - 0.05)) * (1.0 if rng.random() < 0.5 else -1.0)
    top_m = place[2] + 0.5 * size[2]
    spot = poses.translation(place[0] - 0.5 * size[0] + deep, aside, top_m + 0.5 * shape.height_m)
    pose = floor_pose(fridge) @ spot
    return SceneItem("black bottle", "bottle", "black", shape, float(rng.uniform(0.2, 0.5)), 0.6, pose)


def _boards(
    piece: Furniture,
) -> list[tuple[str, tuple[float, float, float], tuple[float, float, float]]]:
    return [box for box in fixed_boxes(piece) if box[0].startswith("shelf")]


def _fridge_of(trial: Trial) -> Furniture:
    return next(piece for piece in trial.scene.furniture if piece.kind == "fridge")


PUT_IN_FRIDGE = SkillSuite(put_in_fridge_trial, PutInFridgeJudge, stands=False)
