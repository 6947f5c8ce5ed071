import itertools

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinematics.curves import PolynomialCurve, RoundedPolyline

ONES = np.ones(3)


@given(st.integers(2, 5), st.integers(0, 1000))
def test_a_polynomial_runs_through_its_points(count, seed):
    points = np.random.default_rng(seed).uniform(-1, 1, (count, 3))

    curve = PolynomialCurve(points)

    assert curve(np.linspace(0, 1, count)) == pytest.approx(points, abs=1e-9)


def test_too_many_points_are_refused():
    with pytest.raises(ValueError, match="2 to 5 points, got 6"):
        PolynomialCurve(np.zeros((6, 3)))


def test_a_straight_polyline_stays_straight_and_even():
    curve = RoundedPolyline(np.array([[0.0, 0, 0], [1, 2, 3]]), ONES, 0.1)

    s = np.linspace(0, 1, 50)
    assert curve(s) == pytest.approx(s[:, None] * [[1, 2, 3]], abs=1e-12)


@given(st.integers(0, 1000))
def test_a_rounded_corner_is_left_by_less_than_the_spacing(seed):
    points = np.random.default_rng(seed).uniform(-1, 1, (4, 3))
    curve = RoundedPolyline(points, ONES, 0.1)

    dense = np.concatenate(
        [a + (b - a) * np.linspace(0, 1, 400)[:, None] for a, b in itertools.pairwise(points)]
    )
    for point in curve(np.linspace(0, 1, 200)):
        assert np.sqrt(np.sum((dense - point) ** 2, axis=1)).min() < 0.1
    assert curve(np.array([0.0, 1.0])) == pytest.approx(points[[0, -1]])
