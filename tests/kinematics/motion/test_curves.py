import itertools

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from kinematics.motion.curves import BlendedPolyline, PolynomialCurve, RoundedPolyline

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


def corners(seed, count=6):
    return np.random.default_rng(seed).uniform(-1, 1, (count, 3))


def away_from(polyline, points):
    """Largest distance in a coordinate to the nearest point of a polyline, shape (n,), from above."""
    least = np.full(len(points), np.inf)
    for a, b in itertools.pairwise(polyline):
        share = np.clip((points - a) @ (b - a) / ((b - a) @ (b - a)), 0.0, 1.0)
        least = np.minimum(least, np.linalg.norm(points - a - share[:, None] * (b - a), axis=1))
    return least


@given(st.integers(0, 1000), st.sampled_from([0.03, 0.12, 1.0]))
def test_a_rounded_polyline_is_its_polyline_where_it_does_not_bend(seed, spacing):
    points = corners(seed)
    curve = RoundedPolyline(points, ONES, spacing)
    bends = curve.bends()

    dense = curve(np.linspace(0, 1, 2000))
    off = dense[away_from(points, dense) > 1e-9]
    # 0.0197 of the spacing: three lines between two knots at a right angle
    least = np.min([away_from(bend, off) for bend in bends], axis=0)
    assert np.all(least <= 0.0197 * spacing)
    along = np.concatenate(bends)
    assert np.all(away_from(curve(np.linspace(0, 1, 4000)), along) < 1e-4)


def test_a_gentle_bend_needs_fewer_lines_than_a_sharp_one():
    gentle, sharp = (
        RoundedPolyline(np.array([[0.0, 0, 0], [1, 0, 0], [2, rise, 0]]), ONES, 0.1).bends()
        for rise in (0.1, 3.0)
    )

    assert len(gentle) == len(sharp) == 1
    assert len(gentle[0]) < len(sharp[0])


def test_a_straight_polyline_has_no_bends():
    assert RoundedPolyline(np.array([[0.0, 0, 0], [1, 2, 3]]), ONES, 0.1).bends() == []
    assert RoundedPolyline(np.zeros((2, 3)), ONES, 0.1).bends() == []


@given(st.integers(0, 1000), st.sampled_from([0.001, 0.01, 0.1]))
def test_a_blended_corner_is_left_by_no_more_than_the_deviation(seed, deviation):
    points = corners(seed)

    curve = BlendedPolyline(points, ONES, deviation)

    sizes = np.sqrt(3.0)  # a distance is at most this many times its largest coordinate
    assert away_from(points, curve(np.linspace(0, 1, 2000))).max() <= deviation * sizes
    assert curve(np.array([0.0, 1.0])) == pytest.approx(points[[0, -1]], abs=1e-12)


def test_a_right_angle_is_cut_by_exactly_the_deviation():
    curve = BlendedPolyline(np.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 0]]), ONES, 0.01)

    assert curve(np.array([0.5]))[0] == pytest.approx([0.99, 0.01, 0.0])


@given(st.integers(0, 1000))
def test_the_direction_of_a_blended_polyline_does_not_jump(seed):
    curve = BlendedPolyline(corners(seed), ONES, 0.02)

    step = 1e-7
    inner = curve.knots[1:-1]
    before = (curve(inner) - curve(inner - step)) / step
    after = (curve(inner + step) - curve(inner)) / step
    assert after == pytest.approx(before, rel=1e-4, abs=1e-3)


@given(st.integers(0, 1000))
def test_a_curve_is_one_polynomial_between_its_knots(seed):
    points = corners(seed)
    for curve, degree in (
        (PolynomialCurve(points[:5]), 4),
        (BlendedPolyline(points, ONES, 0.02), 2),
        (RoundedPolyline(points, ONES, 0.3), 3),
    ):
        assert curve.knots[0] == 0.0
        assert curve.knots[-1] == 1.0
        for low, high in itertools.pairwise(curve.knots):
            s = np.linspace(low, high, degree + 3)
            s[[0, -1]] += np.array([1e-9, -1e-9]) * (high - low)
            unit = (s - low) / (high - low)
            fitted = np.vander(unit, degree + 1)
            rest = curve(s) - fitted @ np.linalg.lstsq(fitted, curve(s), rcond=None)[0]
            assert np.abs(rest).max() < 1e-7


def test_corners_close_to_each_other_share_the_way_between_them():
    points = np.array([[0.0, 0, 0], [1, 0, 0], [1, 0.001, 0], [2, 0.001, 0]])

    curve = BlendedPolyline(points, ONES, 0.01)

    assert np.all(np.diff(curve.knots) > 0.0)
    assert away_from(points, curve(np.linspace(0, 1, 3000))).max() < 0.001


def test_a_polyline_that_turns_back_ends_its_way_out_within_the_deviation():
    curve = BlendedPolyline(np.array([[0.0], [1.0], [0.0]]), np.ones(1), 0.01)

    assert curve(np.linspace(0, 1, 2001)).max() == pytest.approx(0.99)


def test_weights_count_in_the_deviation():
    points = np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]])

    curve = BlendedPolyline(points, np.array([10.0, 10.0]), 0.01)

    assert np.abs(curve(np.array([0.5]))[0] - [1.0, 0.0]).max() == pytest.approx(0.001)


def test_repeated_corners_and_a_single_place_are_taken():
    repeated = BlendedPolyline(np.array([[0.0], [0.0], [1.0], [1.0]]), np.ones(1), 0.01)
    still = BlendedPolyline(np.array([[0.3], [0.3]]), np.ones(1), 0.01)

    s = np.linspace(0, 1, 11)
    assert repeated(s)[:, 0] == pytest.approx(s)
    assert still(s) == pytest.approx(np.full((11, 1), 0.3))
