"""What nobody checks moves no point of the robot farther than what the checker leaves to spare."""

import numpy as np
import pinocchio as pin
import pytest

from kinematics.checking.settings import DEFAULT_SETTINGS, SPARE_M
from kinematics.checking.start_gap import LEAD_IN_M, start_gap
from kinematics.dynamics.zmp import zmp_margins_m
from kinematics.model.standing_robot import StandingRobot
from kinematics.motion.lead_in import lead_in
from kinematics.motion.sampler import TrajectorySampler
from kinematics.motion.trajectory import Trajectory


def vertices(model, q):
    """Every vertex of the robot's hulls."""
    data, found = model.pin.createData(), []
    pin.forwardKinematics(model.pin, data, q)
    for item in model.geometry().geometryObjects:
        if hasattr(item.geometry, "points"):
            place = data.oMi[item.parentJoint] * item.placement
            found.append(np.array(item.geometry.points()) @ place.rotation.T + place.translation)
    return np.concatenate(found)


def beside(model, rng, scale):
    """A posture beside home: base and every joint."""
    step = rng.normal(size=model.nv) * scale
    step[:6] *= rng.random()
    return pin.integrate(model.pin, model.q_home, step)


def standing(model, stance, q):
    rest = np.zeros((2, model.nv))
    return Trajectory(model.joints, stance, np.array([0.0, 1.0]), np.stack([q, q]), rest)


@pytest.mark.parametrize("scale", [1e-7, 1e-5, 1e-3])
def test_no_point_moves_farther_than_is_told_anywhere_on_a_lead_in(talos, stance, scale):
    rng, gap = np.random.default_rng(5), start_gap(talos)
    for _ in range(5):
        away = beside(talos, rng, scale)
        sampler = TrajectorySampler(lead_in(standing(talos, stance, talos.q_home), away, talos.acceleration))
        at_goal = vertices(talos, talos.q_home)
        told_m = gap.moves_m(away, talos.q_home)
        for t_s in np.linspace(0.0, sampler.duration_s - 1.0, 6):
            moved = np.linalg.norm(vertices(talos, sampler.at(t_s).q) - at_goal, axis=1).max()
            assert moved <= told_m + 1e-12
        assert told_m < 8.0 * np.linalg.norm(vertices(talos, away) - at_goal, axis=1).max()


def test_the_same_posture_is_no_gap_however_its_turn_is_written(talos):
    other = talos.q_home.copy()
    other[3:7] *= -1.0

    assert start_gap(talos).moves_m(talos.q_home, other) < 1e-15


def test_what_the_checker_tolerates_contains_a_lead_in():
    assert DEFAULT_SETTINGS.spare_m == SPARE_M == 2.0 * LEAD_IN_M
    assert DEFAULT_SETTINGS.com_tolerance_m >= 10.0 * LEAD_IN_M
    assert DEFAULT_SETTINGS.stance_m >= 100.0 * LEAD_IN_M


def test_a_lead_in_keeps_the_zmp_within_what_the_com_margin_leaves(talos, stance):
    rng, gap = np.random.default_rng(6), start_gap(talos)
    still = standing(talos, stance, talos.q_home)
    (at_rest_m,) = zmp_margins_m(StandingRobot(talos, stance), TrajectorySampler(still).many(np.zeros(1)))
    for _ in range(5):
        away = beside(talos, rng, 1e-6)
        away = pin.integrate(
            talos.pin,
            talos.q_home,
            pin.difference(talos.pin, talos.q_home, away) * LEAD_IN_M / gap.moves_m(away, talos.q_home),
        )
        sampler = TrajectorySampler(lead_in(still, away, talos.acceleration))
        rows = sampler.many(np.linspace(0.0, sampler.duration_s - 1.0, 50))
        lost_m = at_rest_m - zmp_margins_m(StandingRobot(talos, stance), rows).min()
        assert lost_m < 0.5 * talos.description.com_margin_m
