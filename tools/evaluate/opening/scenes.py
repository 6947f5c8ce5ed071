"""Random doors and drawers before a robot that does not stand quite where it should.

Ranges are those of the evaluation's definition. A scene is written as TOML and read back before it is
used, so that the file of an episode is that episode to the last bit.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType

from robots.scenes.scene_description import (
    Furniture,
    MovingPart,
    PerceptionModel,
    RobotStart,
    SceneDescription,
)
from robots.scenes.scene_file import load_scene, read_scene
from robots.scenes.scene_writer import dump
from tools.evaluate.scenes import BENCH, LOW_TABLE, episode_rng

FURNITURE = "piece"
PAD_FRICTION = (0.7, 1.1)
INSET_M = (0.04, 0.10)
HANDLE_ERROR_M, RADIUS_ERROR_M = 0.02, 0.03
OPEN_RAD, OPEN_M = (math.radians(55.0), math.radians(72.0)), (0.20, 0.30)
CHEST_DEPTH_M = 0.50
BENCH_DRAWERS = "bench_drawers"
"""The scene of an arm that is bolted down: drawers alone; a camera behind the arm sees their fronts."""
LOW_KITCHEN = "low_kitchen"
"""The scene of a humanoid of a child's size."""
SCENES = (BENCH_DRAWERS, LOW_KITCHEN)
OPENED_BESIDE = MappingProxyType({BENCH: BENCH_DRAWERS, LOW_TABLE: LOW_KITCHEN})
"""Where what opens is, by where else things of that size are picked."""
LOCKED_EVERY = 4
"""One of so many is locked, in the suite that opens."""
Range = tuple[float, float]


@dataclass(frozen=True, slots=True)
class Household:
    """What stands before a robot of some size, and where the robot stands; ranges are (lowest, highest).

    Attributes:
        mass_kg, friction_nm, seal_n: Of doors.
        door_m: Depth, width and height of what has one.
        hinge_m, turned_rad: Where a door can be opened from: the plane of its hinge ahead, the hinge to the
            side, and how far the door is turned.
        bar_radius_m, handle_height_m: Of a door's bar.
        drawer_mass_kg, drawer_friction_n, drawer_bar_radius_m: Of drawers.
        chest_height_m, chest_ahead_m, chest_aside_m: Of what has one.
        either_side: Whether the chest may be at either side of the robot.
        stand_m, stand_rad: So far to any side the robot may stand off that place.
    """

    mass_kg: Range = (8.0, 20.0)
    friction_nm: Range = (1.0, 3.0)
    seal_n: Range = (20.0, 40.0)
    door_m: tuple[float, float, float] = (0.64, 0.60, 1.7)
    hinge_m: tuple[float, float] = (0.80, 0.75)
    turned_rad: float = 0.15
    bar_radius_m: Range = (0.011, 0.016)
    handle_height_m: Range = (0.95, 1.10)
    drawer_mass_kg: Range = (2.0, 8.0)
    drawer_friction_n: Range = (5.0, 15.0)
    drawer_bar_radius_m: Range = (0.008, 0.014)
    chest_height_m: Range = (0.98, 1.10)
    chest_ahead_m: Range = (0.70, 0.76)
    chest_aside_m: Range = (0.30, 0.42)
    either_side: bool = True
    stand_m: float = 0.08
    stand_rad: float = math.radians(8.0)


HOUSEHOLDS: Mapping[str | None, Household] = MappingProxyType(
    {
        None: Household(),
        BENCH_DRAWERS: Household(
            chest_height_m=(0.90, 1.15),
            chest_ahead_m=(0.78, 0.84),
            chest_aside_m=(-0.20, 0.20),
            either_side=False,
            stand_m=0.03,
            stand_rad=math.radians(5.0),
        ),
        LOW_KITCHEN: Household(
            mass_kg=(8.0, 8.0),
            friction_nm=(1.0, 1.0),
            seal_n=(10.0, 20.0),
            door_m=(0.50, 0.48, 1.25),
            hinge_m=(0.48, 0.65),
            handle_height_m=(0.80, 0.95),
            drawer_mass_kg=(2.0, 6.0),
            drawer_friction_n=(5.0, 12.0),
            drawer_bar_radius_m=(0.010, 0.014),
            chest_height_m=(0.84, 0.94),
            chest_ahead_m=(0.46, 0.52),
            chest_aside_m=(0.18, 0.26),
        ),
    }
)
"""By the name of the scene; None for a humanoid of a grown-up's size."""


@dataclass(frozen=True, slots=True)
class OpeningScene:
    """One episode's world.

    Attributes:
        toml: The scene.
        kind: "door" or "drawer".
        hinge: "left", "right", or "" for a drawer.
        locked: Whether it does not open.
        handle_error_m: Added to where the handle is seen, in the world, shape (3,).
        panel_error_m: Added to where a door is seen: moves the hinge, and so the radius, shape (3,).
    """

    toml: str
    kind: str
    hinge: str
    locked: bool
    handle_error_m: tuple[float, float, float]
    panel_error_m: tuple[float, float, float]

    def read(self) -> SceneDescription:
        """The scene."""
        return read_scene(self.toml, f"{FURNITURE}.toml", FURNITURE)


def opening_scene(seed: int, suite: str, draw_number: int = 0, where: str | None = None) -> OpeningScene:
    """The scene of one episode; doors of both hands and drawers take turns.

    Args:
        seed: The episode's.
        suite: "open" or "close".
        draw_number: How often it was drawn before and could not be.
        where: A name of ``HOUSEHOLDS``.
    """
    rng = episode_rng(seed, 7 if draw_number == 0 else 700 + draw_number)
    house, bench = HOUSEHOLDS[where], where == BENCH_DRAWERS

    def draw(low_high: tuple[float, float]) -> float:
        return float(rng.uniform(*low_high))

    closing = suite == "close"
    locked = not closing and seed % LOCKED_EVERY == LOCKED_EVERY - 1
    which = (seed // LOCKED_EVERY if locked else seed) % 3
    hinge = "" if bench else ("left", "right", "")[which]
    side = -1.0 if hinge == "right" else 1.0
    m, rad = house.stand_m, house.stand_rad
    start = RobotStart(draw((-m, m)), draw((-m, m)), draw((-rad, rad)))
    if hinge:
        part = MovingPart(
            hinge="left" if hinge == "left" else "right",
            mass_kg=draw(house.mass_kg),
            friction=draw(house.friction_nm),
            seal_n=draw(house.seal_n),
            locked=locked,
            opening=draw(OPEN_RAD) if closing else 0.0,
            handle_height_m=draw(house.handle_height_m),
            handle_inset_m=draw(INSET_M),
            handle_radius_m=draw(house.bar_radius_m),
            handle_friction=draw(PAD_FRICTION),
        )
        piece = _fridge(part, side, house)
    else:
        part = MovingPart(
            hinge=None,
            mass_kg=draw(house.drawer_mass_kg),
            friction=draw(house.drawer_friction_n),
            locked=locked,
            opening=draw(OPEN_M) if closing else 0.0,
            handle_height_m=0.0,
            handle_inset_m=0.0,
            handle_radius_m=draw(house.drawer_bar_radius_m),
            handle_length_m=0.16,
            handle_friction=draw(PAD_FRICTION),
        )
        aside = draw(house.chest_aside_m)
        if house.either_side:
            aside *= 1.0 if rng.random() < 0.5 else -1.0
        height, ahead = draw(house.chest_height_m), draw(house.chest_ahead_m)
        size = (CHEST_DEPTH_M, 0.45, height)
        place = (ahead + 0.5 * CHEST_DEPTH_M, aside)
        piece = Furniture(FURNITURE, "drawers", size, place, 0.0, opens=part)
    scene = SceneDescription(
        FURNITURE,
        start,
        PerceptionModel(bias_m=0.0, size_noise=0.0),
        furniture=(piece,),
        cameras=load_scene(BENCH_DRAWERS).cameras if bench else (),
    )
    x, y = (draw((-HANDLE_ERROR_M, HANDLE_ERROR_M)) for _ in range(2))
    radius = draw((-RADIUS_ERROR_M, RADIUS_ERROR_M)) if hinge else 0.0
    along = (math.sin(piece.yaw_rad) * radius, -math.cos(piece.yaw_rad) * radius)
    error = (x, y, draw((-0.01, 0.01)))
    panel = (x + along[0], y + along[1], 0.0)
    kind = "door" if hinge else "drawer"
    return OpeningScene(dump(scene), kind, hinge, locked, error, panel)


def _fridge(part: MovingPart, side: float, house: Household) -> Furniture:
    """A fridge whose hinge is where it can be opened from the nominal start."""
    yaw, (depth_m, width_m, _), (ahead_m, aside_m) = side * house.turned_rad, house.door_m, house.hinge_m
    half_depth, half_width = 0.5 * depth_m - 0.02, 0.5 * width_m
    c, s = math.cos(yaw), math.sin(yaw)
    ahead, aside = half_depth, -side * half_width
    place = (ahead_m + c * ahead - s * aside, side * aside_m + s * ahead + c * aside)
    return Furniture(FURNITURE, "fridge", house.door_m, place, yaw, opens=part)
