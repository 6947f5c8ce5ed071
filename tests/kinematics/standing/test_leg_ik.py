import numpy as np
import pytest

from kinematics.model.standing_robot import StandingRobot
from kinematics.standing.leg_ik import LegIk


def shifted_pelvis(talos, rng, count):
    q = np.tile(talos.q_home, (count, 1))
    q[:, :3] += rng.uniform([-0.06, -0.06, -0.15], [0.06, 0.06, 0.01], (count, 3))
    q[:, 3:6] += rng.normal(0.0, 0.05, (count, 3))
    q[:, 3:7] /= np.linalg.norm(q[:, 3:7], axis=1, keepdims=True)
    return q


def test_soles_stay_at_the_stance_to_a_nanometre(talos, stance):
    q = shifted_pelvis(talos, np.random.default_rng(0), 200)

    reached = LegIk(StandingRobot(talos, stance)).fill(q)

    assert reached.all()
    for configuration in q:
        for frame, world_T_sole in stance.soles:
            assert talos.frame_pose(configuration, frame) == pytest.approx(world_T_sole, abs=1e-9)


def test_a_pelvis_that_is_too_high_is_not_reached(talos, stance):
    q = np.array([talos.q_home])
    q[0, 2] += 0.3

    assert not LegIk(StandingRobot(talos, stance)).fill(q)[0]
