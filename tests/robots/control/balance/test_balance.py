import numpy as np
import pytest

from kinematics.dynamics.held_load import loaded
from kinematics.dynamics.standing_dynamics import StandingDynamics
from kinematics.model.stance import stance_at
from kinematics.model.standing_robot import StandingRobot
from kinematics.motion.sampler import MotionSample
from kinematics.motion.trajectory import HeldLoad
from robots.control.balance.balance import Balance

BOTTLE = (HeldLoad("tcp_left", 1.0, (0.0, 0.0, 0.0)),)


@pytest.fixture
def at_rest(talos):
    return MotionSample(talos.q_home, np.zeros(talos.nv), np.zeros(talos.nv))


@pytest.fixture
def balance(talos):
    return Balance(StandingRobot(talos, stance_at(talos, talos.q_home)))


def test_what_a_hand_carries_is_borne_by_the_feed_forward(talos, balance, at_rest):
    balance.carry(BOTTLE)
    for _ in range(200):
        efforts = balance.efforts(at_rest)

    wanted = StandingDynamics(
        StandingRobot(loaded(talos, BOTTLE), stance_at(talos, talos.q_home))
    ).holding_efforts(at_rest.q)
    np.testing.assert_allclose(efforts, wanted, atol=1e-9)


def test_a_load_is_taken_over_without_a_step(balance, at_rest):
    before = balance.efforts(at_rest).copy()
    balance.carry(BOTTLE)

    assert np.abs(balance.efforts(at_rest) - before).max() < 0.1


def test_a_load_that_changes_halfway_makes_no_step_either(balance, at_rest):
    balance.carry(BOTTLE)
    for _ in range(50):
        before = balance.efforts(at_rest).copy()
    balance.carry(())

    assert np.abs(balance.efforts(at_rest) - before).max() < 0.1


def test_the_first_efforts_after_a_walk_bear_the_load_at_once(talos, balance, at_rest):
    balance.carry(BOTTLE)

    wanted = StandingDynamics(
        StandingRobot(loaded(talos, BOTTLE), stance_at(talos, talos.q_home))
    ).holding_efforts(at_rest.q)
    np.testing.assert_allclose(balance.efforts(at_rest), wanted, atol=1e-9)
