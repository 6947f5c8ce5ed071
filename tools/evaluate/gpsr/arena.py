"""The scene ``arena``, made by a seed: three rooms in a row, things of everyday life, people.

Rooms, furniture, what is on it, and who stands where are drawn. Walls are as high as a table, so that the
eyes look over them and the feet have to find the doorways.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Sequence

import numpy as np

from kinematics.geometry.shapes import Ball, Box, Cylinder, Shape
from robots.errors import SceneError
from robots.scenes.scene_description import (
    GESTURES,
    Furniture,
    PerceptionModel,
    Person,
    Region,
    RobotStart,
    SceneDescription,
    SceneItem,
)
from robots.scenes.scene_file import read_scene
from robots.scenes.scene_writer import dump
from tools.evaluate.gpsr.field_commands import FieldWords
from tools.evaluate.skills import rooms

THINGS = 40
ROOM_M = (4.2, 4.8)
"""Of each room: from west to east, and from south to north."""
_WALL_M = (0.1, 0.9)
_DOORWAY_M, _GAP_M = 1.3, 0.01
_PIECES: dict[str, tuple[tuple[str, str], ...]] = {
    "kitchen": (("kitchen table", "table"), ("counter", "counter")),
    "living room": (("side table", "table"), ("shelf", "shelf")),
    "office": (("desk", "table"), ("office table", "table")),
    "bedroom": (("bedside table", "table"), ("dining table", "table")),
}
_SIZES_M = {"table": (0.6, 1.4), "counter": (0.62, 1.6), "shelf": (0.32, 1.1)}
_HEIGHTS_M = {"table": (0.75, 0.95), "counter": (0.88, 0.93), "shelf": (1.1, 1.25)}
_NAMED: tuple[tuple[str, str, str, str], ...] = (
    ("apple", "ball", "red", "fruit"), ("orange", "ball", "orange", "fruit"),
    ("tennis ball", "ball", "yellow", "toy"), ("sponge", "box", "yellow", "cleaning supply"),
    ("cola", "can", "red", "drink"), ("orange juice", "box", "orange", "drink"),
    ("milk", "box", "white", "drink"), ("iced tea", "can", "yellow", "drink"),
    ("tomato soup", "can", "red", "food"), ("mustard", "bottle", "yellow", "food"),
    ("sugar", "box", "white", "food"), ("coffee", "can", "black", "food"),
    ("ketchup", "bottle", "red", "food"), ("cornflakes", "box", "green", "snack"),
    ("dice", "box", "white", "toy"), ("cleanser", "bottle", "blue", "cleaning supply"),
)  # fmt: skip
"""Names, what they are as solids, colours and categories."""
_KINDS = ("cup", "bottle", "can", "box")
_PEOPLE = ("Ana", "Charlie", "Robin", "Simone")
_GARMENTS = ("shirt", "trousers", "jacket")
_APART_M = 0.17
_CLEAR_M = 1.2
"""Around where the robot begins."""
_NEARER_M, _TURNED_RAD = 0.4, 0.5
"""Who gives the command is so much nearer than anybody else, and about in front of the robot."""
_DRAWS = 200


@dataclasses.dataclass(frozen=True, slots=True)
class Arena:
    """A scene, and the words that a command may use in it."""

    scene: SceneDescription
    words: FieldWords


def arena(rng: np.random.Generator) -> Arena:
    """Draw an arena; what cannot be is drawn again.

    Raises:
        RuntimeError: None could be drawn.
    """
    for _ in range(_DRAWS):
        drawn = _drawn(rng)
        start = drawn.robot_start
        nearest_m, second_m, *_ = sorted(_from_start_m(drawn, person) for person in drawn.people)
        if nearest_m < _CLEAR_M or second_m < nearest_m + _NEARER_M:
            continue  # arms at home would touch whoever stands there; two may be who speaks
        drawn = dataclasses.replace(drawn, robot_start=_before(speaker_in(drawn), start, rng))
        try:
            scene = read_scene(dump(drawn), "arena", "arena")
        except SceneError:
            continue
        return Arena(scene, _words(scene))
    raise RuntimeError("no arena could be drawn")


def speaker_in(scene: SceneDescription) -> Person:
    """Who gives the commands: the person nearest to the robot at the beginning."""
    return min(scene.people, key=lambda person: _from_start_m(scene, person))


def _from_start_m(scene: SceneDescription, person: Person) -> float:
    return math.dist(person.position_m, (scene.robot_start.x_m, scene.robot_start.y_m))


def _before(person: Person, start: RobotStart, rng: np.random.Generator) -> RobotStart:
    """The same start, turned about towards somebody."""
    x, y = person.position_m
    yaw = math.atan2(y - start.y_m, x - start.x_m) + float(rng.uniform(-_TURNED_RAD, _TURNED_RAD))
    return dataclasses.replace(start, yaw_rad=math.remainder(yaw, 2.0 * math.pi))


def _drawn(rng: np.random.Generator) -> SceneDescription:
    names = [list(_PIECES)[k] for k in rng.permutation(len(_PIECES))[:3]]
    places, pieces = [], _walls(rng)
    for number, name in enumerate(names):
        middle = number * ROOM_M[0]
        places.append(Region(name, (middle, 0.0), ROOM_M))
        for side, (called, kind) in zip((-1.0, 1.0), _PIECES[name], strict=True):
            pieces.append(_piece(called, kind, middle, side, rng))
    carriers = [piece for piece in pieces if piece.kind != "wall"]
    x, y = (float(value) for value in rng.uniform((-0.4, -0.3), (0.4, 0.3)))
    start = RobotStart(x, y, 0.0)
    return SceneDescription(
        "arena",
        start,
        PerceptionModel(),
        tuple(pieces),
        tuple(_things(carriers, rng)),
        _people(rng),
        tuple(places),
    )


def _walls(rng: np.random.Generator) -> list[Furniture]:
    """Around the rooms, and between them, with a doorway somewhere in the middle of each."""
    thick, high = _WALL_M
    half = 0.5 * thick
    long, deep = 3.0 * ROOM_M[0], ROOM_M[1]
    west, middle = -0.5 * ROOM_M[0], ROOM_M[0]
    walls = [
        Furniture("wall west", "wall", (thick, deep + 2.0 * thick, high), (west - half, 0.0)),
        Furniture("wall east", "wall", (thick, deep + 2.0 * thick, high), (west + long + half, 0.0)),
        Furniture("wall north", "wall", (thick, long, high), (middle, 0.5 * deep + half), 0.5 * math.pi),
        Furniture("wall south", "wall", (thick, long, high), (middle, -0.5 * deep - half), 0.5 * math.pi),
    ]
    for number in range(2):
        x, door = west + (number + 1) * ROOM_M[0], float(rng.uniform(-0.3, 0.3))
        for name, side in (("south", -1.0), ("north", 1.0)):
            edge, beside = side * (0.5 * deep - _GAP_M), door + side * 0.5 * _DOORWAY_M
            size = (thick, abs(edge - beside), high)
            walls.append(Furniture(f"wall {name} {number + 1}", "wall", size, (x, 0.5 * (edge + beside))))
    return walls


def _piece(name: str, kind: str, middle_m: float, side: float, rng: np.random.Generator) -> Furniture:
    """A piece along the south (-1) or north (1) wall of a room."""
    depth, width = _SIZES_M[kind]
    height = float(rng.uniform(*_HEIGHTS_M[kind]))
    y = side * (0.5 * ROOM_M[1] - 0.08 - 0.5 * depth)
    x = middle_m + float(rng.uniform(-0.5, 0.5))
    return Furniture(name, kind, (depth, width, height), (x, y), side * 0.5 * math.pi)


def _things(carriers: Sequence[Furniture], rng: np.random.Generator) -> list[SceneItem]:
    """Up to 40, each of a name or a colour and kind of its own, as many as there is room for.

    What is called by its look alone looks like nothing else: else "the blue bottle" would be two things.
    """
    named = {(color, kind) for _, kind, color, _ in _NAMED}
    looks = [(color, kind) for kind in _KINDS for color in rooms.COLORS if (color, kind) not in named]
    plain = [(f"{c} {k}", k, c, "") for c, k in (looks[i] for i in rng.permutation(len(looks)))]
    wanted = [_NAMED[i] for i in rng.permutation(len(_NAMED))] + plain
    found: list[SceneItem] = []
    for name, kind, color, category in wanted:
        if len(found) == THINGS:
            break
        carrier = carriers[int(rng.integers(len(carriers)))]
        place = _spot(carrier, found, rng)
        if place is None:
            continue
        made = rooms.item(name, kind, color, _shape(kind, rng), carrier, place, rng)
        if category:
            made = dataclasses.replace(made, categories=(category,))
        found.append(made)
    return found


def _shape(kind: str, rng: np.random.Generator) -> Shape:
    if kind == "ball":
        return Ball(float(rng.uniform(0.03, 0.036)))
    shape = rooms.shape_of(kind, rng)
    assert isinstance(shape, Box | Cylinder)
    return shape


def _spot(
    carrier: Furniture, others: Sequence[SceneItem], rng: np.random.Generator
) -> tuple[float, float] | None:
    """A free place near the front of a piece, in the world."""
    depth, width = carrier.size_m[0], carrier.size_m[1]
    inward = -math.copysign(1.0, carrier.position_m[1])
    for _ in range(30):
        from_front = float(rng.uniform(0.07, min(depth - 0.07, 0.30)))
        x = carrier.position_m[0] + float(rng.uniform(-0.5, 0.5)) * (width - 0.24)
        y = carrier.position_m[1] + inward * (0.5 * depth - from_front)
        if all(math.dist((x, y), one.world_T_object[:2, 3]) >= _APART_M for one in others):
            return x, y
    return None


def _people(rng: np.random.Generator) -> tuple[Person, ...]:
    """One in each room at least, near its middle, out of the way from door to door."""
    found = []
    for number, name in enumerate(_PEOPLE):
        middle = (number % 3) * ROOM_M[0]
        side = 1.0 if number % 2 else -1.0
        x = middle + float(rng.uniform(0.7, 1.3)) * (1.0 if number < 3 else -1.0)
        y = side * float(rng.uniform(0.75, 1.0))
        yaw = float(rng.uniform(-math.pi, math.pi))
        gesture = GESTURES[int(rng.integers(len(GESTURES)))] if rng.random() < 0.4 else None
        color = rooms.COLORS[number]
        clothes = (f"{color} {_GARMENTS[int(rng.integers(len(_GARMENTS)))]}",)
        found.append(Person(name, (x, y), yaw, gesture=gesture, clothes=clothes))
    return tuple(found)


def _words(scene: SceneDescription) -> FieldWords:
    """What is where, as a command tells it."""
    carriers = [piece for piece in scene.furniture if piece.kind != "wall"]
    where = {item.name: carrier_of(scene, item).name for item in scene.objects}
    room_of = {piece.name: region_of(scene, piece.position_m) for piece in carriers}
    room_of |= {person.name: region_of(scene, person.position_m) for person in scene.people}
    return FieldWords(
        rooms=tuple(region.name for region in scene.places),
        furniture=tuple(piece.name for piece in carriers),
        things=tuple(where),
        kinds=tuple(f"{kind}s" for kind in _KINDS[:3]),
        names=tuple(person.name for person in scene.people),
        where=where,
        room_of=room_of,
    )


def region_of(scene: SceneDescription, place_m: Sequence[float]) -> str:
    """The room of a place on the floor."""
    return min(scene.places, key=lambda region: math.dist(region.position_m, place_m[:2])).name


def carrier_of(scene: SceneDescription, item: SceneItem) -> Furniture:
    """The piece that a thing stands on at the beginning."""
    carriers = [piece for piece in scene.furniture if piece.kind != "wall"]
    return min(carriers, key=lambda piece: math.dist(piece.position_m, item.world_T_object[:2, 3]))
