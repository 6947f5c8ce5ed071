"""Random scenes for picking: a table, a red cup on it, sometimes other things.

Ranges are those of the evaluation's definition; each is named once here. A scene is written as TOML and
read back before it is used, so that the file of an episode is that episode to the last bit.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from kinematics.geometry import poses
from kinematics.geometry.shapes import Box, Cylinder, Shape
from robots.errors import SceneError
from robots.models.usual_scene import usual_scene
from robots.scenes.scene_description import (
    Furniture,
    PerceptionModel,
    RobotStart,
    SceneDescription,
    SceneItem,
)
from robots.scenes.scene_file import load_scene, read_scene
from robots.scenes.scene_writer import dump
from tools.evaluate.skills import rooms

TARGET = "red cup"
SENTENCE = "pick up the red cup on the table"

TABLE_HEIGHT_M = (0.75, 1.0)
CUP_AHEAD_M = (0.35, 0.65)
CUP_ASIDE_M = 0.45
CUP_RADIUS_M = (0.020, 0.038)
CUP_HEIGHT_M = (0.080, 0.160)
CUP_MASS_KG = (0.1, 0.6)
CUP_FRICTION = (0.4, 1.0)
START_OFFSET_M = 0.03
START_YAW_RAD = math.radians(5.0)
PERCEPTION = PerceptionModel(bias_m=0.005, noise_m=0.002)

# From the robot's start to the table's front edge; nearer, the hanging hands would touch it.
EDGE_AHEAD_M = (0.29, 0.33)
# The cup stands this far inside the table's edge.
EDGE_ROOM_M = 0.01
# Kept between the standing robot and the table where the cup's place allows it.
ROBOT_ROOM_M = 0.03
# The foremost points of the home posture (x, y): fingertips and thighs.
_FRONT_M = ((0.203, 0.525), (0.203, -0.525), (0.208, 0.057), (0.208, -0.057))

OTHERS_CHANCE = 0.5
OTHERS_APART_M = 0.22
CLUTTER = "clutter"
BENCH, BENCH_CLUTTER = "bench", "bench_clutter"
LOW_TABLE = "low_tabletop"
CLUTTER_COUNT = (3, 12)
# Left free between two things amid clutter; fingers need about as much.
CLUTTER_GAP_M = 0.03
# Things of a named scene are moved by so much, along each axis.
MOVED_M = 0.02
_DRAWS = 50
_OTHER_COLORS = ("blue", "green", "yellow", "white", "black")
# Between two cups that stand too close for fingers.
TOO_CLOSE_M = (0.001, 0.006)


def workspace_of(robot: str) -> str | None:
    """The scene of a robot's own size that random ones are made like; None where that is the usual table."""
    scene = usual_scene(robot)
    return scene if scene in (BENCH, LOW_TABLE) else None


def sentence_for(scene: SceneDescription) -> str:
    """What is said: the cup is on the first piece of furniture."""
    kind = scene.furniture[0].kind if scene.furniture else "table"
    return SENTENCE.replace("table", kind)


def episode_rng(seed: int, purpose: int) -> np.random.Generator:
    """A generator for one purpose of one episode, apart from those that the run itself draws from."""
    return np.random.default_rng([seed, 0x5CE1E, purpose])


def episode_scene(seed: int, fault: str | None = None, scene: str | None = None) -> str:
    """The scene of one episode as TOML; another one for each seed.

    Args:
        seed: The episode's seed.
        fault: As for ``pick_scene``.
        scene: None for a random table, "clutter" for one with 3 to 12 other things; "bench" and
            "bench_clutter" for the same before an arm that is bolted down, "low_tabletop" before a
            humanoid of a child's size; any other scene, by name or file, with its things, its cup's
            weight and the robot's start a little different.
    """
    if scene in (BENCH, BENCH_CLUTTER):
        return bench_pick(seed, fault, crowded=scene == BENCH_CLUTTER)
    if scene == LOW_TABLE:
        return bench_pick(seed, fault, where=rooms.LOW)
    if scene is None or scene == CLUTTER:
        return pick_scene(seed, fault, crowded=scene == CLUTTER)
    return _moved_about(load_scene(scene), seed)


def _moved_about(scene: SceneDescription, seed: int) -> str:
    """The first draw that can be a world."""
    rng = episode_rng(seed, 0)

    def off(most: float) -> float:
        return float(rng.uniform(-most, most))

    for _ in range(_DRAWS):
        before = scene.robot_start
        x, y, yaw = off(START_OFFSET_M), off(START_OFFSET_M), off(START_YAW_RAD)
        objects = []
        for item in scene.objects:
            pose = item.world_T_object.copy()
            pose[:2, 3] += off(MOVED_M), off(MOVED_M)
            objects.append(replace(item, world_T_object=pose))
            if item.name == TARGET:
                mass, friction = float(rng.uniform(*CUP_MASS_KG)), float(rng.uniform(*CUP_FRICTION))
                objects[-1] = replace(objects[-1], mass_kg=mass, friction=friction)
        start = RobotStart(before.x_m + x, before.y_m + y, before.yaw_rad + yaw)
        text = dump(replace(scene, robot_start=start, perception=PERCEPTION, objects=tuple(objects)))
        try:
            read_episode_scene(text, seed)
        except SceneError:
            continue
        return text
    raise SceneError(scene.name, "object", f"no room to move the things by {MOVED_M} m")


def pick_scene(seed: int, fault: str | None = None, crowded: bool = False) -> str:
    """A random table with the cup on it, as TOML.

    Args:
        seed: The episode's seed.
        fault: "nothing_there" leaves the cup out, "too_close" puts a second one beside it; any other is
            no matter of the scene.
        crowded: 3 to 12 other things, with ``CLUTTER_GAP_M`` between them.
    """
    rng = episode_rng(seed, 0)
    start = RobotStart(
        float(rng.uniform(-START_OFFSET_M, START_OFFSET_M)),
        float(rng.uniform(-START_OFFSET_M, START_OFFSET_M)),
        float(rng.uniform(-START_YAW_RAD, START_YAW_RAD)),
    )
    radius, height = float(rng.uniform(*CUP_RADIUS_M)), float(rng.uniform(*CUP_HEIGHT_M))
    x = float(rng.uniform(*CUP_AHEAD_M))
    y = float(rng.uniform(-CUP_ASIDE_M, CUP_ASIDE_M))
    table = _table(rng, start, (x, y), radius)
    cup = SceneItem(
        name=TARGET,
        kind="cup",
        color="red",
        shape=Cylinder(radius, height),
        mass_kg=float(rng.uniform(*CUP_MASS_KG)),
        friction=float(rng.uniform(*CUP_FRICTION)),
        world_T_object=_standing(x, y, table, height, 0.0),
    )
    objects = [cup, *(_crowd if crowded else _others)(rng, table, cup)]
    things = _with_fault(seed, fault, table, objects)
    return dump(SceneDescription(f"pick-{seed}", start, PERCEPTION, (table,), tuple(things)))


def bench_pick(
    seed: int, fault: str | None = None, crowded: bool = False, where: rooms.Workspace = rooms.BENCH
) -> str:
    """The same within reach of another kind of robot, with a cup that fits into its hand."""
    rng = episode_rng(seed, 0)
    start, table = rooms.start(rng), rooms.table(rng, where)
    place = rooms.spot(rng, table, [], where=where)
    if place is None:
        raise SceneError(f"episode {seed}", "object", "no room for the cup")
    radius, height = float(rng.uniform(*where.radius_m)), float(rng.uniform(*where.cup_height_m))
    cup = SceneItem(
        name=TARGET,
        kind="cup",
        color="red",
        shape=Cylinder(radius, height),
        mass_kg=float(rng.uniform(*CUP_MASS_KG)),
        friction=float(rng.uniform(*CUP_FRICTION)),
        world_T_object=_standing(*place, table, height, 0.0),
    )
    others = _with_fault(seed, fault, table, [cup, *(_crowd if crowded else _others)(rng, table, cup)])
    return dump(SceneDescription(f"pick-{seed}", start, PERCEPTION, (table,), tuple(others)))


def _with_fault(
    seed: int, fault: str | None, table: Furniture, objects: Sequence[SceneItem]
) -> Sequence[SceneItem]:
    """The things of a scene, the cup first, as a fault has them."""
    if fault == "too_close":
        beside = _neighbour(episode_rng(seed, 1), table, objects[0])
        return [objects[0], beside, *(item for item in objects[1:] if _apart(item, beside))]
    return objects[1:] if fault == "nothing_there" else objects


def seen_by(scene: SceneDescription, perception: str | None) -> SceneDescription:
    """The same scene, seen by another kind of perception.

    Args:
        scene: Any.
        perception: "stub" or "rgbd"; None leaves it as it is.
    """
    if perception is None:
        return scene
    return replace(scene, perception=replace(scene.perception, kind=perception))


def read_episode_scene(text: str, seed: int) -> SceneDescription:
    """The scene of an episode from its TOML.

    Raises:
        SceneError: It cannot be a world.
    """
    return read_scene(text, f"episode {seed}", f"pick-{seed}")


def _table(rng: np.random.Generator, start: RobotStart, cup: tuple[float, float], radius: float) -> Furniture:
    x, y = cup
    c, s = math.cos(start.yaw_rad), math.sin(start.yaw_rad)
    front = max(start.x_m + c * px - s * py for px, py in _FRONT_M)
    latest = min(EDGE_AHEAD_M[1], x - radius - EDGE_ROOM_M)
    earliest = min(max(EDGE_AHEAD_M[0], front + ROBOT_ROOM_M), latest)
    edge = float(rng.uniform(earliest, latest))
    depth = max(float(rng.uniform(0.5, 0.8)), x + radius + 0.03 - edge)
    width = float(rng.uniform(0.9, 1.5))
    room = 0.5 * width - radius - 0.03
    centre_y = float(np.clip(rng.uniform(-0.15, 0.15), y - room, y + room))
    height = float(rng.uniform(*TABLE_HEIGHT_M))
    return Furniture("table", "table", (depth, width, height), (edge + 0.5 * depth, centre_y))


def _standing(x: float, y: float, table: Furniture, height: float, yaw_rad: float) -> poses.Transform:
    return poses.transform(poses.rotation_z(yaw_rad), (x, y, table.size_m[2] + 0.5 * height))


def _others(rng: np.random.Generator, table: Furniture, cup: SceneItem) -> list[SceneItem]:
    """None, or up to three other things, well away from the cup and from each other."""
    placed: list[SceneItem] = []
    if rng.random() >= OTHERS_CHANCE:
        return placed
    for number in range(int(rng.integers(1, 4))):
        _place(rng, table, cup, placed, number, _apart)
    return placed


def _crowd(rng: np.random.Generator, table: Furniture, cup: SceneItem) -> list[SceneItem]:
    """As many other things as clutter has; fewer on a table where they find no room."""
    placed: list[SceneItem] = []
    for number in range(int(rng.integers(CLUTTER_COUNT[0], CLUTTER_COUNT[1] + 1))):
        _place(rng, table, cup, placed, number, _gap)
    return placed


def _place(
    rng: np.random.Generator,
    table: Furniture,
    cup: SceneItem,
    placed: list[SceneItem],
    number: int,
    room: Callable[[SceneItem, SceneItem], bool],
) -> None:
    kind, shape = _other_shape(rng)
    half = 0.5 * np.array(table.size_m[:2]) - 0.08
    color = _OTHER_COLORS[int(rng.integers(len(_OTHER_COLORS)))]
    mass, friction, yaw = rng.uniform(0.1, 0.5), rng.uniform(0.4, 1.0), rng.uniform(-math.pi, math.pi)
    for _ in range(30):
        x, y = np.array(table.position_m) + rng.uniform(-half, half)
        item = SceneItem(
            name=f"{color} {kind} {number + 1}",
            kind=kind,
            color=color,
            shape=shape,
            mass_kg=float(mass),
            friction=float(friction),
            world_T_object=_standing(float(x), float(y), table, shape.height_m, float(yaw)),
        )
        if all(room(item, other) for other in (cup, *placed)):
            placed.append(item)
            return


def _other_shape(rng: np.random.Generator) -> tuple[str, Shape]:
    kind = ("box", "bottle", "can", "cup")[int(rng.integers(4))]
    if kind == "box":
        x, y, z = (float(value) for value in rng.uniform((0.04, 0.04, 0.06), (0.09, 0.09, 0.15)))
        return kind, Box((x, y, z))
    low, high = {"bottle": (0.16, 0.22), "can": (0.10, 0.13), "cup": (0.08, 0.14)}[kind]
    return kind, Cylinder(float(rng.uniform(0.028, 0.04)), float(rng.uniform(low, high)))


def _neighbour(rng: np.random.Generator, table: Furniture, cup: SceneItem) -> SceneItem:
    """A blue cup like the red one, a few millimetres beside it."""
    if not isinstance(cup.shape, Cylinder):
        raise TypeError(f"{cup.name} is no cylinder")
    radius = cup.shape.radius_m
    apart = 2.0 * radius + float(rng.uniform(*TOO_CLOSE_M))
    depth, width, _ = table.size_m
    centre = np.array(table.position_m)
    for _ in range(1000):
        angle = float(rng.uniform(-math.pi, math.pi))
        place = cup.world_T_object[:2, 3] + apart * np.array([math.cos(angle), math.sin(angle)])
        inside = np.abs(place - centre) <= 0.5 * np.array([depth, width]) - radius - 0.005
        if bool(inside.all()):
            break
    pose = _standing(float(place[0]), float(place[1]), table, cup.shape.height_m, 0.0)
    return replace(cup, name="blue cup", color="blue", world_T_object=pose)


def _apart(a: SceneItem, b: SceneItem) -> bool:
    between = a.world_T_object[:2, 3] - b.world_T_object[:2, 3]
    return float(np.linalg.norm(between)) >= OTHERS_APART_M


def _gap(a: SceneItem, b: SceneItem) -> bool:
    between = a.world_T_object[:2, 3] - b.world_T_object[:2, 3]
    return float(np.linalg.norm(between)) >= _reach_m(a) + _reach_m(b) + CLUTTER_GAP_M


def _reach_m(item: SceneItem) -> float:
    """Farthest point from the middle, seen from above."""
    shape = item.shape
    return 0.5 * math.hypot(*shape.size_m[:2]) if isinstance(shape, Box) else shape.radius_m
