"""Doors and drawers that really move, and handles that only pads can hold."""

import math
from dataclasses import replace

import mujoco
import numpy as np
import pytest

from robots.interface.hardware import RobotData
from robots.models.description import load_robot
from robots.scenes.scene_file import load_scene
from robots.simulated.body.furniture_model import part_body, part_joint
from robots.simulated.body.geom_roles import CONAFFINITY, CONTYPE, Role
from robots.simulated.world import build_world

HARDWARE = load_robot("talos").hardware

PERIOD_S = 0.002


def world_of(description, name, **changes):
    scene = load_scene(name)
    (piece,) = scene.furniture
    piece = replace(piece, opens=replace(piece.opens, **changes))
    return build_world(
        RobotData(description, HARDWARE),
        replace(scene, furniture=(piece,)),
        np.random.default_rng(0),
    )


def pulled(world, force_n, seconds):
    """Pull at the handle, outwards, and tell how far it opens."""
    physics = world.physics
    (piece,) = physics.scene.furniture
    bar = physics.scene_geom_id(f"{piece.name}/handle")
    body = physics.body_id(part_body(piece))
    model, data = physics.model, physics.data
    joint = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_JOINT, part_joint(piece))
    for _ in range(round(seconds / PERIOD_S)):
        outwards = data.xmat[body].reshape(3, 3) @ np.array([-1.0, 0.0, 0.0])
        torque = np.cross(data.geom_xpos[bar] - data.xipos[body], force_n * outwards)
        data.xfrc_applied[body] = [*(force_n * outwards), *torque]
        world.robot.advance(PERIOD_S)
    assert model.jnt_dofadr[joint] >= 0
    return world.truth.opening(piece.name)


def test_a_sealed_door_gives_way_to_more_than_its_seal_and_friction(description):
    firm = pulled(world_of(description, "fridge", seal_n=30.0, friction=2.0), 28.0, 0.5)
    loose = pulled(world_of(description, "fridge", seal_n=30.0, friction=2.0), 45.0, 0.5)

    assert firm < math.radians(0.3)
    assert loose > math.radians(3.0)


def test_a_locked_door_holds_against_any_pull(description):
    assert pulled(world_of(description, "fridge", locked=True), 200.0, 0.3) < 0.002


def test_a_drawer_slides_against_its_friction(description):
    assert pulled(world_of(description, "drawers", friction=10.0), 8.0, 0.3) < 0.001
    assert pulled(world_of(description, "drawers", friction=10.0), 20.0, 0.3) > 0.02


def test_perception_is_shown_door_and_handle_where_they_are_now(description):
    world = world_of(description, "fridge", opening=1.0)
    closed = world_of(description, "fridge")

    def yaw_of(world, kind):
        (solid,) = (solid for solid in world.truth.solids() if solid.kind == kind)
        return math.atan2(solid.world_T_object[1, 0], solid.world_T_object[0, 0])

    assert yaw_of(closed, "door") - yaw_of(world, "door") == pytest.approx(1.0, abs=1e-3)


def test_fingers_cannot_hold_a_handle_by_their_hulls():
    def touch(a, b):
        return bool(CONTYPE[a] & CONAFFINITY[b] or CONTYPE[b] & CONAFFINITY[a])

    assert touch(Role.HANDLE, Role.PAD)
    assert not touch(Role.HANDLE, Role.FINGER)
