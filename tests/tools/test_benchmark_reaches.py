"""Reaches and picks for a standing robot: the same for the same seed, and valid as they claim."""

import numpy as np
import pytest

from kinematics.ik.result import IkTolerance
from kinematics.model.robot_model import RobotModel
from robots.models.description import load_description
from tools.benchmark.problems.picks import APART_M, TARGET, picks
from tools.benchmark.reaches import ReachingBody


@pytest.fixture(scope="module")
def body():
    return ReachingBody()


def test_reaches_are_the_same_for_the_same_seed(body):
    first, again = (next(body.reaches(1, seed=4)) for _ in range(2))

    assert np.array_equal(first.world_T_tcp, again.world_T_tcp)
    assert np.array_equal(first.starts, again.starts)


def test_every_start_stands_with_its_feet_at_the_stance(body):
    (reach,) = body.reaches(1, seed=6)

    for q in reach.starts:
        for frame, pose in body.stance.soles:
            assert np.allclose(body.model.frame_pose(q, frame), pose, atol=1e-9)


def test_the_judge_accepts_what_reaches_and_refuses_what_is_a_millimetre_off(body):
    (reach,) = body.reaches(1, seed=8)
    q = reach.starts[0]
    there = type(reach)(body.model.frame_pose(q, body.tcp), reach.starts)
    shifted = there.world_T_tcp.copy()
    shifted[0, 3] += 0.001

    assert body.judge(there, q, IkTolerance())
    assert not body.judge(type(reach)(shifted, reach.starts), q, IkTolerance())


def test_the_judge_refuses_a_foot_that_moved(body):
    (reach,) = body.reaches(1, seed=8)
    q = reach.starts[0].copy()
    q[7 + body.model.joint_index("leg_left_6_joint")] += 0.01
    there = type(reach)(body.model.frame_pose(q, body.tcp), reach.starts)

    assert not body.judge(there, q, IkTolerance())


def test_picks_stand_apart_on_a_table_and_repeat():
    model = RobotModel(load_description("talos"))
    (pick,), (again,) = (list(picks(model, 1, seed=2)) for _ in range(2))
    places = [item.world_T_object[:2, 3] for item in pick.scene.objects.values() if item.movable]

    assert pick.target == TARGET
    assert 4 <= len(places) <= 13
    assert all(np.linalg.norm(a - b) > APART_M for i, a in enumerate(places) for b in places[:i])
    for name, item in pick.scene.objects.items():
        assert np.array_equal(item.world_T_object, again.scene.objects[name].world_T_object)
