"""Walking back to where the robot began."""

import math

import pytest

from kinematics.geometry.planar import PlanarPose
from robots.fake.fake_world import person
from trees.build import build_tree
from trees.readings.odometry import feet_pose
from trees.tasks import MoveTask, WalkToTask


def play(stage, task):
    return stage.play(build_tree(task, stage.toolbox))


@pytest.mark.requirement("M3")
def test_who_goes_back_to_the_start_stands_there_as_before(new_stage):
    stage = new_stage(person("Ana", (3.0, 2.0)), walks=True)
    assert play(stage, MoveTask("turn", 0.0, 0.5, 2.0)).status == "success"
    assert play(stage, MoveTask("walk ahead", 0.3, 0.0, None, 1.0)).status == "success"
    assert feet_pose(stage.toolbox).distance_m(PlanarPose()) > 0.9

    tree = play(stage, WalkToTask("go back", "start"))

    assert tree.status == "success", tree.failure
    there = feet_pose(stage.toolbox)
    assert math.hypot(there.x_m, there.y_m) < 0.02
    assert abs(there.yaw_rad) < math.radians(2.0)
