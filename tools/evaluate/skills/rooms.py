"""Random rooms: a table or two ahead, things on them, people about. Each range is named once here."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from kinematics.geometry import poses
from kinematics.geometry.shapes import Box, Cylinder, Shape
from robots.scenes.scene_description import (
    Furniture,
    PerceptionModel,
    Person,
    RobotStart,
    SceneDescription,
    SceneItem,
)
from robots.scenes.scene_file import read_scene
from robots.scenes.scene_writer import dump

START_OFFSET_M = 0.03
START_YAW_RAD = math.radians(5.0)
APART_M = 0.20
PERSON_FAR_M = (1.1, 2.2)
PERSON_BEARING_RAD = math.radians(50.0)
NAMES = ("Ana", "Ben", "Cleo")
PEOPLE_APART_M = 0.7
KINDS = ("cup", "box", "bottle", "can")
COLORS = ("red", "blue", "green", "yellow", "white", "black")


Range = tuple[float, float]


@dataclass(frozen=True, slots=True)
class Workspace:
    """What is within reach of a kind of robot, and fits into its hands; lengths in m.

    Attributes:
        table_height_m: Of tables.
        edge_ahead_m: From the robot to the front edge of a table.
        table_depth_m, table_width_m: Of tables.
        room_at_edge_m: Things stand so far from the front edge, and from the back one.
        deepest_m: And no farther than this from the front edge.
        aside_m: From the table's middle to the sides.
        farthest_m: From the robot, along the floor.
        radius_m: Of round things.
        box_m: Of boxes, the smallest and the largest.
        container_ahead_m, container_aside_m: Of containers, from the edge, and from the middle.
        cup_height_m: Of cups that are to be picked up.
        least_height_m: Of round things.
        kinds: Of things that its hands take.
        most_people: Who stand about at once; none where the eyes look down at a bench.
    """

    table_height_m: Range
    edge_ahead_m: Range
    table_depth_m: Range
    table_width_m: Range
    room_at_edge_m: float
    deepest_m: float
    aside_m: float
    farthest_m: float
    radius_m: Range
    box_m: tuple[tuple[float, float, float], tuple[float, float, float]]
    container_ahead_m: Range
    container_aside_m: float
    most_people: int
    cup_height_m: Range = (0.08, 0.16)
    least_height_m: float = 0.0
    kinds: Sequence[str] = KINDS


STANDING = Workspace(
    table_height_m=(0.75, 1.0),
    edge_ahead_m=(0.31, 0.35),
    table_depth_m=(0.5, 0.7),
    table_width_m=(1.1, 1.5),
    room_at_edge_m=0.07,
    deepest_m=0.32,
    aside_m=0.40,
    farthest_m=math.inf,
    radius_m=(0.025, 0.038),
    box_m=((0.04, 0.04, 0.07), (0.07, 0.09, 0.14)),
    container_ahead_m=(0.16, 0.26),
    container_aside_m=0.3,
    most_people=2,
)
"""Before a humanoid of a grown-up's size."""
BENCH = Workspace(
    table_height_m=(0.70, 0.80),
    edge_ahead_m=(0.29, 0.33),
    table_depth_m=(0.5, 0.7),
    table_width_m=(1.1, 1.4),
    room_at_edge_m=0.07,
    deepest_m=0.42,
    aside_m=0.40,
    farthest_m=0.68,
    radius_m=(0.018, 0.032),
    box_m=((0.03, 0.03, 0.05), (0.06, 0.09, 0.13)),
    container_ahead_m=(0.16, 0.26),
    container_aside_m=0.3,
    most_people=0,
)
"""Before an arm that is bolted to a pedestal as high as a table (the scenes named bench)."""
LOW = Workspace(
    table_height_m=(0.66, 0.76),
    edge_ahead_m=(0.275, 0.29),
    table_depth_m=(0.4, 0.6),
    table_width_m=(0.9, 1.3),
    room_at_edge_m=0.05,
    deepest_m=0.12,
    aside_m=0.30,
    farthest_m=0.45,
    radius_m=(0.02, 0.038),
    box_m=((0.04, 0.04, 0.12), (0.06, 0.07, 0.16)),
    container_ahead_m=(0.16, 0.26),
    container_aside_m=0.25,
    most_people=0,
    cup_height_m=(0.10, 0.17),
    least_height_m=0.12,
    kinds=("cup", "bottle", "can"),
)
"""Before a humanoid of a child's size, whose eyes look down (the scene named low_tabletop)."""


def start(rng: np.random.Generator) -> RobotStart:
    """Where the robot stands: about the origin."""
    x, y = (float(value) for value in rng.uniform(-START_OFFSET_M, START_OFFSET_M, 2))
    return RobotStart(x, y, float(rng.uniform(-START_YAW_RAD, START_YAW_RAD)))


def table(rng: np.random.Generator, where: Workspace = STANDING) -> Furniture:
    """A table ahead."""
    depth, width = float(rng.uniform(*where.table_depth_m)), float(rng.uniform(*where.table_width_m))
    edge, height = float(rng.uniform(*where.edge_ahead_m)), float(rng.uniform(*where.table_height_m))
    return Furniture("table", "table", (depth, width, height), (edge + 0.5 * depth, 0.0))


def shape_of(kind: str, rng: np.random.Generator, where: Workspace = STANDING) -> Shape:
    """A random size that a hand can hold."""
    if kind == "box":
        x, y, z = (float(value) for value in rng.uniform(*where.box_m))
        return Box((x, y, z))
    low, high = {"bottle": (0.15, 0.20), "can": (0.10, 0.13), "cup": (0.08, 0.14)}[kind]
    height_m = max(where.least_height_m, float(rng.uniform(low, high)))
    return Cylinder(float(rng.uniform(*where.radius_m)), height_m)


def item(
    name: str,
    kind: str,
    color: str,
    shape: Shape,
    carrier: Furniture,
    place: tuple[float, float],
    rng: np.random.Generator,
) -> SceneItem:
    """A thing that stands on a piece of furniture; ``place`` is in the world."""
    turn = poses.rotation_z(float(rng.uniform(-math.pi, math.pi)) if isinstance(shape, Box) else 0.0)
    pose = poses.transform(turn, (*place, carrier.size_m[2] + 0.5 * shape.height_m))
    mass, friction = float(rng.uniform(0.1, 0.5)), float(rng.uniform(0.5, 1.0))
    return SceneItem(name, kind, color, shape, mass, friction, pose)


def spot(
    rng: np.random.Generator,
    carrier: Furniture,
    others: Sequence[SceneItem],
    apart_m: float = APART_M,
    where: Workspace = STANDING,
) -> tuple[float, float] | None:
    """A free place on a table, in the world; None when there is hardly any."""
    edge = carrier.position_m[0] - 0.5 * carrier.size_m[0]
    back = min(carrier.size_m[0] - where.room_at_edge_m, where.deepest_m)
    for _ in range(60):
        x = edge + float(rng.uniform(where.room_at_edge_m, back))
        y = float(rng.uniform(-where.aside_m, where.aside_m))
        if math.hypot(x, y) > where.farthest_m:
            continue
        if all(math.hypot(x - o.world_T_object[0, 3], y - o.world_T_object[1, 3]) >= apart_m for o in others):
            return x, y
    return None


def things(
    rng: np.random.Generator,
    carrier: Furniture,
    count: int,
    kinds: Sequence[str] | None = None,
    where: Workspace = STANDING,
) -> list[SceneItem]:
    """Up to so many things on a table, each with a colour and kind of its own."""
    found: list[SceneItem] = []
    looks = [(kind, color) for kind in kinds or where.kinds for color in COLORS]
    order = rng.permutation(len(looks))[:count]
    for kind, color in (looks[i] for i in order):
        place = spot(rng, carrier, found, where=where)
        if place is not None:
            shape = shape_of(kind, rng, where)
            found.append(item(f"{color} {kind}", kind, color, shape, carrier, place, rng))
    return found


def played(people: Sequence[Person]) -> tuple[Person, ...]:
    """The same people, who do only what a judge has them do."""
    return tuple(replace(person, takes=False) for person in people)


def people(
    rng: np.random.Generator,
    count: int,
    furniture: Sequence[Furniture],
    bearing_rad: float = PERSON_BEARING_RAD,
) -> list[Person]:
    """People who stand about and face the robot, each in sight of the other side of what is there."""
    found: list[Person] = []
    behind = max((piece.position_m[0] + 0.5 * piece.size_m[0] + 0.35 for piece in furniture), default=0.0)
    for name in NAMES[:count]:
        for _ in range(200):
            far = float(rng.uniform(*PERSON_FAR_M))
            bearing = float(rng.uniform(-bearing_rad, bearing_rad))
            x, y = far * math.cos(bearing), far * math.sin(bearing)
            clear = all(math.dist((x, y), other.position_m) >= PEOPLE_APART_M for other in found)
            if clear and x >= behind:
                yaw = math.atan2(-y, -x) + float(rng.uniform(-0.3, 0.3))
                found.append(Person(name, (x, y), yaw))
                break
    return found


def room(
    name: str,
    rng: np.random.Generator,
    furniture: Sequence[Furniture] = (),
    objects: Sequence[SceneItem] = (),
    crowd: Sequence[Person] = (),
    perception: PerceptionModel | None = None,
) -> SceneDescription:
    """A scene, written as TOML and read back: the file of an episode is that episode to the last bit."""
    scene = SceneDescription(
        name, start(rng), perception or PerceptionModel(), tuple(furniture), tuple(objects), tuple(crowd)
    )
    return read_scene(dump(scene), f"episode {name}", name)
