"""The scenes of a household, as worlds: nothing creeps, tips, sinks or rolls away."""

import math
from dataclasses import replace

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.geometry.shapes import Ball, Box, Cylinder
from robots.scenes.scene_description import SceneItem
from robots.scenes.scene_file import load_scene
from robots.scenes.scene_rules import validate

STILL_M = 0.001
BALL_ROLLS_M = 0.01
UPRIGHT_RAD = math.radians(0.5)


@pytest.mark.parametrize("name", ["shelf", "counter", "dinner"])
def test_everything_stands_as_the_scene_says_for_ten_seconds(stand, name):
    scene = load_scene(name)
    body = stand(scene)

    body.run(10.0)

    assert not body.truth.fallen()
    for item in scene.objects:
        moved = body.truth.world_T_object(item.name)[:3, 3] - item.world_T_object[:3, 3]
        assert np.linalg.norm(moved) < STILL_M, item.name
        assert body.truth.tilt_rad(item.name) < UPRIGHT_RAD, item.name


def full(kind, shape):
    """The tabletop with something hollow on it that holds a ball and a can."""
    scene = load_scene("tabletop")
    (table,) = scene.furniture
    x, y, top = *table.position_m, table.size_m[2]

    def thing(name, shape, across, bottom, wall_m=None):
        pose = poses.translation(x, y + across, top + bottom + 0.5 * shape.height_m)
        return SceneItem(name, name.split()[-1], name.split()[0], shape, 0.2, 0.6, pose, wall_m)

    things = (
        thing(f"white {kind}", shape, 0.0, 0.0, 0.01),
        thing("green ball", Ball(0.03), 0.05, 0.01),
        thing("yellow can", Cylinder(0.03, 0.12), -0.05, 0.01),
    )
    return replace(scene, objects=things)


@pytest.mark.parametrize(("kind", "shape"), [("box", Box((0.2, 0.3, 0.08))), ("bowl", Cylinder(0.12, 0.08))])
def test_what_stands_inside_something_hollow_stays_there(stand, kind, shape):
    scene = full(kind, shape)
    validate(scene, "full")
    body = stand(scene)

    body.run(10.0)

    for item in scene.objects:
        moved = body.truth.world_T_object(item.name)[:3, 3] - item.world_T_object[:3, 3]
        assert np.linalg.norm(moved) < (BALL_ROLLS_M if "ball" in item.name else STILL_M), item.name


def test_the_lift_of_an_object_counts_from_the_board_that_it_is_over(stand):
    body = stand(load_scene("shelf"))
    assert body.truth.lift_m("red cup") == pytest.approx(0.0, abs=1e-3)

    lifted = body.truth.world_T_object("red cup") @ poses.translation(0.0, 0.0, 0.05)
    body.world.faults.teleport("red cup", lifted)

    assert body.truth.lift_m("red cup") == pytest.approx(0.05, abs=1e-3)
