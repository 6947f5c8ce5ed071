"""Doors and drawers of fixtures really move, and perception tells them apart."""

from dataclasses import replace

import numpy as np
import pytest

from robots.interface.hardware import RobotData
from robots.models.description import load_robot
from robots.scenes.moving_parts import moving_parts
from robots.scenes.scene_file import load_scene
from robots.simulated.body.furniture_model import part_body
from robots.simulated.world import build_world

HARDWARE = load_robot("talos").hardware
PERIOD_S = 0.002
PARTS = ["cabinet/top drawer", "cabinet/middle drawer", "cabinet/bottom drawer", "microwave/door"]


def pulled(world, name, force_n, seconds):
    """Pull at a handle, square to its front, and tell how far it opens."""
    physics = world.physics
    pieces = physics.scene.furniture
    part = next(one for piece in pieces for one in moving_parts(piece) if one.name == name)
    bar, body = physics.scene_geom_id(f"{name}/handle"), physics.body_id(part_body(part))
    data = physics.data
    for _ in range(round(seconds / PERIOD_S)):
        outwards = data.xmat[body].reshape(3, 3) @ np.array([-1.0, 0.0, 0.0])
        torque = np.cross(data.geom_xpos[bar] - data.xipos[body], force_n * outwards)
        data.xfrc_applied[body] = [*(force_n * outwards), *torque]
        world.robot.advance(PERIOD_S)
    return world.truth.opening(name)


@pytest.fixture
def world(description):
    return build_world(RobotData(description, HARDWARE), load_scene("cabinet"), np.random.default_rng(0))


@pytest.mark.parametrize("name", PARTS)
def test_one_opens_and_the_others_stay(world, name):
    opening = pulled(world, name, 6.0, 0.6)

    assert opening > 0.1
    assert all(abs(world.truth.opening(other)) < 1e-6 for other in PARTS if other != name)


def test_a_locked_one_holds(description):
    scene = load_scene("cabinet")
    furniture = tuple(
        replace(piece, openings=tuple(replace(one, locked=True) for one in piece.openings))
        for piece in scene.furniture
    )
    world = build_world(
        RobotData(description, HARDWARE), replace(scene, furniture=furniture), np.random.default_rng(0)
    )

    assert pulled(world, "cabinet/top drawer", 60.0, 0.3) < 0.002


def test_the_truth_tells_each_solid_with_the_part_that_it_is_of(world):
    pulled(world, "cabinet/top drawer", 6.0, 0.6)
    told = {solid.name: solid for solid in world.truth.solids() if solid.moves is not None}
    front = told["cabinet/top drawer/front"]
    moved_m = np.linalg.norm(front.world_T_object[:3, 3] - front.moves.shut[:3, 3])

    assert moved_m == pytest.approx(world.truth.opening("cabinet/top drawer"), abs=1e-6)
    assert {solid.moves.part for solid in told.values() if solid.moves.of == "cabinet"} == {
        "top drawer",
        "middle drawer",
        "bottom drawer",
    }
    assert told["cabinet/top drawer/handle"].moves.is_of(front.moves)
