import numpy as np
import pytest

from kinematics.dynamics.held_load import loaded
from kinematics.dynamics.standing_dynamics import StandingDynamics
from kinematics.estimation.held_mass import HeldMass
from kinematics.model.standing_robot import StandingRobot
from kinematics.motion.trajectory import HeldLoad

POINT_M = (0.02, 0.0, -0.05)


@pytest.fixture
def weighed(talos, stance):
    """What is felt of a mass in the right hand, with and without noise of the efforts."""

    def weigh(mass_kg, noise_nm=0.0, readings=1):
        model = loaded(talos, [HeldLoad("tcp_right", mass_kg, POINT_M)])
        q = talos.q_home
        effort = StandingDynamics(StandingRobot(model, stance)).holding_efforts(q)
        rng, scales = np.random.default_rng(1), HeldMass(talos, "right")
        for _ in range(readings):
            felt = effort + rng.normal(0.0, noise_nm, len(effort)) if noise_nm else effort
            scales.add(q, np.zeros(len(effort)), felt, np.array(POINT_M))
        return scales.mass_kg

    return weigh


@pytest.mark.parametrize("mass_kg", [0.1, 0.5, 1.5])
def test_efforts_at_rest_tell_the_mass(weighed, mass_kg):
    assert weighed(mass_kg) == pytest.approx(mass_kg, rel=1e-6)


def test_noise_averages_out_over_a_second_of_readings(weighed):
    assert weighed(0.1, noise_nm=0.5, readings=500) == pytest.approx(0.1, rel=0.15)


def test_nothing_is_taken_for_heavier_than_the_payload(weighed, talos):
    assert weighed(20.0) == talos.description.grippers["right"].payload_kg


def test_before_any_reading_nothing_is_held(talos):
    assert HeldMass(talos, "left").mass_kg == 0.0


def test_what_pulls_upwards_is_no_mass(weighed):
    assert weighed(-0.5) == 0.0
