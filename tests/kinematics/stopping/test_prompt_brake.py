"""A brake along a path that turns just ahead, where one even slope would take too long."""

import numpy as np
import pytest

from kinematics.model.standing_robot import StandingRobot
from kinematics.motion.sampler import TrajectorySampler
from kinematics.stopping.braking import brake_along
from kinematics.stopping.prompt_brake import brake_promptly
from kinematics.timing.curve_timing import Pace
from tests.kinematics.swings import swing

PERIOD_S = 0.002
LATEST_S = 0.45
BEFORE_A_TURN_S = (0.3, 0.36, 0.94, 1.02)


@pytest.fixture(scope="module")
def sampler(talos, stance):
    return TrajectorySampler(swing(talos, stance))


@pytest.mark.requirement("S4")
@pytest.mark.parametrize("t_s", BEFORE_A_TURN_S)
def test_a_turn_ahead_does_not_make_the_brake_late(talos, stance, sampler, t_s):
    even = brake_along(StandingRobot(talos, stance), sampler, t_s, PERIOD_S)

    rows = brake_promptly(StandingRobot(talos, stance), sampler, t_s, PERIOD_S, LATEST_S)

    assert even is None or len(even.rows.q) * PERIOD_S > LATEST_S
    assert len(rows.q) * PERIOD_S <= LATEST_S
    assert not rows.v[-1].any()


@pytest.mark.requirement("S4")
@pytest.mark.parametrize("t_s", BEFORE_A_TURN_S)
def test_the_setpoints_keep_the_limits_as_accelerations_and_as_differences_show_them(
    talos, stance, sampler, t_s
):
    rows = brake_promptly(StandingRobot(talos, stance), sampler, t_s, PERIOD_S, LATEST_S)

    a = np.vstack([sampler.at(t_s).a, rows.a])[:, 6:]
    told = np.vstack([sampler.at(t_s - PERIOD_S).v, sampler.at(t_s).v, rows.v])[:, 6:]
    assert (np.abs(a) <= talos.acceleration * 1.0001).all()
    assert (np.abs(np.diff(a, axis=0)) <= talos.jerk * PERIOD_S * 1.0001).all()
    assert (np.abs(np.diff(told, 2, axis=0)) <= talos.jerk * PERIOD_S**2 * 1.0001).all()


@pytest.mark.parametrize("t_s", BEFORE_A_TURN_S)
def test_the_path_is_not_left_and_its_rates_fit_the_places(talos, stance, sampler, t_s):
    rows = brake_promptly(StandingRobot(talos, stance), sampler, t_s, PERIOD_S, LATEST_S)

    way = sampler.many(np.arange(t_s, t_s + LATEST_S, 1e-4)).q
    assert max(np.abs(way - q).max(axis=1).min() for q in rows.q) < 2e-4
    q = np.vstack([sampler.at(t_s).q, rows.q])[:, 7:]
    v = np.vstack([sampler.at(t_s).v, rows.v])[:, 6:]
    np.testing.assert_allclose(np.diff(q, axis=0), 0.5 * PERIOD_S * (v[1:] + v[:-1]), atol=1e-6)


def test_a_path_that_ends_sooner_than_any_brake_has_none(talos, stance, sampler):
    t_s = sampler.duration_s - 0.01

    assert brake_promptly(StandingRobot(talos, stance), sampler, t_s, PERIOD_S, LATEST_S) is None


def test_a_brake_that_would_be_too_late_is_none(talos, stance, sampler):
    assert brake_promptly(StandingRobot(talos, stance), sampler, BEFORE_A_TURN_S[0], PERIOD_S, 0.2) is None


def test_a_robot_that_a_hard_brake_would_tip_is_braked_more_gently(talos, stance, monkeypatch):
    of = (
        StandingRobot(talos, stance),
        TrajectorySampler(swing(talos, stance, Pace(0.4, 0.5))),
        BEFORE_A_TURN_S[0],
        PERIOD_S,
        LATEST_S,
    )
    hard = brake_promptly(*of)
    upright = iter((False, True))
    monkeypatch.setattr("kinematics.stopping.prompt_brake.stays_upright", lambda *_of: next(upright))

    gentle = brake_promptly(*of)

    assert len(gentle.q) > len(hard.q)
