"""The next stretch behind somebody."""

import math

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.geometry.planar import PlanarPose
from kinematics.geometry.shapes import Box
from kinematics.scene.planning_scene import SceneObject
from kinematics.walking.route.room import WalkingRoom
from trees.skills.follow.way_behind import WayBehind


@pytest.fixture
def way(stage_with):
    """Makes planners among things on the floor, with the arms drawn in."""
    stage = stage_with(walks=True)

    def among(*boxes):
        things = [
            SceneObject(f"thing {k}", Box((*size, 1.0)), poses.translation(x, y, 0.5), 0.0, False)
            for k, ((x, y), size) in enumerate(boxes)
        ]
        stage.told.update(stage.told.scene.with_objects(things))
        settings = stage.toolbox.model.description.walking
        return WayBehind(stage.toolbox, settings, WalkingRoom(settings, tucked=True))

    among.stage = stage
    return among


def end_of(stretch):
    return stretch.steering.goal


def test_on_a_free_floor_it_leads_straight_to_this_side_of_the_person(way):
    stretch = way().behind(PlanarPose(), (3.0, 0.0), 1.0)

    assert len(stretch.steering.path) == 2
    assert (end_of(stretch).x_m, end_of(stretch).y_m) == pytest.approx((2.0, 0.0))


def test_it_ends_facing_the_person(way):
    stretch = way().behind(PlanarPose(), (2.0, 2.0), 1.0)

    assert end_of(stretch).yaw_rad == pytest.approx(math.pi / 4)


def test_who_is_near_is_turned_to_on_the_spot(way):
    stretch = way().behind(PlanarPose(), (0.0, 0.8), 1.0)

    assert (end_of(stretch).x_m, end_of(stretch).y_m) == (0.0, 0.0)
    assert end_of(stretch).yaw_rad == pytest.approx(math.pi / 2)


def test_where_something_stands_in_between_it_leads_around(way):
    stretch = way(((2.0, 0.0), (0.3, 0.3))).behind(PlanarPose(), (5.0, 0.0), 1.0)

    assert len(stretch.steering.path) > 2


def test_where_something_stands_beside_the_person_it_ends_elsewhere(way):
    stretch = way(((2.0, 0.0), (0.3, 0.3))).behind(PlanarPose(), (3.0, 0.0), 1.0)

    assert math.dist((2.0, 0.0), (end_of(stretch).x_m, end_of(stretch).y_m)) > 0.6
    assert math.dist((3.0, 0.0), (end_of(stretch).x_m, end_of(stretch).y_m)) >= 0.99


def test_the_person_is_no_obstacle(way):
    ways = way()
    way.stage.fake.ranging.points_m = np.array([(2.76, y, 1.0) for y in np.linspace(-0.2, 0.2, 9)])

    stretch = ways.behind(PlanarPose(), (3.0, 0.0), 1.0)

    assert end_of(stretch).x_m == pytest.approx(2.0)


def test_a_way_is_kept_until_something_comes_into_it(way):
    ways = way()
    stretch = ways.to(PlanarPose(), PlanarPose(4.0))
    before = ways.is_free(PlanarPose(), stretch)
    way.stage.fake.ranging.points_m = np.array([(2.0, 0.3, 1.0)])

    assert before
    assert not ways.is_free(PlanarPose(), stretch)


def test_what_is_behind_on_a_way_does_not_bar_it(way):
    ways = way()
    stretch = ways.to(PlanarPose(), PlanarPose(4.0))
    way.stage.fake.ranging.points_m = np.array([(-1.2, 0.0, 1.0)])  # who comes along behind

    assert ways.is_free(PlanarPose(2.0), stretch)
