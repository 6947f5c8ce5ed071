import numpy as np
import pinocchio as pin
import pytest

from kinematics.ik import reach_balance
from kinematics.ik.reach_problem import scratch
from kinematics.model.standing_robot import StandingRobot
from kinematics.model.tree import tree_of
from kinematics.standing.model_coordinates import standing_coordinates


def uncompiled(function):
    return function.py_func


def test_the_legs_follow_the_base_as_differences_say(talos, stance, space, monkeypatch):
    # as plain Python: to compile it alone takes longer than all of the test
    for name in ("turning_axis", "_eliminate"):
        monkeypatch.setattr(reach_balance, name, uncompiled(getattr(reach_balance, name)))
    rng = np.random.default_rng(4)
    tree, coordinates = tree_of(talos.pin), standing_coordinates(StandingRobot(talos, stance))
    data = talos.pin.createData()
    memory = scratch(tree, talos.nq, space.size, coordinates.leg_bodies, 1)
    columns = tree.column[coordinates.leg_bodies]
    for _ in range(5):
        x = space.home.copy()
        x[:6] += rng.uniform([-0.05, -0.05, -0.2, -0.2, -0.2, -0.2], [0.05, 0.05, -0.05, 0.2, 0.2, 0.2])
        q = space.to_q(x[None])[0][0]
        pin.forwardKinematics(talos.pin, data, q)
        for body, pose in enumerate(data.oMi):
            memory.R[body], memory.p[body] = pose.rotation, pose.translation

        uncompiled(reach_balance._leg_rates)(tree, coordinates, x, memory)

        for c in range(6):
            step = np.zeros(space.size)
            step[c] = 1e-6
            ahead, behind = space.to_q(np.stack([x + step, x - step]))[0][:, columns]
            assert memory.leg_rates[:, :, c] == pytest.approx((ahead - behind) / 2e-6, abs=1e-6)
