"""Six kinds of scenes in the style of the known motion benchmarks, drawn at random.

The kinds follow those of MotionBenchMaker (Chamzas et al., RA-L 2022): a table with things on it, a
tall and a thin bookshelf, a box, a cage of bars, and a kitchen. Sizes and places are this project's own.
All is in the frame of the arm's base, which stands on the floor at z = 0.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from kinematics.geometry import poses
from kinematics.geometry.poses import Transform
from kinematics.geometry.shapes import Ball, Box, Cylinder, Shape
from kinematics.scene.planning_scene import SceneObject

Rng = np.random.Generator
Place = Callable[[Rng], Transform]
"""Draws a pose of the TCP."""

# Thickness of boards and walls.
BOARD_M = 0.02


@dataclass(frozen=True, slots=True)
class Setting:
    """A scene and where the hand may start and end in it.

    Attributes:
        objects: The solids.
        start: Draws a pose to start from, or None to start near the ready posture.
        goal: Draws a pose to end at.
    """

    objects: tuple[SceneObject, ...]
    start: Place | None
    goal: Place


def table_pick(rng: Rng) -> Setting:
    """Reach between things on a table, to one of them."""
    top = float(rng.uniform(0.1, 0.35))
    table = _Builder(poses.translation(float(rng.uniform(0.55, 0.65)), 0.0, top))
    table.box("table", (0.6, 1.3, 0.04), (0.0, 0.0, -0.02))
    spots = _spread(rng, int(rng.integers(5, 10)), (-0.22, 0.18), (-0.45, 0.45), 0.13)
    for i, (x, y) in enumerate(spots):
        table.thing(f"thing {i}", rng, x, y, 0.0)
    targets = [table.above(x, y) for x, y in spots]

    def goal(draw: Rng) -> Transform:
        x, y, height = targets[int(draw.integers(len(targets)))]
        tilt = float(draw.uniform(0.0, 1.2))
        return table.base @ _grasp(
            draw, (x, y, max(0.05, 0.6 * height)), tilt, float(draw.uniform(0.0, 0.04))
        )

    return Setting(tuple(table.objects), None, goal)


def bookshelf_tall(rng: Rng) -> Setting:
    """From one board of a tall shelf to another."""
    return _bookshelf(rng, width=float(rng.uniform(0.75, 0.95)), spacing=(0.30, 0.38), columns=1)


def bookshelf_thin(rng: Rng) -> Setting:
    """From one narrow compartment of a shelf to another."""
    return _bookshelf(rng, width=float(rng.uniform(0.7, 0.8)), spacing=(0.30, 0.36), columns=2)


def box(rng: Rng) -> Setting:
    """Down into a box that is open at its top."""
    width, depth, height = rng.uniform((0.32, 0.32, 0.16), (0.46, 0.50, 0.30)).tolist()
    bottom = float(rng.uniform(0.0, 0.25))
    turn = float(rng.uniform(-0.6, 0.6))
    where = poses.translation(float(rng.uniform(0.50, 0.62)), float(rng.uniform(-0.25, 0.25)), bottom)
    crate = _Builder(where @ poses.transform(poses.rotation_z(turn), (0, 0, 0)))
    crate.box("bottom", (width, depth, BOARD_M), (0.0, 0.0, BOARD_M / 2))
    for name, x in (("near wall", -width / 2), ("far wall", width / 2)):
        crate.box(name, (BOARD_M, depth, height), (x, 0.0, height / 2))
    for name, y in (("right wall", -depth / 2), ("left wall", depth / 2)):
        crate.box(name, (width, BOARD_M, height), (0.0, y, height / 2))
    inner = (0.5 * width - 0.08, 0.5 * depth - 0.08)
    for i, (x, y) in enumerate(_spread(rng, 3, (-inner[0], inner[0]), (-inner[1], inner[1]), 0.12)):
        crate.thing(f"thing {i}", rng, x, y, BOARD_M, tallest=0.12)

    def goal(draw: Rng) -> Transform:
        x, y = draw.uniform((-inner[0], -inner[1]), inner)
        z = float(draw.uniform(0.04, 0.6 * height))
        return crate.base @ _grasp(draw, (float(x), float(y), z), float(draw.uniform(0.0, 0.35)), 0.0)

    def start(draw: Rng) -> Transform:
        beside = poses.translation(*draw.uniform((0.35, 0.0, 0.08), (0.6, 0.15, 0.3)).tolist())
        side = 1.0 if draw.uniform() < 0.5 else -1.0
        beside[1, 3] = where[1, 3] + side * (beside[1, 3] + 0.40)
        return beside @ _grasp(draw, (0.0, 0.0, 0.0), float(draw.uniform(0.0, 0.4)), 0.0)

    return Setting(tuple(crate.objects), start, goal)


def cage(rng: Rng) -> Setting:
    """Between the bars of a cage, to a thing in its middle."""
    half_x, half_y = rng.uniform(0.24, 0.30, 2).tolist()
    height, bar = float(rng.uniform(0.40, 0.5)), float(rng.uniform(0.006, 0.012))
    where = poses.translation(float(rng.uniform(0.55, 0.65)), float(rng.uniform(-0.15, 0.15)), 0.0)
    pen = _Builder(where @ poses.transform(poses.rotation_z(float(rng.uniform(-0.4, 0.4))), (0, 0, 0)))
    rim = [
        *((x, y) for x in np.linspace(-half_x, half_x, 3) for y in (-half_y, half_y)),
        *((x, 0.0) for x in (-half_x, half_x)),
    ]
    for i, (x, y) in enumerate(rim):
        pen.cylinder(f"bar {i}", bar, height, (float(x), y, height / 2))
    along_x, along_y = poses.rotation_y(np.pi / 2), poses.rotation_x(np.pi / 2)
    for level, z in enumerate((0.04, height)):
        for i, y in enumerate((-half_y, half_y)):
            pen.cylinder(f"rail x {level} {i}", bar, 2 * half_x, (0.0, y, z), along_x)
        for i, x in enumerate((-half_x, half_x)):
            pen.cylinder(f"rail y {level} {i}", bar, 2 * half_y, (x, 0.0, z), along_y)
    spot = rng.uniform((-0.06, -0.06), (0.06, 0.06)).tolist()
    pen.thing("thing", rng, spot[0], spot[1], 0.0, tallest=0.2)
    x, y, top = pen.above(spot[0], spot[1])

    def goal(draw: Rng) -> Transform:
        return pen.base @ _grasp(draw, (x, y, top + 0.02), float(draw.uniform(0.0, 1.3)), 0.0)

    return Setting(tuple(pen.objects), None, goal)


def kitchen(rng: Rng) -> Setting:
    """From a counter into the cupboard above it, or back, past cups, a tap and an open door."""
    room = _Builder(poses.transform(poses.rotation_z(float(rng.uniform(-0.25, 0.25))), (0, 0, 0)))
    front, depth = float(rng.uniform(0.36, 0.44)), 0.40
    top, low = float(rng.uniform(0.10, 0.2)), float(rng.uniform(0.60, 0.68))
    back = front + depth
    room.box("counter", (depth, 1.6, 0.04), (front + depth / 2, 0.0, top - 0.02))
    room.box("backsplash", (BOARD_M, 1.6, 1.2), (back + BOARD_M / 2, 0.0, top + 0.6))
    inside = 0.28
    for name, z in (("cupboard floor", low), ("cupboard ceiling", low + 0.34)):
        room.box(name, (inside, 0.7, BOARD_M), (back - inside / 2, 0.0, z))
    for name, y in (("cupboard right", -0.35), ("cupboard left", 0.35)):
        room.box(name, (inside, BOARD_M, 0.34), (back - inside / 2, y, low + 0.17))
    side = 1.0 if rng.uniform() < 0.5 else -1.0
    room.box("open door", (0.33, BOARD_M, 0.34), (back - inside - 0.17, side * 0.37, low + 0.17))
    tap_y = float(rng.uniform(-0.5, 0.5))
    room.cylinder("tap", 0.015, 0.25, (back - 0.08, tap_y, top + 0.125))
    room.ball("tap end", 0.03, (back - 0.08, tap_y, top + 0.27))
    spots = _spread(rng, 5, (front + 0.06, back - 0.14), (-0.5, 0.5), 0.14)
    for i, (x, y) in enumerate(spots):
        room.thing(f"thing {i}", rng, x, y, top, tallest=0.2)
    shelf = _spread(rng, 2, (back - 0.18, back - 0.06), (-0.25, 0.25), 0.2)
    for i, (x, y) in enumerate(shelf):
        room.thing(f"cup {i}", rng, x, y, low + BOARD_M / 2, tallest=0.14)

    def on_counter(draw: Rng) -> Transform:
        x, y = draw.uniform((front + 0.05, -0.4), (back - 0.16, 0.4))
        point = (float(x), float(y), top + float(draw.uniform(0.05, 0.12)))
        return room.base @ _grasp(draw, point, float(draw.uniform(0.0, 1.2)), 0.0)

    def in_cupboard(draw: Rng) -> Transform:
        x, y, z = draw.uniform((back - 0.24, -0.26, low + 0.08), (back - 0.10, 0.26, low + 0.24))
        return room.base @ _ahead(draw, (float(x), float(y), float(z)))

    if rng.uniform() < 0.5:
        return Setting(tuple(room.objects), on_counter, in_cupboard)
    return Setting(tuple(room.objects), in_cupboard, on_counter)


FAMILIES: dict[str, Callable[[Rng], Setting]] = {
    "table_pick": table_pick,
    "bookshelf_tall": bookshelf_tall,
    "bookshelf_thin": bookshelf_thin,
    "box": box,
    "cage": cage,
    "kitchen": kitchen,
}


def _bookshelf(rng: Rng, width: float, spacing: tuple[float, float], columns: int) -> Setting:
    depth, pitch = float(rng.uniform(0.26, 0.32)), float(rng.uniform(*spacing))
    turn = poses.transform(poses.rotation_z(float(rng.uniform(-0.5, 0.5))), (0, 0, 0))
    shelf = _Builder(turn @ poses.translation(float(rng.uniform(0.48, 0.58)), 0.0, 0.0))
    first, boards = float(rng.uniform(0.05, 0.15)), 4
    height = (boards - 1) * pitch
    for i in range(boards):
        shelf.box(f"board {i}", (depth, width, BOARD_M), (depth / 2, 0.0, first + i * pitch))
    walls = np.linspace(-width / 2, width / 2, columns + 1)
    for i, y in enumerate(walls):
        shelf.box(f"wall {i}", (depth, BOARD_M, height), (depth / 2, float(y), first + height / 2))
    shelf.box("back", (BOARD_M, width, height), (depth + BOARD_M / 2, 0.0, first + height / 2))
    column = width / columns
    for i in range(boards - 1):
        for k in range(columns):
            middle = float(walls[k]) + column / 2
            room = column / 2 - 0.06
            for n, (x, y) in enumerate(_spread(rng, 2, (0.12, depth - 0.05), (-room, room), 0.12)):
                floor = first + i * pitch + BOARD_M / 2
                shelf.thing(f"book {i} {k} {n}", rng, x, middle + y, floor, tallest=0.6 * pitch)

    def inside(level: int) -> Place:
        def place(draw: Rng) -> Transform:
            middle = float(walls[int(draw.integers(columns))]) + column / 2
            y = middle + float(draw.uniform(-1.0, 1.0)) * (column / 2 - 0.12)
            z = first + level * pitch + float(draw.uniform(0.3, 0.7)) * pitch
            return shelf.base @ _ahead(draw, (float(draw.uniform(0.03, 0.16)), y, z))

        return place

    levels = rng.permutation(boards - 1)
    return Setting(tuple(shelf.objects), inside(int(levels[0])), inside(int(levels[1])))


class _Builder:
    """Collects solids that are placed in a frame of their own."""

    def __init__(self, base: Transform) -> None:
        self.base = base
        self.objects: list[SceneObject] = []
        self._tops: dict[tuple[float, float], float] = {}

    def box(self, name: str, size: tuple[float, float, float], centre: tuple[float, float, float]) -> None:
        self._add(name, Box(size), poses.translation(*centre))

    def cylinder(
        self,
        name: str,
        radius: float,
        height: float,
        centre: tuple[float, float, float],
        rotation: NDArray[np.float64] | None = None,
    ) -> None:
        turned = np.eye(3) if rotation is None else rotation
        self._add(name, Cylinder(radius, height), poses.transform(turned, centre))

    def ball(self, name: str, radius: float, centre: tuple[float, float, float]) -> None:
        self._add(name, Ball(radius), poses.translation(*centre))

    def thing(self, name: str, rng: Rng, x: float, y: float, floor: float, tallest: float = 0.25) -> None:
        """Something that a hand could take: a can, a carton or a ball, on a floor."""
        kind, height = rng.uniform(), float(rng.uniform(0.08, max(0.09, tallest)))
        if kind < 0.6:
            self.cylinder(name, float(rng.uniform(0.02, 0.035)), height, (x, y, floor + height / 2))
        elif kind < 0.9:
            size = rng.uniform(0.04, 0.065, 2).tolist()
            self.box(name, (size[0], size[1], height), (x, y, floor + height / 2))
        else:
            radius = float(rng.uniform(0.025, 0.038))
            self.ball(name, radius, (x, y, floor + radius))
            height = 2 * radius
        self._tops[x, y] = floor + height

    def above(self, x: float, y: float) -> tuple[float, float, float]:
        """Where a thing stands and how high it reaches."""
        return x, y, self._tops[x, y]

    def _add(self, name: str, shape: Shape, pose: Transform) -> None:
        self.objects.append(SceneObject(name, shape, self.base @ pose, movable=False))


def _spread(
    rng: Rng, count: int, x: tuple[float, float], y: tuple[float, float], apart: float
) -> list[tuple[float, float]]:
    """Up to ``count`` places in a rectangle, no two nearer than ``apart``."""
    found: list[tuple[float, float]] = []
    for _ in range(40 * count):
        spot = (float(rng.uniform(*x)), float(rng.uniform(*y)))
        if all(np.hypot(spot[0] - a, spot[1] - b) > apart for a, b in found):
            found.append(spot)
        if len(found) == count:
            break
    return found


def _grasp(rng: Rng, point: tuple[float, float, float], tilt_rad: float, retreat_m: float) -> Transform:
    """A hand at a point: from above (no tilt) to from the side (a quarter turn), from any heading ahead."""
    heading = float(rng.uniform(-1.0, 1.0))
    roll = float(rng.uniform(-np.pi, np.pi)) if tilt_rad < 0.3 else float(rng.choice([0.0, np.pi]))
    # z of the TCP is its approach: down, then tilted towards the heading
    down = poses.rotation_z(heading) @ poses.rotation_y(np.pi - tilt_rad)
    world_T_tcp = poses.transform(down @ poses.rotation_z(roll), point)
    return world_T_tcp @ poses.translation(0.0, 0.0, -retreat_m)


def _ahead(rng: Rng, point: tuple[float, float, float]) -> Transform:
    """A hand that points ahead, about level, its fingers opening sideways."""
    heading, dip = rng.uniform((-0.35, -0.2), (0.35, 0.35)).tolist()
    rotation = poses.rotation_z(heading) @ poses.rotation_y(np.pi / 2 + dip)
    return poses.transform(rotation @ poses.rotation_z(float(rng.choice([0.0, np.pi]))), point)
