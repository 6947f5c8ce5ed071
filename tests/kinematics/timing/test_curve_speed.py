"""The fastest rates along a curve, held against linear programs that somebody else solves."""

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from scipy.optimize import linprog

from kinematics.motion.curves import BlendedPolyline, RoundedPolyline
from kinematics.timing.curve_speed import CurveGrid
from kinematics.timing.timing_kernel import LEAST_KEPT

VELOCITY, ACCELERATION = np.array([1.0, 1.5, 2.0]), np.array([4.0, 6.0, 5.0])


def bounds_along(seed, kind=RoundedPolyline, count=5):
    points = np.random.default_rng(seed).uniform(-1, 1, (count, 3))
    grid = CurveGrid.along(kind(points, np.ones(3), 0.3))
    return grid.bounded(grid.points, VELOCITY, ACCELERATION)


def used(bounds, rates):
    """Share of the acceleration limits that is used at both ends of each interval."""
    pull = (np.diff(rates) / (2.0 * bounds.step))[:, None]
    start = bounds.first * pull + bounds.bend * rates[:-1, None]
    end = bounds.last * pull + bounds.bend * rates[1:, None]
    return np.abs(np.stack([start, end])).max(axis=(0, 2))


def most_by_linear_programs(bounds):
    """Largest squared rates from which the end can be reached at rest, without nearly stopping before."""
    n = len(bounds.step)
    most = np.zeros(n + 1)
    for i in range(n - 1, -1, -1):
        twice, after = 2.0 * bounds.step[i], most[i + 1]
        rows = np.concatenate(
            [
                np.column_stack([bounds.bend[i], bounds.first[i]]),
                np.column_stack([bounds.bend[i], bounds.last[i] + twice * bounds.bend[i]]),
            ]
        )
        # from a rate above the next one a share of that is kept, from one below it a share of this
        for kept, at_most, least, most_b in (
            ([-1.0, -twice], -LEAST_KEPT * after, after, bounds.top[i]),
            ([LEAST_KEPT - 1.0, -twice], 0.0, 0.0, min(after, bounds.top[i])),
        ):
            found = linprog(
                [-1.0, 0.0],
                np.concatenate([rows, -rows, [[1.0, twice], kept]]),
                np.concatenate([np.ones(2 * len(rows)), [after, at_most]]),
                bounds=[(least, max(least, most_b)), (None, None)],
            )
            if found.status == 0 and found.x[0] <= bounds.top[i]:
                most[i] = found.x[0]
                break
    return most


@settings(max_examples=50, deadline=None)
@given(st.integers(0, 10_000), st.sampled_from([RoundedPolyline, BlendedPolyline]), st.integers(2, 12))
@example(1754, RoundedPolyline, 10)  # the greatest rate at one place could only fall to 0 at the next
def test_fastest_rates_keep_every_limit(seed, kind, count):
    bounds = bounds_along(seed, kind, count)

    rates = bounds.rates()

    assert rates[0] == rates[-1] == 0.0
    assert np.all(rates[1:-1] > 0.0)
    assert np.all(rates <= bounds.top * (1 + 1e-9))
    assert used(bounds, rates).max() <= 1.0 + 1e-6


@settings(max_examples=50, deadline=None)
@given(st.integers(0, 10_000))
def test_fastest_rates_use_a_limit_up_everywhere(seed):
    """What is time-optimal rides on a limit at any place."""
    bounds = bounds_along(seed)

    rates = bounds.rates()

    at_top = np.maximum(rates[:-1] / bounds.top[:-1], rates[1:] / bounds.top[1:]) > 1.0 - 1e-6
    idle = ~at_top & (used(bounds, rates) < 0.98)
    # between speeding up and slowing down lies an interval that does some of both
    assert idle.mean() < 0.1


@pytest.mark.parametrize("seed", range(3))
def test_no_linear_program_finds_a_faster_rate(seed):
    bounds = bounds_along(seed)

    rates, most = bounds.rates(), most_by_linear_programs(bounds)

    assert np.all(rates <= most * (1 + 1e-6) + 1e-12)
    # from some place on, the way to the end is slowing down: there they agree
    braking = len(rates) - 1 - np.argmax(np.diff(rates)[::-1] > 0.0)
    assert rates[braking:] == pytest.approx(most[braking:], rel=1e-6, abs=1e-9)
    touching = np.isclose(rates, most, rtol=1e-6)
    assert touching.mean() > 0.3


def test_a_straight_line_is_sped_up_and_slowed_down_as_hard_as_can_be():
    grid = CurveGrid.along(RoundedPolyline(np.array([[0.0], [1.0]]), np.ones(1), 0.1))
    bounds = grid.bounded(grid.points, np.array([10.0]), np.array([4.0]))

    rates = bounds.rates()

    s = np.concatenate([[0.0], np.cumsum(bounds.step)])
    assert rates == pytest.approx(np.minimum(8.0 * s, 8.0 * (1.0 - s)), abs=1e-9)
