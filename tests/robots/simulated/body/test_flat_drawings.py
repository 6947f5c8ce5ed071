"""Drawings without a volume: the simulator takes them as shells."""

import mujoco
import numpy as np
import pytest

from robots.simulated.body.body_model import compiled


def drawn_by(vertices):
    spec = mujoco.MjSpec()
    spec.add_mesh(name="badge", uservert=np.ravel(vertices), userface=[0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3])
    spec.worldbody.add_body(name="link").add_geom(type=mujoco.mjtGeom.mjGEOM_MESH, meshname="badge")
    return spec


def test_a_drawing_without_a_volume_is_taken_as_a_shell():
    spec = drawn_by([(0, 0, 0), (0.1, 0, 0), (0, 0.1, 0), (0.03, 0.03, 1e-13)])
    with pytest.raises(ValueError, match="volume is too small: badge"):
        spec.compile()

    assert compiled(spec).nmesh == 1


def test_what_the_simulator_refuses_for_another_reason_stays_refused():
    spec = drawn_by([(0, 0, 0), (0.1, 0, 0), (0, 0.1, 0), (0, 0, 0.1)])
    spec.body("link").add_joint(type=mujoco.mjtJoint.mjJNT_HINGE, axis=(0, 0, 0))

    with pytest.raises(ValueError, match="axis"):
        compiled(spec)
