"""Balls that hold points: as small as they may be, or nearly so."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinematics.distance.enclosing_ball import ball_centre


def radius_about(centre, points):
    return np.linalg.norm(points - centre, axis=1).max()


@pytest.mark.parametrize("seed", range(5))
def test_points_on_a_sphere_are_held_by_that_sphere(seed):
    rng = np.random.default_rng(seed)
    ways = rng.normal(size=(60, 3))
    middle = rng.uniform(-3.0, 3.0, 3)
    points = middle + 0.1 * ways / np.linalg.norm(ways, axis=1)[:, None]

    centre = ball_centre(points)

    assert radius_about(centre, points) < 0.1 * 1.02
    assert np.linalg.norm(centre - middle) < 0.02


@given(st.integers(0, 10_000), st.integers(1, 40))
def test_a_ball_is_larger_than_the_smallest_by_no_more_than_is_proven(seed, count):
    points = np.random.default_rng(seed).normal(size=(count, 3))
    apart = np.linalg.norm(points[:, None] - points[None], axis=2)
    i, j = np.unravel_index(int(apart.argmax()), apart.shape)

    found = radius_about(ball_centre(points), points)

    assert found >= 0.5 * apart[i, j] - 1e-12
    # after k steps by no more than a share of 1 / sqrt(k); the smallest is no larger than this one
    assert found <= (1.0 + 200**-0.5) * radius_about(0.5 * (points[i] + points[j]), points) + 1e-12


def test_a_long_row_of_points_is_held_about_its_middle():
    row = np.zeros((11, 3))
    row[:, 1] = np.linspace(2.0, 3.0, 11) ** 3

    assert ball_centre(row) == pytest.approx([0.0, 17.5, 0.0], abs=0.1)
