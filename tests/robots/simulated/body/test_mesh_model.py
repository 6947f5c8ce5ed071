"""Objects that have a mesh, in the simulator: what touches, what is seen, where they come to rest."""

import mujoco
import numpy as np
import pytest

from robots.models.description import load_robot
from robots.perception.sight import Sight
from robots.scenes.importing.import_object import import_object
from robots.scenes.scene_file import load_scene
from robots.simulated.body.geom_roles import Role
from robots.simulated.world import build_world
from tests import foreign_meshes as foreign

TABLE = """
[[furniture]]
name = "table"
kind = "table"
size_m = [0.6, 1.2, 0.85]
position_m = [0.65, 0.0]
"""


@pytest.fixture(scope="module")
def world(tmp_path_factory):
    folder = tmp_path_factory.mktemp("meshes")
    import_object(foreign.written(foreign.bottle(), folder, "bottle.obj"))
    import_object(foreign.written(foreign.can(), folder, "can.obj"))
    file = folder / "scene.toml"
    file.write_text(
        f'{TABLE}\n[[object]]\nmesh = "bottle.obj"\non = "table"\nposition_m = [-0.1, 0.1]\nmass_kg = 0.4\n'
        f'[[object]]\nmesh = "can.obj"\non = "table"\nposition_m = [-0.1, -0.2]\n'
    )
    return build_world(load_robot("talos"), load_scene(str(file)), np.random.default_rng(0))


def test_its_convex_parts_touch_and_what_is_seen_of_it_does_not(world):
    physics = world.physics
    parts = physics.object_geoms["bottle"]

    assert len(parts) == len(physics.scene.objects[0].model.parts.ends) > 1
    assert all(physics.geom_role[geom] == Role.OBJECT for geom in parts)
    looks = physics.scene_geom_id("bottle/looks")
    assert not physics.model.geom_contype[looks]
    assert not physics.model.geom_conaffinity[looks]
    assert int(physics.model.geom_type[looks]) == int(mujoco.mjtGeom.mjGEOM_MESH)


def test_it_weighs_what_the_scene_says(world):
    body = world.physics.object_body["bottle"]

    assert world.physics.model.body_subtreemass[body] == pytest.approx(0.4)


def test_it_stands_where_it_was_put_and_rests_on_the_table_alone(world):
    before = world.truth.world_T_object("bottle")

    for _ in range(300):
        mujoco.mj_step(world.physics.model, world.physics.data)

    assert world.truth.world_T_object("bottle")[:3, 3] == pytest.approx(before[:3, 3], abs=0.002)
    assert world.truth.tilt_rad("bottle") < 0.02
    assert world.truth.lowest_m("bottle") == pytest.approx(0.85, abs=0.002)
    assert world.truth.contacts.of_object("bottle") == ("table/top",)


def test_a_camera_that_sees_it_sees_points_of_its_surface(world):
    description = world.physics.description
    world_T_camera = world.truth.world_T_camera()
    # as the head would look down at the table
    bottle = next(solid for solid in world.truth.solids() if solid.name == "bottle")
    away = bottle.world_T_object[:3, 3] - world_T_camera[:3, 3]
    z = away / np.linalg.norm(away)
    x = np.cross(z, (0.0, 0.0, 1.0))
    x /= np.linalg.norm(x)
    looking = world_T_camera.copy()
    looking[:3, :3] = np.column_stack([x, np.cross(z, x), z])

    (share,) = Sight(world.truth, description.camera).shares([bottle], looking)

    assert share > 0.8


def test_contacts_of_things_of_parts_are_solved_apart_from_the_robots(world):
    """In one solve that ended when the robot's were settled, a can of 26 g and 24 solids crept."""
    plain = build_world(load_robot("talos"), load_scene("tabletop"), np.random.default_rng(0))
    at_once = int(mujoco.mjtDisableBit.mjDSBL_ISLAND)

    assert not world.physics.model.opt.disableflags & at_once
    assert plain.physics.model.opt.disableflags & at_once
