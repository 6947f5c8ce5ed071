"""What crosses the socket beside trajectories: orders of yielding hands, where walks go, range scans."""

import json

import numpy as np
import pytest

import kinematics.walking.pattern.steering as steering_module
from kinematics.errors import KinematicsError
from kinematics.geometry import poses
from kinematics.geometry.planar import PlanarPose
from kinematics.geometry.shapes import Box, Cylinder
from kinematics.scene.opening_path import DoorArc, DrawerLine
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from kinematics.walking.pattern.gazing import Gazing
from kinematics.walking.pattern.steering import (
    PathSteering,
    StretchSteering,
    TurnSteering,
    VelocitySteering,
)
from robots.control.hands.yield_order import YieldOrder
from robots.live.documents.scan_message import RangeScan, read_scan, write_scan
from robots.live.documents.steering_document import read_steering, write_steering
from robots.live.documents.yield_document import read_yield_order, write_yield_order

ARC = DoorArc(np.array([0.8, 0.7]), 0.15, 1.0, 0.45, 0.05, 1.1)
LINE = DrawerLine(np.array([0.6, 0.1, 0.7]), -0.2)


def scene(talos):
    door = SceneObject("door", Box((0.02, 0.5, 1.2)), poses.translation(0.8, 0.4, 1.0), 0.02, movable=False)
    cup = SceneObject("cup", Cylinder(0.03, 0.11), poses.translation(0.5, -0.4, 0.9), 0.01)
    jar = SceneObject("jar", Cylinder(0.03, 0.11), poses.translation(0.4, -0.3, 1.0))
    around = PlanningScene().with_objects([door, cup, jar])
    held = around.with_attached(
        "jar", "tcp_right", poses.translation(0.0, 0.0, 0.01), ["gripper_right_base_link"]
    )
    link = sorted(talos.description.grippers["left"].touch_links)[0]
    return held.allowing([(link, "door"), (link, "a thing that is gone")])


@pytest.mark.requirement("S6")
@pytest.mark.parametrize("path", [ARC, LINE], ids=["door", "drawer"])
@pytest.mark.parametrize("bias", [None, np.arange(6.0) / 7.0], ids=["no bias", "bias"])
def test_an_order_comes_back_as_it_was_given(talos, path, bias):
    sent = YieldOrder("left", scene(talos), ("door",), path, 0.1, 0.9, bias, 0.05, False, "gentle")

    read = read_yield_order(write_yield_order(sent, talos), talos, talos.q_home)

    for name in ("hand", "parts", "s_from", "s_to", "stop_from", "holding", "manner"):
        assert getattr(read, name) == getattr(sent, name), name
    assert (read.bias is None) == (bias is None)
    np.testing.assert_array_equal(read.path.at(0.3).position_m, path.at(0.3).position_m)
    assert list(read.scene.objects) == ["door", "cup"]
    assert not read.scene.objects["door"].movable
    assert read.scene.objects["cup"].movable
    assert read.scene.attached["jar"].frame == "tcp_right"
    assert {pair for pair in sent.scene.allowed if "door" in pair} == read.scene.allowed


@pytest.mark.requirement("F4", "F8")
@pytest.mark.parametrize(
    ("key", "value"),
    [
        ("hand", "third"),
        ("manner", "with all its might"),
        ("s_to", 1e9),
        ("s_to", None),
        ("holding", 1),
        ("bias", [1.0]),
        ("bias", [0.0, 11.0, 0.0, 0.0, 0.0, 0.0]),
        ("path", {"kind": "elevator"}),
        ("force_limit_n", 500.0),
        ("allowed", [["door", "x"]]),
        ("allowed", [["arm_left_5_link", "torso_2_link"]]),
        ("allowed", [["gripper_left_base_link", "floor"]]),
    ],
)
def test_an_order_that_is_none_is_refused_with_its_place(talos, key, value):
    order = YieldOrder("left", scene(talos), ("door",), ARC, 0.1, 0.9)
    document = json.loads(write_yield_order(order, talos))
    document[key] = value

    with pytest.raises(KinematicsError, match=key):
        read_yield_order(json.dumps(document), talos, talos.q_home)


@pytest.mark.requirement("S6")
@pytest.mark.parametrize("key", ["objects", "held"])
def test_an_order_cannot_make_a_solid_vanish_by_naming_another_like_it(talos, key):
    document = json.loads(
        write_yield_order(YieldOrder("left", scene(talos), ("door",), ARC, 0.1, 0.9), talos)
    )
    document[key].append({**document[key][0], "shape": {"kind": "ball", "radius_m": 0.001}})

    with pytest.raises(KinematicsError, match=f"{key}: .* is there twice"):
        read_yield_order(json.dumps(document), talos, talos.q_home)


def steerings(settings):
    poses_ = (PlanarPose(0.1, 0.2, 0.3), PlanarPose(1.0, -0.5, 7.0))
    return [
        VelocitySteering(settings, 0.2, -0.3),
        VelocitySteering(settings, 0.2, -0.3, quick=True),
        TurnSteering(settings, -0.3, 0.1),
        StretchSteering(settings, poses_[0], -0.2, 0.5),
        PathSteering(settings, poses_),
    ]


def test_every_steering_comes_back_and_walks_the_same_way(talos):
    settings = talos.description.walking
    body, before = PlanarPose(0.2, 0.1, 0.4), PlanarPose(0.05)
    kinds = set()
    for sent in steerings(settings):
        read = read_steering(write_steering(sent), settings)
        assert read.advance(body, before) == sent.advance(body, before)
        assert getattr(read, "quick", False) == getattr(sent, "quick", False)
        kinds.add(type(read).__name__)

    offered = {name for name in vars(steering_module) if name.endswith("Steering") and name != "Steering"}
    assert kinds == offered


def test_where_the_head_looks_on_a_walk_comes_back(talos):
    settings = talos.description.walking

    for sent in steerings(settings):
        read = read_steering(write_steering(Gazing(sent, 0.5, 0.2)), settings)
        assert (read.pan_rad, read.tilt_rad, type(read.steering)) == (0.5, 0.2, type(sent))


def test_the_pace_of_a_path_comes_back(talos):
    settings = talos.description.walking
    path = PathSteering(settings, (PlanarPose(), PlanarPose(3.0)), 0.9)

    assert read_steering(write_steering(path), settings).pace == 0.9


@pytest.mark.requirement("F4", "F8")
@pytest.mark.parametrize(
    "document",
    ['{"kind": "path", "path": [[0, 0, 0]], "pace": 1.5}',
     '{"kind": "path", "path": [[0, 0, 0]], "gaze": {}}',
     '{"kind": "velocity", "linear_m_s": 99, "angular_rad_s": 0}', '{"kind": "path", "path": []}',
     '{"kind": "path", "path": [[0, 0]]}', '{"kind": "fly"}', "[]", "{"],
)  # fmt: skip
def test_a_steering_that_is_none_is_refused(talos, document):
    with pytest.raises(KinematicsError):
        read_steering(document, talos.description.walking)


def test_a_scan_comes_back_to_the_millimetre_and_keeps_its_nearest_points():
    points = np.random.default_rng(1).uniform(-4.0, 4.0, (2500, 3))
    payload = write_scan(RangeScan(3.5, points))

    read = read_scan(json.loads(payload))

    assert len(payload) < 65_536
    assert read.stamp_s == 3.5
    reach_m = np.sort(np.hypot(points[:, 0], points[:, 1]))[1999]
    assert np.hypot(read.points_m[:, 0], read.points_m[:, 1]).max() <= reach_m + 1e-3
    few = read_scan(json.loads(write_scan(RangeScan(0.0, points[:5]))))
    np.testing.assert_allclose(few.points_m, points[:5], atol=5.1e-4)
    assert read_scan(json.loads(write_scan(RangeScan(0.0, np.zeros((0, 3)))))).points_m.shape == (0, 3)
