"""Suite of put_in into a drawer: it is opened first, or stands open already."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from executive.session.assembly import Assembly
from executive.session.task_result import TaskResult
from kinematics.geometry import poses
from robots.scenes.articulated import (
    DRAWER_FRONT_HEIGHT_M,
    DRAWER_LENGTH_SHARE,
    DRAWER_OPENS_SHARE,
    FRONT_M,
    furniture_T_part,
    opened,
)
from robots.scenes.furniture import floor_pose
from robots.scenes.scene_description import Furniture, MovingPart, SceneItem
from tools.evaluate.skills import rooms
from tools.evaluate.skills.suite import SkillSuite, Trial, Verdict
from tools.evaluate.skills.watch import Bystanders
from trees.tasks import ObjectDescription, OpenTask, PutInTask, Task

DEPTH_M, WIDTH_M = 0.50, 0.45
AHEAD_M, ASIDE_M, HEIGHT_M = (0.70, 0.76), (0.30, 0.42), (0.98, 1.10)
MASS_KG, FRICTION_N = (2.0, 8.0), (5.0, 15.0)
OPEN_M = (0.24, 0.32)
FROM_EDGE_M = (0.07, 0.14)
ACROSS_M = 0.13
_OPEN_CHANCE = 0.5


class PutInDrawerJudge:
    """The object is in the drawer, behind its front, below its upper edge; nothing else moved."""

    def __init__(self, assembly: Assembly, trial: Trial, _rng: np.random.Generator) -> None:
        self._truth, self._trial = assembly.world.truth, trial
        self._piece = trial.scene.furniture[0]
        self._others = Bystanders(self._truth, [trial.aim])

    def on_event(self, event: object) -> None:
        """Nothing to learn from events."""

    def on_period(self) -> None:
        """Only the end counts."""

    def verdict(self, _results: Sequence[TaskResult]) -> Verdict:
        """Inside, let go, nothing else touched."""
        truth, piece, name = self._truth, self._piece, self._trial.aim
        opening_m = truth.opening(piece.name)
        world_T_drawer = floor_pose(piece) @ furniture_T_part(piece) @ opened(piece, opening_m)
        x, y, z = (poses.inverse(world_T_drawer) @ truth.world_T_object(name))[:3, 3]
        moved = self._others.moved()
        behind_front = 0.5 * FRONT_M < x < DRAWER_LENGTH_SHARE * piece.size_m[0]
        below_rim = abs(y) < 0.5 * piece.size_m[1] and abs(z) < 0.5 * DRAWER_FRONT_HEIGHT_M
        faults = {
            "not in the drawer": not (behind_front and below_rim),
            "still in the hand": any("gripper" in link for link in truth.contacts.of_object(name)),
            f"moved: {', '.join(sorted(moved))}": bool(moved),
        }
        wrong = [words for words, so in faults.items() if so]
        numbers = {"opening_m": opening_m, "tilt_rad": truth.tilt_rad(name)}
        return Verdict(not wrong, numbers, "; ".join(wrong))


def put_in_drawer_trial(rng: np.random.Generator) -> Trial:
    """A chest with one or two things on it; the drawer stands open, or is to be opened first."""

    def draw(low_high: tuple[float, float]) -> float:
        return float(rng.uniform(*low_high))

    stands_open = bool(rng.random() < _OPEN_CHANCE)
    part = MovingPart(
        hinge=None,
        mass_kg=draw(MASS_KG),
        friction=draw(FRICTION_N),
        locked=False,
        opening=min(draw(OPEN_M), DRAWER_OPENS_SHARE * DRAWER_LENGTH_SHARE * DEPTH_M) if stands_open else 0.0,
        handle_height_m=0.0,
        handle_inset_m=0.0,
        handle_radius_m=0.010,
        handle_length_m=0.16,
    )
    side = 1.0 if rng.random() < 0.5 else -1.0
    front, aside = draw(AHEAD_M), side * draw(ASIDE_M)
    place = (front + 0.5 * DEPTH_M, aside)
    chest = Furniture("chest", "drawers", (DEPTH_M, WIDTH_M, draw(HEIGHT_M)), place, 0.0, opens=part)
    across = rng.permutation(np.array([-ACROSS_M, ACROSS_M])) + rng.uniform(-0.03, 0.03, 2)
    objects: list[SceneItem] = []
    for number, y in enumerate(across[: int(rng.integers(1, 3))]):
        kind = ("cup", "can")[int(rng.integers(2))]
        spot = (front + draw(FROM_EDGE_M), aside + float(y))
        shape = rooms.shape_of(kind, rng)
        color = rooms.COLORS[number]
        objects.append(rooms.item(f"{color} {kind}", kind, color, shape, chest, spot, rng))
    item = objects[0]
    meant = ObjectDescription(item.kind, item.color)
    put = PutInTask(f"put the {item.name} in the drawer", meant, "drawer")
    tasks: tuple[Task, ...] = (put,)
    if not stands_open:
        tasks = (OpenTask("open the drawer", ObjectDescription("drawer")), put)
    return Trial(rooms.room("put_in_drawer", rng, [chest], objects), tasks, item.name)


PUT_IN_DRAWER = SkillSuite(put_in_drawer_trial, PutInDrawerJudge)
