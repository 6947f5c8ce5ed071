"""Gestures at who or what is behind the robot: it turns around where it gets back, among rooms."""

import dataclasses
import math

import pytest

from kinematics.geometry.planar import PlanarPose
from robots.fake.fake_world import cup, person, table
from robots.scenes.scene_description import Region
from trees.build import build_tree
from trees.readings.odometry import feet_pose
from trees.tasks import LookAtTask, MoveTask, ObjectDescription, PointAtTask, WaveTask

BEHIND = person("Ana", (-1.5, 0.3))
ROOMS = {"hall": Region("hall", (0.0, 0.0), (6.0, 6.0))}
GESTURES = [
    WaveTask("wave to Ana", "Ana"),
    LookAtTask("look at Ana", person="Ana"),
    PointAtTask("there", person="Ana"),
]


@pytest.mark.requirement("M3")
@pytest.mark.parametrize("task", GESTURES)
@pytest.mark.parametrize(("places", "status"), [(ROOMS, "success"), ({}, "failure")])
def test_who_is_behind_is_turned_to_among_rooms(new_stage, task, places, status):
    stage = new_stage(walks=True)
    if places:
        stage.when("turn around", lambda: stage.fake.world.put(BEHIND))

    tree = stage.play(build_tree(task, dataclasses.replace(stage.toolbox, places=places)))

    assert tree.status == status
    assert status == "success" or tree.failure.root.message == "no Ana seen"


def test_nobody_turns_around_from_what_is_in_view(new_stage):
    stage = new_stage(table(), cup(), walks=True)

    tree = stage.play(
        build_tree(
            PointAtTask("there", ObjectDescription("cup")), dataclasses.replace(stage.toolbox, places=ROOMS)
        )
    )

    assert tree.status == "success"
    assert not [event for event in stage.events if "viewpoint" in getattr(event, "where", "")]


@pytest.mark.requirement("M3")
@pytest.mark.parametrize("task", GESTURES[:2])
def test_away_from_where_it_began_the_robot_turns_around_without_rooms_too(new_stage, task):
    stage = new_stage(walks=True)
    stage.fake.world.put(BEHIND)
    away = MoveTask("turn around", 0.0, 0.5, 3.0)

    assert stage.play(build_tree(away, stage.toolbox)).status == "success"
    tree = stage.play(build_tree(task, stage.toolbox))

    assert tree.status == "success"


@pytest.mark.requirement("M3")
def test_the_hand_beside_the_person_is_the_one_on_their_side_of_the_robot(new_stage):
    stage = new_stage(walks=True)
    assert stage.play(build_tree(MoveTask("turn", 0.0, 0.5, 3.0), stage.toolbox)).status == "success"
    there = feet_pose(stage.toolbox) @ PlanarPose(1.5, -0.3)
    assert there.y_m > 0.5  # to the left of where it began
    stage.fake.world.put(person("Ana", (there.x_m, there.y_m)))

    tree = stage.play(build_tree(WaveTask("wave to Ana", "Ana"), stage.toolbox))

    assert tree.status == "success", tree.failure
    assert tree.evidence["hand"] == "right"


@pytest.mark.requirement("M3")
def test_who_stands_beside_the_robot_is_turned_to_before_a_hand_is_raised(new_stage):
    stage = new_stage(walks=True)
    stage.fake.world.put(person("Ana", (-0.2, 1.4)))

    tree = stage.play(build_tree(WaveTask("wave to Ana", "Ana"), stage.toolbox))

    assert tree.status == "success", tree.failure
    soles = [PlanarPose.of(pose) for _, pose in stage.fake.motion.stance().soles]
    there = PlanarPose.between(soles[0], soles[1]).to(PlanarPose(-0.2, 1.4))
    assert abs(math.atan2(there.y_m, there.x_m)) < 0.1
