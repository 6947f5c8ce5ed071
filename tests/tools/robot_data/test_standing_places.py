"""Places to stand, compared with the map and without: scenes that make sense, and counts that add up."""

import numpy as np
import pytest

from kinematics.scene.support_of import support_of
from tools.robot_data import standing_places
from tools.robot_data.standing_places import KINDS, THING, Comparison, Count, random_scene


@pytest.mark.parametrize("kind", KINDS)
def test_the_thing_stands_on_something_wherever_it_was_drawn(kind):
    for seed in range(10):
        scene = random_scene(kind, np.random.default_rng(seed))

        under = support_of(scene.objects[THING], scene, 0.01)

        assert under is not None
        assert not under.movable


def test_both_orders_ask_about_places_and_count_those_that_serve(monkeypatch):
    monkeypatch.setattr(standing_places, "MOST", 6)
    counts = {False: Count(), True: Count()}

    Comparison("talos").count(random_scene("table", np.random.default_rng(3)), 3, counts)

    for count in counts.values():
        assert count.scenes == 1
        assert 0 < count.asked <= 6
        assert count.first <= count.found <= count.served <= count.asked


def test_a_robot_that_has_no_map_is_refused():
    with pytest.raises(ValueError, match="no reachability map"):
        Comparison("panda")
