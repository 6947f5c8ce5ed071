"""Suites of errands in a home: walk somewhere, and do something there."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Sequence
from functools import partial

import numpy as np

from executive.session.assembly import Assembly
from executive.session.task_result import TaskResult
from kinematics.geometry import poses
from robots.errors import SceneError
from robots.scenes.articulated import moving_part
from robots.scenes.scene_description import RobotStart, SceneDescription
from robots.scenes.scene_file import load_scene, read_scene
from robots.scenes.scene_writer import dump
from tools.evaluate.opening.scenes import HOUSEHOLDS, LOW_KITCHEN, Household
from tools.evaluate.skills import rooms
from tools.evaluate.skills.handing_over import TakingJudge
from tools.evaluate.skills.suite import SkillSuite, Trial, Verdict
from tools.evaluate.skills.way_walked import WayWalked
from trees.beliefs.openings.handles import OPEN_ENOUGH
from trees.tasks import HandOverTask, ObjectDescription, OpenTask, PickTask, WalkToTask

START_M, START_RAD = 0.35, 0.6
PERSON_M = 0.25
OBJECT_M = 0.05
LIFTED_M = 0.08
_DRAWS = 100
BOTTLE, BOTTLE_M = "green bottle", 0.05
BRING = "bring me the bottle from the fridge"


def home(
    rng: np.random.Generator, name: str = "flat", house: Household = HOUSEHOLDS[None]
) -> SceneDescription:
    """A home, with the robot, the people, the door and the things on the table as they happen to be.

    Nobody stands inside the counter: what cannot be is drawn again.

    Args:
        rng: Draws it.
        name: The scene that it is drawn from.
        house: What its doors are like.
    """
    for _ in range(_DRAWS):
        try:
            return read_scene(dump(_drawn(rng, name, house)), f"episode in {name}", name)
        except SceneError:
            continue
    raise RuntimeError(f"no {name} could be drawn")


def _drawn(rng: np.random.Generator, name: str, house: Household) -> SceneDescription:
    scene = load_scene(name)

    def off(most: float) -> float:
        return float(rng.uniform(-most, most))

    start = RobotStart(off(START_M), off(START_M), off(START_RAD))
    furniture = []
    for piece in scene.furniture:
        if piece.opens is not None and piece.opens.hinge is not None:
            part = dataclasses.replace(
                moving_part(piece),
                mass_kg=float(rng.uniform(*house.mass_kg)),
                friction=float(rng.uniform(*house.friction_nm)),
                seal_n=float(rng.uniform(*house.seal_n)),
                handle_height_m=float(rng.uniform(*house.handle_height_m)),
            )
            piece = dataclasses.replace(piece, opens=part)
        furniture.append(piece)
    people = tuple(
        dataclasses.replace(
            person,
            position_m=(person.position_m[0] + off(PERSON_M), person.position_m[1] + off(PERSON_M)),
            yaw_rad=off(math.pi),
        )
        for person in rooms.played(scene.people)
    )
    objects = []
    for item in scene.objects:
        pose = item.world_T_object.copy()
        if item.name != BOTTLE:
            pose[:2, 3] += (off(OBJECT_M), off(OBJECT_M))
        objects.append(dataclasses.replace(item, world_T_object=pose))
    return dataclasses.replace(
        scene, robot_start=start, furniture=tuple(furniture), people=people, objects=tuple(objects)
    )


class _ErrandJudge:
    """Notes how far the robot went."""

    def __init__(self, assembly: Assembly, trial: Trial, _rng: np.random.Generator) -> None:
        self._truth, self._aim, self._way = assembly.world.truth, trial.aim, WayWalked(assembly)

    def on_event(self, event: object) -> None:
        """Nothing to note."""

    def on_period(self) -> None:
        """Add up the way that was walked."""
        self._way.on_period()


class FridgeJudge(_ErrandJudge):
    """Whether the door stands open."""

    def verdict(self, _results: Sequence[TaskResult]) -> Verdict:
        """Open as far as is called open."""
        opening = self._truth.opening("fridge")
        done = opening >= OPEN_ENOUGH["door"]
        numbers = {"opening_deg": math.degrees(opening), "walked_m": self._way.length_m}
        return Verdict(done, numbers, "" if done else f"open by {math.degrees(opening):.0f} degrees")


class CupJudge(_ErrandJudge):
    """Whether the cup is in a hand, above the table."""

    def verdict(self, _results: Sequence[TaskResult]) -> Verdict:
        """Lifted, and touched by finger pads alone."""
        lift_m = self._truth.lift_m(self._aim)
        done = lift_m >= LIFTED_M and self._aim in self._truth.contacts.in_pads_only()
        numbers = {"lift_m": lift_m, "walked_m": self._way.length_m}
        return Verdict(done, numbers, "" if done else f"lifted by {100 * lift_m:.0f} cm")


def fridge_trial(rng: np.random.Generator, name: str = "flat", house: Household = HOUSEHOLDS[None]) -> Trial:
    """Walk to the kitchen and open the fridge."""
    walk = WalkToTask("walk to the kitchen", "kitchen")
    opened = OpenTask("open the fridge", ObjectDescription("fridge"))
    return Trial(home(rng, name, house), (walk, opened), "fridge")


def cup_trial(rng: np.random.Generator) -> Trial:
    """Walk to the table and pick up the red cup."""
    walk = WalkToTask("walk to the table", "table")
    pick = PickTask("pick up the red cup", ObjectDescription("cup", "red"))
    return Trial(home(rng), (walk, pick), "red cup")


class BringJudge(TakingJudge):
    """Plays who speaks, who takes the bottle; tells how far the errand got."""

    def __init__(self, assembly: Assembly, trial: Trial, rng: np.random.Generator) -> None:
        super().__init__(assembly, trial, rng)
        self._all, self._way = assembly.world.truth, WayWalked(assembly)

    def on_period(self) -> None:
        """Take it, and add up the way that was walked."""
        super().on_period()
        self._way.on_period()

    def verdict(self, results: Sequence[TaskResult]) -> Verdict:
        """In the hand of who spoke, and carried away."""
        taken = super().verdict(results)
        numbers = {
            **taken.numbers,
            "walked_m": self._way.length_m,
            "opening_deg": math.degrees(self._all.opening("fridge")),
            "task": results[-1].text,
            "tasks_done": sum(result.outcome == "done" for result in results),
            "simulated_s": round(self._all.time_s, 1),
        }
        return Verdict(taken.done, numbers, taken.why)


def bring_trial(rng: np.random.Generator) -> Trial:
    """Bring me the bottle from the fridge: Ana says it, who stands nearest to the robot."""
    scene = home(rng)
    x, y = (float(value) for value in rng.uniform(-BOTTLE_M, BOTTLE_M, 2))
    objects = tuple(
        dataclasses.replace(item, world_T_object=poses.translation(x, y, 0.0) @ item.world_T_object)
        if item.name == BOTTLE
        else item
        for item in scene.objects
    )
    give = HandOverTask(BRING, ObjectDescription("bottle"), scene.people[0].name)
    return Trial(dataclasses.replace(scene, objects=objects), (give,), BOTTLE, BRING)


FLAT_FRIDGE = SkillSuite(
    fridge_trial,
    FridgeJudge,
    stands=False,
    on_low=partial(fridge_trial, name=LOW_KITCHEN, house=HOUSEHOLDS[LOW_KITCHEN]),
)
FLAT_PICK = SkillSuite(cup_trial, CupJudge, stands=False)
FLAT_BRING = SkillSuite(bring_trial, BringJudge, stands=False, bar=0.8)
