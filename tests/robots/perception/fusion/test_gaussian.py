"""Estimates take measurements in, and tell which do not fit."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.stats import chi2

from robots.perception.fusion.gaussian import FALSE_ALARM, Gaussian, Measurement


def measured(value, sigma, model=None):
    value = np.atleast_1d(np.array(value, dtype=np.float64))
    model = np.eye(len(value)) if model is None else np.array(model, dtype=np.float64)
    return Measurement("camera", 0.0, value, sigma**2 * np.eye(len(value)), model)


def test_two_equal_senses_meet_in_the_middle_and_are_surer_together():
    both = Gaussian(np.zeros(1), np.eye(1)).updated(measured(2.0, 1.0))

    assert both.mean == pytest.approx([1.0])
    assert both.covariance[0, 0] == pytest.approx(0.5)


def test_a_sense_that_feels_one_direction_leaves_the_others_alone():
    felt = Gaussian(np.zeros(2), np.eye(2)).updated(measured([3.0], 0.1, [[0.0, 1.0]]))

    assert felt.mean[0] == 0.0
    assert felt.covariance[0, 0] == 1.0


@given(st.lists(st.floats(-5.0, 5.0), min_size=3, max_size=3), st.floats(0.1, 3.0))
def test_the_order_of_two_measurements_does_not_matter(values, sigma):
    start, one, other = (
        Gaussian(np.zeros(3), np.eye(3)),
        measured(values, sigma),
        measured([1.0], 0.5, [[1, 1, 0]]),
    )
    first, last = start.updated(one).updated(other), start.updated(other).updated(one)

    np.testing.assert_allclose(first.mean, last.mean, atol=1e-9)
    np.testing.assert_allclose(first.covariance, last.covariance, atol=1e-9)


@pytest.mark.parametrize("numbers", [1, 2, 3, 4])
def test_senses_that_agree_are_seldom_taken_to_disagree(numbers):
    """As seldom as is declared."""
    edge = np.zeros(numbers)
    edge[0] = np.sqrt(2.0 * chi2.ppf(1.0 - FALSE_ALARM, numbers))
    start = Gaussian(np.zeros(numbers), np.eye(numbers))

    assert start.innovation(measured(1.001 * edge, 1.0)).disagrees
    assert not start.innovation(measured(0.999 * edge, 1.0)).disagrees
