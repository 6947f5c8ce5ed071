"""What really is the case: what is seen, what touches, what stands and what is lifted."""

from dataclasses import replace

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.geometry.shapes import Box, Cylinder
from robots.interface.hardware import RobotData
from robots.models.description import load_robot
from robots.scenes.scene_description import Person, SceneDescription, SceneItem
from robots.scenes.scene_file import load_scene
from robots.simulated.truth.true_support import SupportPolygon, convex_hull
from robots.simulated.world import build_world

HARDWARE = load_robot("talos").hardware

TILT = "head_1_joint"


def looking_down(stand, scene):
    """A robot that has turned its head to the table."""
    body = stand(scene)
    joints = body.q[7:].copy()
    joints[body.model.joint_index(TILT)] = 0.6
    body.move_to(joints, 0.6)
    return body


def surface(truth, name):
    """Points on the sides of an object."""
    solid = next(item for item in truth.solids() if item.name == name)
    angles = np.linspace(0.0, 2.0 * np.pi, 24)
    ring = np.stack([np.cos(angles), np.sin(angles), np.zeros(24), np.ones(24) / 0.03], axis=1) * 0.03
    return (solid.world_T_object @ ring.T).T[:, :3]


def box_at(name, x, y, z, size=(0.02, 0.3, 0.3)):
    return SceneItem(name, "box", "blue", Box(size), 1.0, 0.6, poses.translation(x, y, z))


def test_a_cup_in_plain_sight_is_seen(stand):
    body = looking_down(stand, load_scene("tabletop"))
    assert body.truth.visible("red cup", surface(body.truth, "red cup")).all()


def test_a_cup_behind_a_screen_is_not_seen(stand):
    scene = load_scene("tabletop")
    screen = box_at("screen", 0.40, -0.2, 0.9 + 0.15)
    body = looking_down(stand, replace(scene, objects=(*scene.objects, screen)))

    assert not body.truth.visible("red cup", surface(body.truth, "red cup")).any()
    assert body.truth.visible("screen", np.array([[0.39, -0.2, 1.15]])).all()


def test_the_robots_own_hand_hides_what_is_behind_it(cup_in_hand):
    hold = cup_in_hand(hand="left")
    truth = hold.truth
    eye = truth.world_T_camera()[:3, 3]
    palm = truth.world_T_link("gripper_left_base_link")[:3, 3]
    behind = palm + 0.3 * (palm - eye) / np.linalg.norm(palm - eye)

    hold.stand.world.faults.teleport("cup", poses.translation(*behind))

    assert not truth.visible("cup", np.array([behind])).any()


def test_a_cup_between_the_fingers_is_still_seen(cup_in_hand):
    hold = cup_in_hand(hand="left")
    assert hold.truth.visible("cup", surface(hold.truth, "cup")).mean() > 0.25


def test_the_camera_looks_forward_and_down_when_the_head_is_tilted(stand):
    body = looking_down(stand, SceneDescription("empty"))
    forward = body.truth.world_T_camera()[:3, 2]

    assert forward[2] == pytest.approx(-np.sin(0.6), abs=0.01)
    assert forward[0] == pytest.approx(np.cos(0.6), abs=0.01)


def test_solids_come_in_a_fixed_order_with_their_true_poses(description):
    scene = load_scene("tabletop")
    world = build_world(RobotData(description, HARDWARE), scene, np.random.default_rng(0))
    names = [solid.name for solid in world.truth.solids()]

    assert names == ["table/top", *(f"table/leg_{i}" for i in (1, 2, 3, 4)), "red cup", "blue box"]
    for solid, item in zip(world.truth.solids()[5:], scene.objects, strict=True):
        assert solid.world_T_object == pytest.approx(item.world_T_object, abs=1e-9)


def test_objects_stand_still_on_the_table(stand):
    scene = load_scene("clutter")
    body = stand(scene)

    body.run(1.0)

    for item in scene.objects:
        moved = body.truth.world_T_object(item.name)[:3, 3] - item.world_T_object[:3, 3]
        assert np.linalg.norm(moved) < 0.001, item.name
        assert body.truth.contacts.of_object(item.name) == ("table/top",)
        assert abs(body.truth.lift_m(item.name)) < 0.001


def test_an_object_on_furniture_has_the_friction_of_the_furniture(stand):
    scene = load_scene("tabletop")
    slippery = replace(scene.furniture[0], friction=0.35)
    body = stand(replace(scene, furniture=(slippery,)))
    body.run(0.1)
    physics = body.world.physics
    table, cup = physics.scene_geom_id("table/top"), physics.scene_geom_id("red cup")
    rows = [i for i, pair in enumerate(physics.data.contact.geom) if set(pair) == {table, cup}]

    assert rows
    assert {float(physics.data.contact.friction[i, 0]) for i in rows} == {0.35}


def test_a_person_is_there_and_stands(description):
    scene = replace(load_scene("tabletop"), people=(Person("Ana", (1.5, 0.8), 3.14),))
    world = build_world(RobotData(description, HARDWARE), scene, np.random.default_rng(0))

    assert world.truth.contacts.robot_with_people() == ()
    assert not world.truth.visible("red cup", np.array([[2.5, 1.25, 1.2]])).any()


def test_a_robot_whose_joints_go_limp_has_fallen(stand):
    body = stand(SceneDescription("empty"))
    body.run(0.2)
    assert not body.truth.fallen()

    body.world.physics.model.actuator_gainprm[:, 0] = 0.0
    body.world.physics.model.actuator_biasprm[:, 1:3] = 0.0
    body.run(2.0)

    assert body.truth.fallen()
    assert body.truth.com_margin_m() < 0.05


def test_the_lift_of_an_object_counts_from_what_is_under_it(stand):
    body = stand(load_scene("tabletop"))
    body.world.faults.teleport("red cup", poses.translation(0.5, 0.0, 0.9 + 0.055 + 0.12))
    assert body.truth.lift_m("red cup") == pytest.approx(0.12)

    body.world.faults.teleport("red cup", poses.translation(-0.5, 1.0, 0.055))
    assert body.truth.lift_m("red cup") == pytest.approx(0.0)


def test_the_lowest_point_of_a_tilted_cylinder_is_its_rim(stand):
    item = SceneItem("cup", "cup", "red", Cylinder(0.03, 0.11), 0.2, 0.6, poses.translation(2.0, 0.0, 0.055))
    body = stand(SceneDescription("one", objects=(item,)))
    lying = poses.transform(poses.rotation_x(np.pi / 2.0), (2.0, 0.0, 0.3))

    body.world.faults.teleport("cup", lying)

    assert body.truth.lowest_m("cup") == pytest.approx(0.27)
    assert body.truth.tilt_rad("cup") == pytest.approx(np.pi / 2.0)


def test_the_margin_is_the_distance_to_the_nearest_edge():
    square = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.5, 0.5]])
    polygon = SupportPolygon()

    assert polygon.margin_m(np.array([0.5, 0.2]), square) == pytest.approx(0.2)
    assert polygon.margin_m(np.array([1.3, 0.5]), square) == pytest.approx(-0.3)
    assert polygon.margin_m(np.array([2.5, 0.5]), square + np.array([2.0, 0.0])) == pytest.approx(0.5)
    assert polygon.margin_m(np.array([0.0, 0.0]), np.zeros((0, 2))) == -np.inf
    assert len(convex_hull(square)) == 4
