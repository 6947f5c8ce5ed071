"""Least squares within bounds."""

import numpy as np
import pytest

from kinematics.following.boxed_least_squares import boxed_least_squares


@pytest.mark.parametrize("seed", range(60))
def test_nothing_within_the_bounds_is_better(seed):
    rng = np.random.default_rng(seed)
    n = 12
    rows = rng.normal(size=(8, n))
    normal = rows.T @ rows + 1e-4 * np.eye(n)
    right = rows.T @ rng.normal(size=8, scale=20.0)
    middle = rng.normal(size=n, scale=0.3)
    low, high = middle - rng.uniform(0.0, 0.1, n), middle + rng.uniform(0.0, 0.1, n)

    x = boxed_least_squares(normal, right, low, high)

    assert np.all(x >= low)
    assert np.all(x <= high)
    slope = normal @ x - right
    assert np.all(slope[x <= low] >= -1e-6), "something would rather leave its lower bound"
    assert np.all(slope[x >= high] <= 1e-6), "something would rather leave its upper bound"
    inside = (x > low) & (x < high)
    assert np.abs(slope[inside]).max(initial=0.0) <= 1e-6


def test_without_a_bound_that_matters_it_is_the_plain_answer():
    normal, right = np.diag([2.0, 4.0]), np.array([2.0, 2.0])

    x = boxed_least_squares(normal, right, np.array([-5.0, -5.0]), np.array([5.0, 5.0]))

    np.testing.assert_allclose(x, [1.0, 0.5])


def test_a_coordinate_without_room_stays_where_it_is():
    normal, right = np.array([[2.0, 0.5], [0.5, 2.0]]), np.array([4.0, 4.0])

    x = boxed_least_squares(normal, right, np.array([0.0, -9.0]), np.array([0.0, 9.0]))

    np.testing.assert_allclose(x, [0.0, 2.0])
