"""Random doors and drawers before a robot that does not stand quite where it should.

Ranges are those of the evaluation's definition. A scene is written as TOML and read back before it is
used, so that the file of an episode is that episode to the last bit.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from robots.scenes.scene_description import (
    Furniture,
    MovingPart,
    PerceptionModel,
    RobotStart,
    SceneDescription,
)
from robots.scenes.scene_file import load_scene, read_scene
from robots.scenes.scene_writer import dump
from tools.evaluate.scenes import episode_rng

FURNITURE = "piece"
MASS_KG, FRICTION_NM, SEAL_N = (8.0, 20.0), (1.0, 3.0), (20.0, 40.0)
DRAWER_MASS_KG, DRAWER_FRICTION_N = (2.0, 8.0), (5.0, 15.0)
PAD_FRICTION = (0.7, 1.1)
BAR_RADIUS_M, DRAWER_BAR_RADIUS_M = (0.011, 0.016), (0.008, 0.014)
HANDLE_HEIGHT_M, CHEST_HEIGHT_M = (0.95, 1.10), (0.98, 1.10)
DOOR_WIDTH_M, INSET_M = 0.60, (0.04, 0.10)
STAND_M, STAND_RAD = 0.08, math.radians(8.0)
HANDLE_ERROR_M, RADIUS_ERROR_M = 0.02, 0.03
OPEN_RAD, OPEN_M = (math.radians(55.0), math.radians(72.0)), (0.20, 0.30)
HINGE_AHEAD_M, HINGE_ASIDE_M, DOOR_TURNED_RAD = 0.80, 0.75, 0.15
"""Where a robot stands best to open a door: the plane of the hinge ahead, the hinge to the side."""
CHEST_AHEAD_M, CHEST_ASIDE_M = (0.70, 0.76), (0.30, 0.42)
FRIDGE_DEPTH_M, CHEST_DEPTH_M = 0.64, 0.50
BENCH_DRAWERS = "bench_drawers"
"""The scene of an arm that is bolted down: drawers alone; a camera behind the arm sees their fronts."""
BENCH_HEIGHT_M, BENCH_AHEAD_M, BENCH_ASIDE_M = (0.90, 1.15), (0.78, 0.84), (-0.20, 0.20)
BENCH_STAND_M, BENCH_STAND_RAD = 0.03, math.radians(5.0)
LOCKED_EVERY = 4
"""One of so many is locked, in the suite that opens."""


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


def opening_scene(seed: int, suite: str, draw_number: int = 0, bench: bool = False) -> OpeningScene:
    """The scene of one episode; doors of both hands and drawers take turns.

    Args:
        seed: The episode's.
        suite: "open" or "close".
        draw_number: How often it was drawn before and could not be.
        bench: Whether it is before an arm that is bolted down.
    """
    rng = episode_rng(seed, 7 if draw_number == 0 else 700 + draw_number)

    def draw(low_high: tuple[float, float]) -> float:
        return float(rng.uniform(*low_high))

    closing = suite == "close"
    locked = not closing and seed % LOCKED_EVERY == LOCKED_EVERY - 1
    which = (seed // LOCKED_EVERY if locked else seed) % 3
    hinge = "" if bench else ("left", "right", "")[which]
    side = -1.0 if hinge == "right" else 1.0
    stand_m, stand_rad = (BENCH_STAND_M, BENCH_STAND_RAD) if bench else (STAND_M, STAND_RAD)
    start = RobotStart(draw((-stand_m, stand_m)), draw((-stand_m, stand_m)), draw((-stand_rad, stand_rad)))
    if hinge:
        part = MovingPart(
            hinge="left" if hinge == "left" else "right",
            mass_kg=draw(MASS_KG),
            friction=draw(FRICTION_NM),
            seal_n=draw(SEAL_N),
            locked=locked,
            opening=draw(OPEN_RAD) if closing else 0.0,
            handle_height_m=draw(HANDLE_HEIGHT_M),
            handle_inset_m=draw(INSET_M),
            handle_radius_m=draw(BAR_RADIUS_M),
            handle_friction=draw(PAD_FRICTION),
        )
        piece = _fridge(part, side)
    else:
        part = MovingPart(
            hinge=None,
            mass_kg=draw(DRAWER_MASS_KG),
            friction=draw(DRAWER_FRICTION_N),
            locked=locked,
            opening=draw(OPEN_M) if closing else 0.0,
            handle_height_m=0.0,
            handle_inset_m=0.0,
            handle_radius_m=draw(DRAWER_BAR_RADIUS_M),
            handle_length_m=0.16,
            handle_friction=draw(PAD_FRICTION),
        )
        if bench:
            aside, height, ahead = draw(BENCH_ASIDE_M), draw(BENCH_HEIGHT_M), draw(BENCH_AHEAD_M)
        else:
            aside = draw(CHEST_ASIDE_M) * (1.0 if rng.random() < 0.5 else -1.0)
            height, ahead = draw(CHEST_HEIGHT_M), draw(CHEST_AHEAD_M)
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


def _fridge(part: MovingPart, side: float) -> Furniture:
    """A fridge whose hinge is where it can be opened from the nominal start."""
    yaw = side * DOOR_TURNED_RAD
    half_depth, half_width = 0.5 * FRIDGE_DEPTH_M - 0.02, 0.5 * DOOR_WIDTH_M
    c, s = math.cos(yaw), math.sin(yaw)
    ahead, aside = half_depth, -side * half_width
    place = (
        HINGE_AHEAD_M + c * ahead - s * aside,
        side * HINGE_ASIDE_M + s * ahead + c * aside,
    )
    return Furniture(FURNITURE, "fridge", (FRIDGE_DEPTH_M, DOOR_WIDTH_M, 1.7), place, yaw, opens=part)
