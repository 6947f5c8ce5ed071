from dataclasses import replace

import pytest

from kinematics.geometry import poses
from kinematics.geometry.shapes import Box, Cylinder
from robots.perception.object_estimate import ObjectEstimate
from robots.perception.position_error import alike_in_all_directions
from robots.perception.standing import seen_to_float, standing_on_tops


def top(height_m=0.9):
    place = poses.translation(0.6, 0.0, height_m - 0.02)
    return ObjectEstimate("furniture", "table", None, place, Box((0.6, 1.2, 0.04)), 0.9, 8, 0.003)


def cup(foot_m, x=0.5, tilt_rad=0.0):
    place = poses.transform(poses.rotation_x(tilt_rad), (x, 0.1, foot_m + 0.05))
    return ObjectEstimate("object", "cup", "red", place, Cylinder(0.03, 0.1), 0.9, 8, 0.003)


def foot(item):
    return item.odom_T_object[2, 3] - 0.05


def test_a_top_and_what_stands_on_it_agree_on_the_mean_height():
    table, low, high = standing_on_tops([top(0.900), cup(0.894), cup(0.909, x=0.7)])

    assert table.odom_T_object[2, 3] + 0.02 == pytest.approx(0.901)
    assert foot(low) == pytest.approx(0.901)
    assert foot(high) == pytest.approx(0.901)


@pytest.mark.parametrize(
    "other",
    [cup(1.0), cup(0.89, x=2.0), cup(0.89, tilt_rad=1.5)],
    ids=["in the air", "beside the table", "lying"],
)
def test_what_does_not_stand_on_the_top_is_left_alone(other):
    table, same = standing_on_tops([top(), other])

    assert same.odom_T_object[2, 3] == other.odom_T_object[2, 3]
    assert table.odom_T_object[2, 3] == pytest.approx(0.88)


@pytest.mark.parametrize("foot_m", [0.895, 0.885])
@pytest.mark.parametrize("board_first", [True, False])
def test_what_stands_on_a_board_is_not_drawn_down_to_the_cupboard_under_it(foot_m, board_first):
    board, under = top(0.905), replace(top(), odom_T_object=poses.translation(0.6, 0.0, 0.44))
    cupboard = replace(under, shape=Box((0.6, 1.2, 0.86)))  # its top is at 0.87

    seen = standing_on_tops([board, cupboard, cup(foot_m)] if board_first else [cupboard, board, cup(foot_m)])

    assert foot(seen[2]) == pytest.approx(0.5 * (0.905 + foot_m))
    assert seen[1 if board_first else 0].odom_T_object[2, 3] == pytest.approx(0.44)


def told(*items, bias_m=0.002):
    """Estimates whose detector declares its error."""
    return [replace(item, error=alike_in_all_directions(bias_m, 0.0005, 0.01)) for item in items]


@pytest.mark.requirement("P3")
@pytest.mark.parametrize("off_m", [0.014, -0.014])
def test_a_top_that_is_seen_too_low_or_high_for_what_stands_on_it_is_noticed(off_m):
    ((index, innovation),) = seen_to_float(told(top(), cup(0.9 + off_m)))

    assert index == 0
    assert innovation.difference[0] == pytest.approx(off_m)
    assert innovation.disagrees


@pytest.mark.requirement("P3")
def test_heights_that_differ_by_no_more_than_is_declared_fit():
    ((_, innovation),) = seen_to_float(told(top(), cup(0.914), bias_m=0.005))

    assert not innovation.disagrees


def test_many_feet_tell_a_tops_height_better_than_one():
    ((_, one),) = seen_to_float(told(top(), cup(0.91)))
    ((_, many),) = seen_to_float(told(top(), *(cup(0.91, x=0.4 + 0.1 * k) for k in range(5))))

    assert many.distance > one.distance


def test_what_declares_no_error_is_not_compared():
    assert seen_to_float([top(), cup(0.914)]) == []
