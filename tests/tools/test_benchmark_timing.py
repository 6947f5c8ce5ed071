"""What is demanded of timing, apart from processor time, on the benchmark's own paths."""

import pytest

from tools.benchmark.timing import DEVIATION, timing


@pytest.fixture(scope="module")
def figures():
    return timing(quick=True)


def of(figures, what, peer=None):
    return [item for item in figures if what in item.name and (peer is None or peer in (item.peer or ""))]


@pytest.mark.parametrize("geometry", ["corners cut by", "our blends", "where our motion runs"])
def test_limited_jerk_costs_at_most_a_fifth_of_the_least_time(figures, geometry):
    ratios = [item.ratio for item in of(figures, "duration", geometry)]

    assert len(ratios) == 2
    assert all(1.0 < ratio <= 1.20 for ratio in ratios)


def test_not_stopping_at_near_corners_saves_a_tenth_of_the_time(figures):
    (near,) = of(figures, "steps of 0.5 rad: duration", "stop")

    assert 1.0 / near.ratio >= 1.10


def test_no_joint_is_farther_from_the_polyline_than_stated(figures):
    for item in of(figures, "distance"):
        assert item.ours * item.spread <= DEVIATION
