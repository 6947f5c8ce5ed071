"""Drawings that the simulator does not take as they are: without a volume, or written as text."""

import mujoco
import numpy as np
import pytest

from robots.simulated.body.body_model import compiled_spec, is_unread
from tests.foreign_meshes import trimesh


def drawn_by(vertices):
    spec = mujoco.MjSpec()
    spec.add_mesh(name="badge", uservert=np.ravel(vertices), userface=[0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3])
    spec.worldbody.add_body(name="link").add_geom(type=mujoco.mjtGeom.mjGEOM_MESH, meshname="badge")
    return spec


def test_a_drawing_without_a_volume_is_taken_as_a_shell():
    spec = drawn_by([(0, 0, 0), (0.1, 0, 0), (0, 0.1, 0), (0.03, 0.03, 1e-13)])
    with pytest.raises(ValueError, match="volume is too small: badge"):
        spec.compile()

    assert compiled_spec(spec).nmesh == 1


def test_what_the_simulator_refuses_for_another_reason_stays_refused():
    spec = drawn_by([(0, 0, 0), (0.1, 0, 0), (0, 0.1, 0), (0, 0, 0.1)])
    spec.body("link").add_joint(type=mujoco.mjtJoint.mjJNT_HINGE, axis=(0, 0, 0))

    with pytest.raises(ValueError, match="axis"):
        compiled_spec(spec)


@pytest.mark.parametrize(
    ("kind", "head", "unread"),
    [("stl_ascii", b"", True), ("stl", b"", False), ("stl", b"solid of somebody's", False)],
)
def test_an_stl_that_is_written_as_text_is_known_by_what_is_in_it(tmp_path, kind, head, unread):
    content = trimesh.creation.box((0.1, 0.1, 0.1)).export(file_type=kind)
    content = content.encode() if isinstance(content, str) else head + content[len(head) :]
    (tmp_path / "box.STL").write_bytes(content)

    assert is_unread("box.STL", tmp_path) is unread


@pytest.mark.parametrize(("file", "unread"), [("arm.DAE", True), ("arm.obj", False), ("none.stl", False)])
def test_other_drawings_are_known_by_their_endings(tmp_path, file, unread):
    assert is_unread(file, tmp_path) is unread
