"""Suites of errands in the flat: walk somewhere, and do something there."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Sequence

import numpy as np

from executive.assembly import Assembly
from executive.task_result import TaskResult
from robots.articulated import moving_part
from robots.scene_description import RobotStart, SceneDescription
from robots.scene_file import dump, load_scene, read_scene
from tools.evaluate.skills.goals import feet_of
from tools.evaluate.skills.suite import SkillSuite, Trial, Verdict
from trees.handles import OPEN_ENOUGH
from trees.tasks import ObjectDescription, OpenTask, PickTask, WalkToTask

START_M, START_RAD = 0.35, 0.6
PERSON_M = 0.25
MASS_KG, FRICTION_NM, SEAL_N = (8.0, 20.0), (1.0, 3.0), (20.0, 40.0)
HANDLE_HEIGHT_M = (0.95, 1.10)
OBJECT_M = 0.05
LIFTED_M = 0.08


def flat(rng: np.random.Generator) -> SceneDescription:
    """The flat, with the robot, the people, the door and the things on the table as they happen to be."""
    scene = load_scene("flat")

    def off(most: float) -> float:
        return float(rng.uniform(-most, most))

    start = RobotStart(off(START_M), off(START_M), off(START_RAD))
    furniture = []
    for piece in scene.furniture:
        if piece.opens is not None:
            part = dataclasses.replace(
                moving_part(piece),
                mass_kg=float(rng.uniform(*MASS_KG)),
                friction=float(rng.uniform(*FRICTION_NM)),
                seal_n=float(rng.uniform(*SEAL_N)),
                handle_height_m=float(rng.uniform(*HANDLE_HEIGHT_M)),
            )
            piece = dataclasses.replace(piece, opens=part)
        furniture.append(piece)
    people = tuple(
        dataclasses.replace(
            person,
            position_m=(person.position_m[0] + off(PERSON_M), person.position_m[1] + off(PERSON_M)),
            yaw_rad=off(math.pi),
        )
        for person in scene.people
    )
    objects = []
    for item in scene.objects:
        pose = item.world_T_object.copy()
        if item.name != "green bottle":
            pose[:2, 3] += (off(OBJECT_M), off(OBJECT_M))
        objects.append(dataclasses.replace(item, world_T_object=pose))
    made = dataclasses.replace(
        scene, robot_start=start, furniture=tuple(furniture), people=people, objects=tuple(objects)
    )
    return read_scene(dump(made), "episode in the flat", "flat")


class _ErrandJudge:
    """Notes how far the robot went."""

    def __init__(self, assembly: Assembly, trial: Trial, _rng: np.random.Generator) -> None:
        self._assembly, self._truth, self._aim = assembly, assembly.world.truth, trial.aim
        self._last = feet_of(assembly)
        self._walked_m = 0.0
        self._periods = 0

    def on_event(self, event: object) -> None:
        """Nothing to note."""

    def on_period(self) -> None:
        """Add up the way that was walked."""
        self._periods += 1
        if self._periods % 50 == 0:
            now = feet_of(self._assembly)
            self._walked_m += now.distance_m(self._last)
            self._last = now


class FridgeJudge(_ErrandJudge):
    """Whether the door stands open."""

    def verdict(self, _results: Sequence[TaskResult]) -> Verdict:
        """Open as far as is called open."""
        opening = self._truth.opening("fridge")
        done = opening >= OPEN_ENOUGH["door"]
        numbers = {"opening_deg": math.degrees(opening), "walked_m": self._walked_m}
        return Verdict(done, numbers, "" if done else f"open by {math.degrees(opening):.0f} degrees")


class CupJudge(_ErrandJudge):
    """Whether the cup is in a hand, above the table."""

    def verdict(self, _results: Sequence[TaskResult]) -> Verdict:
        """Lifted, and touched by finger pads alone."""
        lift_m = self._truth.lift_m(self._aim)
        done = lift_m >= LIFTED_M and self._aim in self._truth.in_pads_only()
        numbers = {"lift_m": lift_m, "walked_m": self._walked_m}
        return Verdict(done, numbers, "" if done else f"lifted by {100 * lift_m:.0f} cm")


def fridge_trial(rng: np.random.Generator) -> Trial:
    """Walk to the kitchen and open the fridge."""
    walk = WalkToTask("walk to the kitchen", "kitchen")
    return Trial(flat(rng), (walk, OpenTask("open the fridge", ObjectDescription("fridge"))), "fridge")


def cup_trial(rng: np.random.Generator) -> Trial:
    """Walk to the table and pick up the red cup."""
    walk = WalkToTask("walk to the table", "table")
    pick = PickTask("pick up the red cup", ObjectDescription("cup", "red"))
    return Trial(flat(rng), (walk, pick), "red cup")


FLAT_FRIDGE = SkillSuite(fridge_trial, FridgeJudge, stands=False)
FLAT_PICK = SkillSuite(cup_trial, CupJudge, stands=False)
