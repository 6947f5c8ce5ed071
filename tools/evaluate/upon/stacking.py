"""Suite of stacking: one thing on top of another."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from executive.session.assembly import Assembly
from executive.session.task_result import TaskResult
from kinematics.geometry.shapes import Box, Cylinder, Shape
from robots.scenes.scene_description import SceneItem
from tools.evaluate.skills import rooms
from tools.evaluate.skills.suite import SkillSuite, Trial, Verdict
from tools.evaluate.skills.watch import TIPPED_RAD, Bystanders
from trees.tasks import ObjectDescription, PickTask, PlaceTask, Task

PUSHED_M = 0.02
OFF_M = 0.02
RESTS_M = 0.004
BASES: tuple[tuple[str, tuple[float, float, float], tuple[float, float, float]], ...] = (
    ("box", (0.06, 0.06, 0.05), (0.12, 0.12, 0.12)),
    ("can", (0.033, 0.0, 0.08), (0.05, 0.0, 0.12)),
    ("plate", (0.08, 0.0, 0.015), (0.11, 0.0, 0.025)),
)
"""Kind, and its smallest and largest size: of a box its edges, of what is round its radius and height."""
_HELD_CHANCE = 0.5


class StackJudge:
    """The thing rests on the other one, and on nothing else, which stands where it stood."""

    def __init__(self, assembly: Assembly, trial: Trial, _rng: np.random.Generator) -> None:
        self._truth, self._trial = assembly.world.truth, trial
        self._base = base_of(trial)
        self._stood = self._truth.world_T_object(self._base.name)
        self._others = Bystanders(self._truth, [trial.aim, self._base.name, *trial.given])

    def on_event(self, event: object) -> None:
        """Nothing to learn from events."""

    def on_period(self) -> None:
        """Only the end counts."""

    def verdict(self, _results: Sequence[TaskResult]) -> Verdict:
        """Resting on it, upright, let go, and nothing pushed."""
        truth, aim, base = self._truth, self._trial.aim, self._base
        now, thing = truth.world_T_object(base.name), truth.world_T_object(aim)
        off_m = float(np.linalg.norm((thing - now)[:2, 3]))
        above_m = truth.lowest_m(aim) - (float(now[2, 3]) + 0.5 * base.shape.height_m)
        pushed_m = float(np.linalg.norm((now - self._stood)[:3, 3]))
        touching, moved = truth.contacts.of_object(aim), self._others.moved()
        faults = {
            f"{1e3 * above_m:.0f} mm above its top": abs(above_m) > RESTS_M,
            f"touches {', '.join(touching) or 'nothing'}": set(touching) != {base.name},
            f"{1e3 * off_m:.0f} mm from its middle": off_m > reach_m(base.shape),
            "leans": truth.tilt_rad(aim) > TIPPED_RAD,
            f"pushed what is below by {1e3 * pushed_m:.0f} mm": pushed_m > PUSHED_M,
            "tipped what is below": truth.tilt_rad(base.name) > TIPPED_RAD,
            f"moved: {', '.join(sorted(moved))}": bool(moved),
        }
        wrong = [words for words, so in faults.items() if so]
        return Verdict(not wrong, {"off_m": off_m, "pushed_m": pushed_m}, "; ".join(wrong))


def reach_m(shape: Shape) -> float:
    """How far from the middle of a top something may stand on it."""
    half_m = 0.5 * min(shape.size_m[:2]) if isinstance(shape, Box) else shape.radius_m
    return max(OFF_M, half_m)


def base_of(trial: Trial) -> SceneItem:
    """What something is put on."""
    on = trial.tasks[-1].on if isinstance(trial.tasks[-1], PlaceTask) else None
    assert isinstance(on, ObjectDescription)
    return next(item for item in trial.scene.objects if (item.kind, item.color) == (on.kind, on.color))


def stack_trial(rng: np.random.Generator) -> Trial:
    """A table with something flat at the top, something to put on it, and perhaps other things."""
    table = rooms.table(rng)
    kind, low, high = BASES[int(rng.integers(len(BASES)))]
    x, y, z = (float(value) for value in rng.uniform(low, high))
    shape: Shape = Box((x, y, z)) if kind == "box" else Cylinder(x, z)
    place = rooms.spot(rng, table, [])
    if place is None:
        return stack_trial(rng)
    base = rooms.item(f"white {kind}", kind, "white", shape, table, place, rng)
    objects = [base]
    for number in range(int(rng.integers(1, 4))):
        called = ("cup", "can", "box")[int(rng.integers(3))]
        place = rooms.spot(rng, table, objects, 0.24)
        if place is not None:
            color = rooms.COLORS[number]
            size = rooms.shape_of(called, rng)
            objects.append(rooms.item(f"{color} {called}", called, color, size, table, place, rng))
    if len(objects) < 2:
        return stack_trial(rng)
    item = objects[1]
    meant = ObjectDescription(item.kind, item.color)
    words = f"put the {item.name} on the {base.name}"
    put = PlaceTask(words, meant, on=ObjectDescription(base.kind, base.color))
    tasks: tuple[Task, ...] = (put,)
    if rng.random() < _HELD_CHANCE:
        tasks = (PickTask(f"pick up the {item.name}", meant), put)
    return Trial(rooms.room("stack", rng, [table], objects), tasks, item.name)


STACK = SkillSuite(stack_trial, StackJudge, bar=0.85)
