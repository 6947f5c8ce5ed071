"""What a range sensor sees is kept where it is, whoever moves."""

import math

import numpy as np
import pytest

from kinematics.geometry.planar import PlanarPose
from kinematics.walking.route.path_planning import Footprint
from trees.skills.walking.seen_points import SeenPoints


class Scripted:
    """A range sensor whose scans are given."""

    def __init__(self, *scans):
        self.scans = list(scans)

    def scan(self):
        return self.scans.pop(0)


def points(*places):
    return np.array([(x, y, 0.5) for x, y in places])


@pytest.mark.requirement("S2")
def test_points_are_placed_by_where_the_body_is():
    seen = SeenPoints(Scripted(points((1.0, 0.0))))

    new = seen.look(PlanarPose(2.0, 1.0, math.pi / 2.0))

    np.testing.assert_allclose(new, [(2.0, 2.0)], atol=1e-9)


def test_what_was_seen_before_is_not_new():
    seen = SeenPoints(Scripted(points((1.0, 0.0)), points((1.01, 0.0), (1.0, 1.0))))
    seen.look(PlanarPose())

    new = seen.look(PlanarPose())

    np.testing.assert_allclose(new, [(1.0, 1.0)], atol=1e-9)
    assert len(seen.beside(())) == 2


def test_points_of_something_known_are_left_out():
    table = Footprint(PlanarPose(1.0, 0.0), 0.3, 0.6)
    seen = SeenPoints(Scripted(points((0.65, 0.2), (1.0, 1.0))))
    seen.look(PlanarPose())

    np.testing.assert_allclose(seen.beside((table,)), [(1.0, 1.0)], atol=1e-9)


def test_a_sensor_that_says_nothing_is_noticed():
    seen = SeenPoints(Scripted(None, points((1.0, 0.0))))

    assert len(seen.look(PlanarPose())) == 0
    assert seen.silent
    seen.look(PlanarPose())
    assert not seen.silent


def test_what_is_as_tall_as_the_hands_is_told_apart_though_it_is_seen_low_as_well():
    scan = np.array([(1.0, 0.0, 1.2), (1.0, 0.0, 0.3), (2.0, 0.0, 0.3)])
    seen = SeenPoints(Scripted(scan))
    seen.look(PlanarPose())

    np.testing.assert_allclose(seen.beside((), above_m=1.0), [(1.0, 0.0)], atol=1e-9)
    assert len(seen.beside(())) == 2
