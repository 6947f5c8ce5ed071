"""Random people in the rooms of the flat: where they are, how they are, what they wear, whether they walk."""

from __future__ import annotations

import dataclasses
import math

import numpy as np

from kinematics.geometry.planar import PlanarPose
from kinematics.walking.route.path_planning import Footprint, clearance_m, footprints
from robots.errors import SceneError
from robots.scenes.scene_description import GESTURES, Person, Posture, Region, SceneDescription
from robots.scenes.scene_file import read_scene
from robots.scenes.scene_solids import planning_scene
from robots.scenes.scene_writer import dump
from tools.evaluate.skills import rooms
from tools.evaluate.skills.errands import home

NAMES = ("Ana", "Ben", "Cleo", "Dan", "Eve", "Finn")
POSTURES: tuple[Posture, ...] = ("standing", "sitting", "lying")
POSTURE_SHARES = (0.65, 0.28, 0.07)
GARMENTS = ("shirt", "trousers", "jacket", "hat")
GESTURE_CHANCE = 0.5
WALKING_CHANCE = 0.35
FREE_M = {"standing": 0.75, "sitting": 0.95, "lying": 1.35}
"""From the middle of a person to furniture: the robot has to get there, and to turn."""
APART_M = 1.3
FROM_ROBOT_M = 1.1
DOORWAY_M, FROM_DOORWAY_M = (2.4, 0.6), 1.5
"""Middle of the flat's doorway, and how far from it people keep: who stands in it bars the way."""
WAY_M, WAY_FREE_M = (0.8, 2.0), 0.45
SPEED_M_S = (0.25, 0.5)
STARTS_S = (0.0, 20.0)
_DRAWS = 400


def peopled_flat(rng: np.random.Generator, count: int) -> SceneDescription:
    """The flat with so many people of random kind in it.

    Raises:
        RuntimeError: There was no room for them.
    """
    for _ in range(20):
        scene = dataclasses.replace(home(rng), people=())
        people = _people(scene, rng, count)
        if people is None:
            continue
        try:
            return read_scene(dump(dataclasses.replace(scene, people=people)), "episode of people", "flat")
        except SceneError:
            continue
    raise RuntimeError("no flat with people could be drawn")


def room_of(scene: SceneDescription, x_m: float, y_m: float) -> str | None:
    """The room that a place on the floor is in."""
    return next((region.name for region in scene.places if region.contains(x_m, y_m)), None)


def ends_at(person: Person) -> tuple[float, float]:
    """Where a person comes to stand."""
    return person.way_m[-1] if person.way_m else person.position_m


def _people(scene: SceneDescription, rng: np.random.Generator, count: int) -> tuple[Person, ...] | None:
    furniture = footprints(planning_scene(scene))
    found: list[Person] = []
    for name in [NAMES[int(k)] for k in rng.permutation(len(NAMES))[:count]]:
        person = next(
            filter(None, (_person(name, scene, furniture, found, rng) for _ in range(_DRAWS))), None
        )
        if person is None:
            return None
        found.append(person)
    return tuple(found)


def _person(
    name: str,
    scene: SceneDescription,
    furniture: tuple[Footprint, ...],
    others: list[Person],
    rng: np.random.Generator,
) -> Person | None:
    region: Region = scene.places[int(rng.integers(len(scene.places)))]
    posture = POSTURES[int(rng.choice(len(POSTURES), p=POSTURE_SHARES))]
    x, y = _inside(region, rng)
    if not _free((x, y), furniture, FREE_M[posture]) or not _apart((x, y), scene, others):
        return None
    colors = [rooms.COLORS[int(k)] for k in rng.permutation(len(rooms.COLORS))[:2]]
    garments = [GARMENTS[int(k)] for k in rng.permutation(len(GARMENTS))[:2]]
    clothes = tuple(f"{color} {garment}" for color, garment in zip(colors, garments, strict=True))
    gesture = GESTURES[int(rng.integers(len(GESTURES)))] if rng.random() < GESTURE_CHANCE else None
    yaw = float(rng.uniform(-math.pi, math.pi))
    person = Person(name, (x, y), yaw, posture=posture, gesture=gesture, clothes=clothes)
    if posture != "standing" or rng.random() >= WALKING_CHANCE:
        return person
    way = _way((x, y), region, scene, furniture, others, rng)
    speed, starts = float(rng.uniform(*SPEED_M_S)), float(rng.uniform(*STARTS_S))
    return dataclasses.replace(person, gesture=None, way_m=way, speed_m_s=speed, starts_s=starts)


def _way(
    start: tuple[float, float],
    region: Region,
    scene: SceneDescription,
    furniture: tuple[Footprint, ...],
    others: list[Person],
    rng: np.random.Generator,
) -> tuple[tuple[float, float], ...]:
    """One to three stretches with room on both sides; none where there is no room."""
    way: list[tuple[float, float]] = []
    here = start
    for _ in range(60):
        far, to = float(rng.uniform(*WAY_M)), float(rng.uniform(-math.pi, math.pi))
        there = here[0] + far * math.cos(to), here[1] + far * math.sin(to)
        between = [
            (here[0] + share * (there[0] - here[0]), here[1] + share * (there[1] - here[1]))
            for share in np.linspace(0.0, 1.0, 9).tolist()
        ]
        clear = all(_free(one, furniture, WAY_FREE_M) and _apart(one, scene, others) for one in between)
        if region.contains(*there) and clear and _free(there, furniture, FREE_M["standing"]):
            way.append(there)
            here = there
        if len(way) == 3:
            break
    return tuple(way[: int(rng.integers(1, 4))])


def _inside(region: Region, rng: np.random.Generator) -> tuple[float, float]:
    half_x, half_y = (0.5 * size - 0.4 for size in region.size_m)
    at = PlanarPose(*region.position_m, region.yaw_rad) @ PlanarPose(
        float(rng.uniform(-half_x, half_x)), float(rng.uniform(-half_y, half_y))
    )
    return at.x_m, at.y_m


def _free(at: tuple[float, float], furniture: tuple[Footprint, ...], least_m: float) -> bool:
    return clearance_m(furniture, PlanarPose(*at)) >= least_m


def _apart(at: tuple[float, float], scene: SceneDescription, others: list[Person]) -> bool:
    start = scene.robot_start
    places = [place for other in others for place in (other.position_m, *other.way_m)]
    kept = (((start.x_m, start.y_m), FROM_ROBOT_M), (DOORWAY_M, FROM_DOORWAY_M))
    return all(math.dist(at, place) >= least_m for place, least_m in kept) and all(
        math.dist(at, place) >= APART_M for place in places
    )
