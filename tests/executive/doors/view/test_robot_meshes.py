"""What a robot looks like, from its URDF."""

import numpy as np
import pytest
import trimesh

from executive.doors.view.robot_meshes import link_meshes, simplified
from robots.models.description import load_description

LINKS = {
    "primitives": """
      <robot name="r">
        <material name="orange"><color rgba="1 0.5 0 1"/></material>
        <link name="a">
          <visual><origin xyz="1 0 0" rpy="0 0 1.5707963"/><geometry><box size="2 0.2 0.4"/></geometry>
            <material name="orange"/></visual>
          <visual><geometry><sphere radius="0.1"/></geometry>
            <material name="own"><color rgba="0 0 1 1"/></material></visual>
        </link>
      </robot>""",
    "collada": """
      <robot name="r"><link name="a">
        <visual><geometry><mesh filename="/nowhere/a.dae"/></geometry></visual>
        <collision><geometry><cylinder radius="0.1" length="0.5"/></geometry></collision>
      </link></robot>""",
}


def test_solids_stand_at_their_origins_in_their_colours():
    box, ball = link_meshes(LINKS["primitives"])

    assert box.vertices.min(axis=0) == pytest.approx([0.9, -1.0, -0.2], abs=1e-6)
    assert box.vertices.max(axis=0) == pytest.approx([1.1, 1.0, 0.2], abs=1e-6)
    assert (box.rgb, ball.rgb) == ((255, 128, 0), (0, 0, 255))


def test_a_link_whose_mesh_cannot_be_read_shows_its_collision_solids():
    (solid,) = link_meshes(LINKS["collada"])

    assert np.ptp(solid.vertices, axis=0) == pytest.approx([0.2, 0.2, 0.5], abs=0.01)


@pytest.mark.parametrize("name", ["talos", "g1", "panda"])
def test_a_robot_is_drawn_with_few_enough_triangles(name):
    meshes = link_meshes(load_description(name).urdf)

    assert {mesh.link for mesh in meshes} >= {load_description(name).base_link}
    assert sum(len(mesh.faces) for mesh in meshes) < 50_000
    assert all(mesh.faces.max() < len(mesh.vertices) for mesh in meshes)


def test_a_simplified_mesh_stays_near_its_surface_with_fewer_triangles():
    ball = trimesh.creation.icosphere(subdivisions=5, radius=0.1)
    vertices, faces = simplified(np.asarray(ball.vertices), np.asarray(ball.faces))

    assert len(faces) < 0.1 * len(ball.faces)
    assert np.linalg.norm(vertices, axis=1) == pytest.approx(0.1, abs=0.008)


def test_a_mirrored_mesh_is_not_inside_out(tmp_path):
    trimesh.creation.box((0.1, 0.2, 0.3)).export(tmp_path / "box.stl")
    mesh = f'<mesh filename="{tmp_path / "box.stl"}" scale="1 -1 1"/>'
    (solid,) = link_meshes(
        f'<robot name="r"><link name="a"><visual><geometry>{mesh}</geometry></visual></link></robot>'
    )

    assert trimesh.Trimesh(solid.vertices, solid.faces).volume == pytest.approx(0.006, rel=1e-3)


def test_a_small_mesh_stays_as_it_is():
    box = trimesh.creation.box((0.002, 0.002, 0.002))

    assert simplified(np.asarray(box.vertices), np.asarray(box.faces))[1].shape == (12, 3)
