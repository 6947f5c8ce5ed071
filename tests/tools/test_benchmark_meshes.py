"""The same picks amid things of parts and amid their boxes."""

import numpy as np
import pytest

from kinematics.model.robot_model import RobotModel
from robots.models.description import load_description
from tools.benchmark.meshes import both
from tools.benchmark.problems.picks import TARGET
from tools.benchmark.problems.things_of_parts import KINDS, boxed


@pytest.mark.parametrize("kind", KINDS)
def test_what_is_made_of_parts_fills_its_box_and_no_more(kind):
    shape = boxed(kind(np.random.default_rng(1)))

    assert np.abs(shape.parts.corners).max(axis=0) == pytest.approx(0.5 * np.array(shape.size_m))
    assert len(shape.parts.hulls) > 2


def test_both_scenes_are_the_same_but_for_the_parts():
    for of_parts, boxes in both(RobotModel(load_description("talos")), 3, seed=5):
        assert of_parts.scene.objects.keys() == boxes.scene.objects.keys()
        for name, item in of_parts.scene.objects.items():
            other = boxes.scene.objects[name]
            assert np.array_equal(item.world_T_object, other.world_T_object)
            assert (item.shape.parts is not None) == item.movable
            assert other.shape.parts is None
            assert item.shape.height_m == other.shape.height_m
            if name != TARGET and item.movable:
                assert item.shape.size_m == other.shape.size_m
