"""A reachability map gives what was sampled, linear in between, and nothing outside."""

import math

import pytest

from kinematics.geometry.planar import PlanarPose
from kinematics.model.reachability import GridAxis, ReachabilityMap


@pytest.fixture
def ramp():
    """The left hand's share is what is ahead, the right hand's nothing but at one place."""
    ahead, aside, height = GridAxis(0.2, 0.2, 4), GridAxis(-0.4, 0.2, 5), GridAxis(0.5, 0.25, 3)
    left = tuple(tuple((x,) * 5 for x in ahead.values_m()) for _ in range(3))
    right = tuple(
        tuple(tuple(1.0 if (k, i, j) == (1, 2, 0) else 0.0 for j in range(5)) for i in range(4))
        for k in range(3)
    )
    return ReachabilityMap(ahead, aside, height, {"left": left, "right": right})


@pytest.mark.parametrize("x_m", [0.2, 0.37, 0.8])
def test_between_sampled_places_a_share_is_linear(ramp, x_m):
    assert ramp.share("left", x_m, 0.13, 0.61) == pytest.approx(x_m)


@pytest.mark.parametrize("place_m", [(0.19, 0.0, 0.6), (0.81, 0.0, 0.6), (0.5, 0.41, 0.6), (0.5, -0.41, 0.6)])
def test_beside_the_grid_nothing_is_reached(ramp, place_m):
    assert ramp.share("left", *place_m) == 0.0


def test_below_and_above_the_grid_it_is_as_at_its_end(ramp):
    assert ramp.share("left", 0.5, 0.0, 0.1) == pytest.approx(0.5)
    assert ramp.share("left", 0.5, 0.0, 1.4) == pytest.approx(0.5)


def test_a_hand_that_is_not_on_the_map_reaches_nothing(ramp):
    assert ramp.share("third", 0.5, 0.0, 0.6) == 0.0


def test_a_place_in_the_world_is_seen_from_the_body(ramp):
    body = PlanarPose(2.0, 1.0, 0.5 * math.pi)  # ahead is the world's y, its right the world's x

    assert ramp.share_from(body, "right", (2.4, 1.6, 0.75)) == pytest.approx(1.0)
    assert ramp.share_from(body, "right", (1.6, 1.6, 0.75)) == 0.0


def test_of_several_hands_the_better_one_counts(ramp):
    body = PlanarPose()

    assert ramp.best_from(body, ("left", "right"), (0.6, -0.4, 0.75)) == pytest.approx(1.0)
    assert ramp.best_from(body, ("left",), (0.6, -0.4, 0.75)) == pytest.approx(0.6)
    assert ramp.best_from(body, (), (0.6, -0.4, 0.75)) == 0.0
