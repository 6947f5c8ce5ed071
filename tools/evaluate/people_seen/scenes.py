"""Random people at one to four metres, with furniture about."""

from __future__ import annotations

import math

import numpy as np

from robots.scenes.light import Light, LightKind
from robots.scenes.scene_description import (
    GESTURES,
    POSTURES,
    Furniture,
    Person,
    SceneDescription,
)
from robots.scenes.scene_words import COLORS
from robots.simulated.camera.standing_view import Gaze

LIGHTS: tuple[LightKind, ...] = ("bright", "dim", "warm")
NEAR_M, FAR_M = 1.0, 4.0
_EYES_M = 1.65
_UPPER, _LOWER = ("shirt", "jacket", "sweater"), ("trousers", "jeans", "skirt")


def people_scene(seed: int) -> tuple[SceneDescription, Gaze]:
    """One or two people, now and then with furniture, and where the robot looks."""
    rng = np.random.default_rng([seed, 1301])
    ahead = float(rng.uniform(-0.4, 0.4))
    people: list[Person] = []
    for number in range(1 + int(rng.random() < 0.3)):
        for _ in range(50):
            person = _person(rng, number, ahead)
            if all(_apart(person, one) for one in people):
                people.append(person)
                break
    furniture = tuple(_pieces(rng, people))
    light = LIGHTS[int(rng.integers(len(LIGHTS)))]
    scene = SceneDescription("people", furniture=furniture, people=tuple(people), light=Light(light))
    first = people[0]
    away = math.hypot(*first.position_m)
    height = {"standing": 1.3, "sitting": 0.9, "lying": 0.2}[first.posture]
    tilt = float(np.clip(math.atan2(_EYES_M - height, away) + rng.uniform(-0.08, 0.08), 0.0, 0.85))
    return scene, Gaze(tilt, ahead, 0.0)


def _person(rng: np.random.Generator, number: int, ahead: float) -> Person:
    posture = POSTURES[int(rng.choice(3, p=(0.55, 0.3, 0.15)))]
    nearest = {"standing": NEAR_M, "sitting": NEAR_M + 0.3, "lying": 1.6}[posture]
    away, off = float(rng.uniform(nearest, FAR_M)), ahead + float(rng.uniform(-0.35, 0.35))
    gesture = None
    if posture != "lying" and rng.random() < 0.6:
        gesture = GESTURES[int(rng.integers(len(GESTURES)))]
    colors = list(COLORS)
    upper, lower = colors[int(rng.integers(len(colors)))], colors[int(rng.integers(len(colors)))]
    above, below = _UPPER[int(rng.integers(3))], _LOWER[int(rng.integers(3))]
    return Person(
        name=("Ana", "Ben")[number],
        position_m=(away * math.cos(off), away * math.sin(off)),
        yaw_rad=float(rng.uniform(-math.pi, math.pi)),
        posture=posture,
        gesture=gesture,
        clothes=(f"{upper} {above}", f"{lower} {below}"),
    )


def _apart(a: Person, b: Person) -> bool:
    """Whether two people touch each other nowhere, and neither hides the other from the robot."""
    room = 2.2 if "lying" in (a.posture, b.posture) else 1.3
    turn = abs(math.atan2(*a.position_m[::-1]) - math.atan2(*b.position_m[::-1]))
    near = min(math.hypot(*a.position_m), math.hypot(*b.position_m))
    return math.dist(a.position_m, b.position_m) > room and turn > math.asin(min(0.35 / near, 1.0))


def _pieces(rng: np.random.Generator, people: list[Person]) -> list[Furniture]:
    """A wall behind, a table, a fridge, where they touch nobody."""
    found: list[Furniture] = []
    for kind, size, chance in (
        ("wall", (0.1, 6.0, 2.5), 0.4),
        ("table", (0.7, 1.2, 0.75), 0.5),
        ("shelf", (0.35, 0.8, 1.6), 0.4),
    ):
        if rng.random() > chance:
            continue
        for _ in range(30):
            if kind == "wall":
                place, yaw = (float(rng.uniform(5.0, 6.0)), 0.0), 0.0
            else:
                away, off = float(rng.uniform(1.6, 4.5)), float(rng.uniform(-0.8, 0.8))
                place, yaw = (away * math.cos(off), away * math.sin(off)), float(rng.uniform(-0.5, 0.5))
            reach = 0.0 if kind == "wall" else 0.5 * math.hypot(*size[:2])
            clear = all(_clear(person, place, reach) for person in people)
            others = all(
                math.dist(place, one.position_m) > reach + 0.8 for one in found if one.kind != "wall"
            )
            if clear and (kind == "wall" or others):
                found.append(Furniture(kind, kind, size, place, yaw))
                break
    return found


def _clear(person: Person, place: tuple[float, float], reach: float) -> bool:
    """Whether a piece touches nobody, and hides nobody from the robot."""
    room = 1.3 if person.posture == "lying" else 0.95
    if math.dist(person.position_m, place) < reach + room:
        return False
    away, own = math.hypot(*place), math.hypot(*person.position_m)
    turn = abs(math.atan2(place[1], place[0]) - math.atan2(person.position_m[1], person.position_m[0]))
    return away > own or turn > math.asin(min((reach + 0.4) / away, 1.0)) + 0.3
