"""The reachability map: sampled again, and held against what the stored one says."""

import pytest

from kinematics.model.reachability import GridAxis, ReachabilityMap
from kinematics.model.robot_model import RobotModel
from robots.models.description import load_description
from tools.pictures.draw_reachability import picture
from tools.robot_data.reachability_map import HandSampler, reachability_of


@pytest.fixture(scope="module")
def talos():
    return RobotModel(load_description("talos"))


def test_what_is_sampled_anew_is_what_is_stored(talos):
    stored = talos.description.reachability
    anew = reachability_of(talos, GridAxis(0.4, 0.4, 2), GridAxis(-0.4, 0.4, 3), GridAxis(0.5, 0.6, 2))

    for hand, layers in anew.shares.items():
        for z_m, layer in zip(anew.height.values_m(), layers, strict=True):
            for x_m, row in zip(anew.ahead.values_m(), layer, strict=True):
                for y_m, share in zip(anew.aside.values_m(), row, strict=True):
                    assert stored.share(hand, x_m, y_m, z_m) == pytest.approx(share, abs=0.06)


@pytest.mark.parametrize(("hand", "own_side"), [("left", 1.0), ("right", -1.0)])
def test_a_hand_gets_farther_on_its_own_side(talos, hand, own_side):
    sampler = HandSampler(talos, hand)

    assert sampler.share(0.7, own_side * 0.3, 0.8) > sampler.share(0.7, -own_side * 0.6, 0.8) + 0.2


def test_what_is_far_away_or_inside_the_trunk_is_not_reached(talos):
    sampler = HandSampler(talos, "left")

    assert sampler.share(1.6, 0.0, 0.8) == 0.0
    assert sampler.share(0.0, 0.0, 0.9) == 0.0


def test_the_drawing_has_a_square_for_each_place_dark_where_every_direction_is_reached():
    layer = ((0.0, 1.0), (0.5, 0.0))
    found = ReachabilityMap(
        GridAxis(0.2, 0.1, 2), GridAxis(0.0, 0.1, 2), GridAxis(0.5, 0.1, 2), {"left": (layer, layer)}
    )

    drawn = picture(found, heights_m=(0.5,))

    assert drawn.count("<path") == 4
    assert drawn.count("#ffffff") == 2
    assert drawn.count("#0b4f6c") == 1
