"""The believed world as it is told to programs that draw it."""

import json

import numpy as np
import pytest

from executive.live.world_as_json import paths_json, world_json
from kinematics.geometry import poses
from kinematics.geometry.shapes import Ball, Box, Cylinder
from kinematics.model.robot_model import RobotModel
from kinematics.model.stance import Stance
from kinematics.motion.trajectory import Trajectory
from kinematics.scene.label import Label
from kinematics.scene.planning_scene import PlanningScene, SceneObject, floor
from robots.models.description import load_description
from robots.perception.object_estimate import ObjectEstimate
from robots.perception.position_error import alike_in_all_directions
from trees.world_model import WorldModel

CUP = SceneObject(
    "red cup", Cylinder(0.04, 0.1), poses.translation(0.5, 0.1, 0.9), 0.01, label=Label("cup", "red")
)
TABLE = SceneObject("table", Box((1.0, 0.8, 0.8)), poses.translation(0.9, 0.0, 0.4), 0.02, movable=False)
ANNA = SceneObject("Anna", Cylinder(0.25, 1.7), poses.translation(2.0, 1.0, 0.85), movable=False)
BALL = SceneObject("ball", Ball(0.05), poses.translation(3.0, 0.0, 0.05))


@pytest.fixture
def world():
    return WorldModel(PlanningScene(version=4).with_objects([floor(), CUP, TABLE, ANNA, BALL]))


def told(world):
    return {one["name"]: one for one in world_json(world)["things"]}


def test_solids_are_told_with_place_and_margin(world):
    things = told(world)

    assert (things["red cup"]["shape"], things["red cup"]["size_m"]) == ("cylinder", [0.04, 0.1])
    assert (things["table"]["shape"], things["table"]["size_m"]) == ("box", [1.0, 0.8, 0.8])
    assert (things["ball"]["shape"], things["ball"]["size_m"]) == ("ball", [0.05])
    assert things["red cup"]["place_m"] == [0.5, 0.1, 0.9]
    assert things["red cup"]["margin_m"] == 0.01


def test_people_furniture_and_objects_are_told_apart_and_the_floor_is_none(world):
    assert {name: one["is"] for name, one in told(world).items()} == {
        "red cup": "object",
        "table": "furniture",
        "Anna": "person",
        "ball": "object",
    }


def test_what_a_look_showed_is_told_with_its_error_and_confidence(world):
    error = alike_in_all_directions(0.003, 0.004, 0.0)
    estimate = ObjectEstimate(
        "object", "cup", "red", CUP.world_T_object, CUP.shape, 0.87, 5, 0.001, error=error
    )
    world.note_sightings({"red cup": estimate})

    assert told(world)["red cup"]["confidence"] == 0.87
    assert told(world)["red cup"]["error_m"] == pytest.approx([0.005] * 3)
    assert "confidence" not in told(world)["table"]


def test_what_a_hand_holds_is_told_in_the_frame_that_carries_it(world):
    in_hand = poses.translation(0.0, 0.0, 0.02)
    world.update(world.scene.with_attached("red cup", "gripper_left", in_hand, ()))

    cup = told(world)["red cup"]
    assert (cup["held"], cup["place_m"]) == ("gripper_left", [0.0, 0.0, 0.02])


def test_a_crowd_of_things_is_cut_to_a_message_the_nearest_first():
    crowd = [SceneObject(f"thing {i}", Ball(0.1), poses.translation(0.1 * i, 0.0, 0.0)) for i in range(2000)]
    things = world_json(WorldModel(PlanningScene().with_objects(crowd)))["things"]

    assert len(json.dumps(things)) < 45_000
    assert things[0]["name"] == "thing 0"
    assert np.all(np.diff([one["place_m"][0] for one in things]) > 0.0)


def test_the_ways_of_hands_that_move_are_told():
    model = RobotModel(load_description("talos"))
    q = np.repeat(model.q_home[None], 50, axis=0)
    joint = 7 + model.joints.index("arm_left_1_joint")
    q[:, joint] += np.linspace(0.0, 0.5, 50)
    planned = Trajectory(model.joints, Stance(()), np.linspace(0.0, 1.0, 50), q, np.zeros((50, model.nv)))

    (path,) = paths_json(model, planned)
    assert path["hand"] == "left"
    for at, row in ((0, 0), (-1, -1)):
        assert path["points_m"][at] == pytest.approx(
            model.frame_pose(q[row], model.description.tcp_frames["left"])[:3, 3], abs=1e-3
        )
    assert paths_json(model, None) == []
