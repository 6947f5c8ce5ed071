"""Where a landing has to be when the sole that stands cannot hold the DCM."""

import math

import numpy as np
import pytest

from kinematics.geometry.planar import PlanarPose
from kinematics.model.robot_model import RobotModel
from kinematics.walking.body.whole_body import WholeBody
from kinematics.walking.pattern.dcm import ZmpStretch
from kinematics.walking.pattern.pattern import WalkingPattern
from kinematics.walking.pattern.pattern_sample import Phase
from kinematics.walking.pattern.steering import VelocitySteering, quickened
from kinematics.walking.pattern.step_adjustment import farthest_m, legs_reach, missed_by
from robots.models.description import load_description

OMEGA = 3.26
PERIOD_S = 0.002
SOLE_M = 0.09


def through(zmp):
    return [ZmpStretch(0.3, zmp, zmp)]


def on_sole(zmp):
    return min(max(zmp[0], -SOLE_M), SOLE_M), min(max(zmp[1], -0.05), 0.05)


@pytest.fixture(scope="module")
def model():
    return RobotModel(load_description("talos"))


def walk_of(model, quick=False):
    """A walk at rest, with its whole body."""
    settings = model.description.walking
    settings = quickened(settings) if quick else settings
    soles = {sole.side: sole for sole in model.description.soles}
    feet = {side: PlanarPose.of(model.frame_pose(model.q_home, sole.frame)) for side, sole in soles.items()}
    body = WholeBody(model, model.q_home, feet, PERIOD_S, settings.first_shift_s)
    x, y, _ = model.com(model.q_home).tolist()
    apart_m = feet["left"].distance_m(feet["right"])
    return WalkingPattern(settings, soles, feet, (x, y), body.rest_m, apart_m, body.omega, body.sway_s2), body


@pytest.fixture
def swing(model):
    """A walk of 0.3 m/s early in its fourth swing, with its whole body."""
    pattern, body = walk_of(model)
    pattern.steer(VelocitySteering(model.description.walking, 0.3, 0.0))
    while pattern.steps < 3 or pattern.phase is not Phase.SWING:
        body.follow(pattern.advance(PERIOD_S))
    for _ in range(20):
        body.follow(pattern.advance(PERIOD_S))
    return pattern, body


def test_a_dcm_that_the_sole_can_hold_misses_nothing():
    assert missed_by(through, on_sole, (0.05, 0.0), (0.06, 0.0), OMEGA) == pytest.approx((0.0, 0.0))


def test_what_the_sole_cannot_hold_grows_until_the_landing():
    x, y = missed_by(through, on_sole, (0.19, 0.0), (0.10, 0.0), OMEGA)

    assert x == pytest.approx(SOLE_M + 0.10 * math.exp(0.3 * OMEGA) - 0.10)
    assert y == pytest.approx(0.0)


def test_the_longer_a_foot_is_in_the_air_the_farther_its_landing_may_move():
    assert farthest_m(0.4, 10.0) == pytest.approx(4.0 * farthest_m(0.2, 10.0))
    s = np.linspace(0.0, 1.0, 1001)  # the way from rest to rest that has this peak
    way = farthest_m(0.4, 10.0) * (10.0 * s**3 - 15.0 * s**4 + 6.0 * s**5)
    assert np.gradient(np.gradient(way, 0.4e-3), 0.4e-3).max() == pytest.approx(10.0, rel=0.01)


def test_a_landing_that_the_com_does_not_come_near_is_out_of_reach():
    stretches, standing = through((0.0, 0.0)), PlanarPose()

    def reached(landing_m):
        landing = PlanarPose(landing_m)
        return legs_reach(stretches, (0.0, 0.0), (0.02, 0.0), OMEGA, standing, lambda _: landing, 0.25)

    assert reached(0.2)
    assert not reached(0.4)


def test_a_foot_in_the_air_lands_where_a_push_takes_the_body(swing):
    pattern, body = swing
    before = pattern.goal

    moved = pattern.catch((0.12, 0.0))

    assert moved
    assert pattern.goal.x_m > before.x_m + 0.05
    while pattern.phase is not Phase.REST:  # the plan goes on from there, within the legs' reach
        sample = pattern.advance(PERIOD_S)
        body.follow(sample)
        if pattern.phase is Phase.LAND:
            pattern.finish()
    left, right = pattern.feet["left"], pattern.feet["right"]
    assert right.to(left).y_m == pytest.approx(0.17, abs=1e-9)
    assert right.to(left).x_m == pytest.approx(0.0, abs=1e-9)


def test_the_plan_never_jumps_when_a_landing_moves(swing):
    pattern, _ = swing
    samples = [pattern.advance(PERIOD_S)]

    pattern.catch((0.12, 0.03))
    samples += [pattern.advance(PERIOD_S) for _ in range(400)]

    for points in ([sample.com.com for sample in samples], [sample.com.dcm for sample in samples]):
        assert np.abs(np.diff(points, axis=0)).max() < 1.5 * PERIOD_S
    for side in ("left", "right"):
        places = [(sample.feet[side].x_m, sample.feet[side].y_m) for sample in samples]
        assert np.abs(np.diff(places, n=2, axis=0)).max() < 30.0 * PERIOD_S**2


@pytest.mark.parametrize(("robot", "moves"), [("talos", False), ("g1", True)])
def test_what_two_wide_soles_bring_back_narrow_ones_step_after(robot, moves):
    model = RobotModel(load_description(robot))
    pattern, _ = walk_of(model)
    pattern.steer(VelocitySteering(model.description.walking, 0.0, 0.3))
    while pattern.steps < 3 or pattern.phase is not Phase.SWING:
        sample = pattern.advance(PERIOD_S)

    outwards = 1.0 if sample.carrying == ("right",) else -1.0
    assert pattern.catch((0.0, 0.04 * outwards)) is moves


@pytest.mark.parametrize("error", [(0.02, 0.0), (-0.02, 0.01), (0.0, -0.02)])
def test_what_the_sole_corrects_moves_no_landing(swing, error):
    pattern, _ = swing
    before = pattern.goal

    assert not pattern.catch(error)
    assert pattern.goal == before


@pytest.mark.parametrize("error", [(0.3, 0.0), (-0.3, 0.0), (0.0, 0.3), (0.0, -0.3), (0.25, -0.25)])
def test_however_hard_the_push_the_feet_keep_their_distance_and_the_legs_their_reach(model, swing, error):
    pattern, body = swing
    s = model.description.walking

    pattern.catch(error)

    for _ in range(800):
        body.follow(pattern.advance(PERIOD_S))  # raises where a leg is too short
        if pattern.phase is Phase.LAND:
            apart = pattern.feet["right"].to(pattern.feet["left"])
            assert s.narrowest_m - 1e-9 <= apart.y_m <= s.stride_widest_m + 1e-9
            assert abs(apart.x_m) <= max(s.stride_forward_m, s.stride_backward_m) + 1e-9


def test_a_foot_in_the_air_hurries_no_farther_ahead_than_its_leg_reaches():
    stretches, standing = through((0.0, 0.0)), PlanarPose()

    def reached(early_s):
        def flying(t_s):
            return PlanarPose(0.3) if early_s < t_s < 0.25 else PlanarPose(0.2)

        return legs_reach(stretches, (0.0, 0.0), (0.02, 0.0), OMEGA, standing, flying, 0.25)

    assert reached(0.25)
    assert not reached(0.1)


@pytest.mark.parametrize(("velocity_m_s", "pushed_m"), [(-0.5, -0.12), (0.3, 0.2), (0.5, 0.3)])
@pytest.mark.parametrize("quick", [True, False])
def test_a_landing_that_moves_asks_no_leg_for_more_than_its_reach_on_the_way(
    model, quick, velocity_m_s, pushed_m
):
    pattern, body = walk_of(model, quick)
    settings = model.description.walking
    pattern.steer(VelocitySteering(settings, velocity_m_s, 0.0, quick=quick))
    while pattern.steps < 4 or pattern.phase is not Phase.SWING:
        body.follow(pattern.advance(PERIOD_S))
    for _ in range(40):
        body.follow(pattern.advance(PERIOD_S))

    pattern.catch((pushed_m, 0.0))

    while pattern.phase is Phase.SWING:
        sample = pattern.advance(PERIOD_S)
        body.follow(sample)
        for foot in sample.feet.values():
            assert foot.distance_m(PlanarPose(*sample.com.com)) < settings.stride_reach_m + 0.01


def test_a_foot_that_is_about_to_land_goes_where_it_was_going(swing):
    pattern, _ = swing
    for _ in range(200):
        pattern.advance(PERIOD_S)

    assert pattern.phase is Phase.SWING
    assert not pattern.catch((0.2, 0.0))
