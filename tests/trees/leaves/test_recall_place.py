"""What stays where it is can be walked to out of sight; what a hand may have moved cannot."""

import pytest
from py_trees.common import Status

from kinematics.scene import SceneObject
from robots.fake.fake_world import cup, person, table
from trees.leaves.recall_place import RecallPlace
from trees.tasks import ObjectDescription, WalkToTask


@pytest.fixture
def recall(stage):
    """Runs the leaf in a world with a table, a cup and Ana, all of them out of view."""
    solids = [
        SceneObject(one.name, one.shape, one.world_T_object, 0.0, movable=one.category == "object")
        for one in (table(), cup(), person())
    ]
    stage.told.update(stage.told.scene.with_objects(solids))

    def run(to):
        status = stage.run(RecallPlace("recall it", stage.toolbox), task=WalkToTask("walk there", to))
        return stage.output("place") if status is Status.SUCCESS else None

    return run


@pytest.mark.parametrize(
    ("to", "category"),
    [("Ana", "person"), ("table", "furniture"), (ObjectDescription("table"), "furniture")],
)
def test_people_and_furniture_are_recalled(recall, to, category):
    assert recall(to).category == category


def test_an_object_is_not_recalled(recall):
    assert recall(ObjectDescription("cup", "red")) is None
    assert recall("red cup") is None


def test_what_was_never_seen_is_not_recalled(recall):
    assert recall("Ben") is None
