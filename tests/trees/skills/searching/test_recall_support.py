"""What was seen before is looked for first where it stood: before the furniture, from its nearest side."""

import math

import pytest
from py_trees.common import Status

from kinematics.geometry import poses
from kinematics.scene.planning_scene import SceneObject
from robots.fake.fake_world import cup, table
from trees.skills.searching.recall_support import RecallSupport
from trees.tasks import FindTask, ObjectDescription

CUP = ObjectDescription("cup", "red")


@pytest.fixture
def recall(stage):
    """Runs the leaf with a cup on a table, or beside it, both turned and moved by a pose."""

    def run(odom_T_things, on_table=True, wanted=CUP):
        solids = [
            SceneObject(
                one.name, one.shape, odom_T_things @ one.world_T_object, 0.0, one.category == "object"
            )
            for one in ((table(), cup()) if on_table else (cup(),))
        ]
        stage.told.update(stage.told.scene.with_objects(solids))
        leaf = RecallSupport("recall", stage.toolbox, {"place": "stood_on"})
        status = stage.run(leaf, task=FindTask("find it", wanted))
        return stage.output("stood_on") if status is Status.SUCCESS else None

    return run


@pytest.mark.parametrize(
    "pose",
    [
        poses.translation(3.0, 0.0, 0.0),
        poses.transform(poses.rotation_z(math.pi), (0.0, 0.0, 0.0)),
        poses.transform(poses.rotation_z(-0.5 * math.pi), (0.0, 0.0, 0.0)),
    ],
)
def test_the_furniture_is_recalled_that_is_far_or_beside_or_behind(recall, pose):
    place = recall(pose)

    assert (place.name, place.category) == ("table", "furniture")


def test_what_stands_ahead_was_looked_for_from_here(stage, recall):
    assert recall(poses.translation(0.0, 0.0, 0.0)) is None
    assert "looked at from here" in stage.failed()[-1].message


def test_what_stood_on_nothing_known_is_recalled_itself(recall):
    place = recall(poses.translation(3.0, 0.0, 0.0), on_table=False)

    assert (place.name, place.category) == ("red cup", "object")


def test_what_was_never_seen_is_not_recalled(recall):
    assert recall(poses.translation(3.0, 0.0, 0.0), wanted=ObjectDescription("bottle")) is None
