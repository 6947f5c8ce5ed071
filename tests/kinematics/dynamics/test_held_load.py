import numpy as np
import pinocchio as pin
import pytest

from kinematics.dynamics.held_load import loaded, loads_in
from kinematics.geometry import poses
from kinematics.geometry.shapes import Cylinder
from kinematics.motion.trajectory import HeldLoad
from kinematics.scene.planning_scene import PlanningScene, SceneObject


@pytest.fixture
def holding(talos):
    gripper = talos.description.grippers["left"]
    scene = PlanningScene().with_object(SceneObject("bottle", Cylinder(0.035, 0.2), np.eye(4)))
    place = poses.translation(0.02, 0.0, -0.05)
    return scene.with_attached("bottle", gripper.tcp_frame, place, gripper.touch_links)


def test_what_was_not_weighed_is_no_load(holding):
    assert loads_in(holding) == ()


def test_what_was_weighed_is_a_load_where_the_object_is(holding):
    assert loads_in(holding.with_held_mass("bottle", 1.0)) == (HeldLoad("tcp_left", 1.0, (0.02, 0.0, -0.05)),)


def test_a_body_that_is_let_go_of_and_taken_again_has_to_be_weighed_again(holding):
    put = holding.with_held_mass("bottle", 1.0).with_detached("bottle", np.eye(4))

    assert loads_in(put.with_attached("bottle", "tcp_left", np.eye(4), ())) == ()


def test_the_com_with_a_load_is_that_of_the_robot_and_the_object(talos, holding):
    model = loaded(talos, loads_in(holding.with_held_mass("bottle", 1.0)))
    q = pin.integrate(talos.pin, talos.q_home, 0.2 * np.random.default_rng(0).standard_normal(talos.nv))

    bottle = (talos.frame_pose(q, "tcp_left") @ holding.attached["bottle"].frame_T_object)[:3, 3]
    both = (talos.mass_kg * talos.com(q) + bottle) / (talos.mass_kg + 1.0)
    np.testing.assert_allclose(model.com(q), both, atol=1e-9)
    assert model.mass_kg == pytest.approx(talos.mass_kg + 1.0)


def test_the_robot_with_the_same_load_is_made_once(talos, holding):
    loads = loads_in(holding.with_held_mass("bottle", 1.0))

    assert loaded(talos, loads) is loaded(talos, loads)
    assert loaded(talos, ()) is talos
