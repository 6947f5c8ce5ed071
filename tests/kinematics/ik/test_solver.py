import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.ik.placo_ik import PlacoIk
from kinematics.ik.reach_ik import ReachIk
from kinematics.ik.result import IkTolerance
from kinematics.model.standing_robot import StandingRobot
from kinematics.model.support_polygon import SupportPolygon


@pytest.mark.parametrize("solver", [PlacoIk, ReachIk])
@pytest.mark.parametrize("hand", ["left", "right"])
def test_residuals_of_reachable_poses_are_what_they_claim(talos, stance, hand, solver):
    rng = np.random.default_rng(3)
    ik = solver(StandingRobot(talos, stance), hand)
    frame = talos.description.grippers[hand].tcp_frame
    side = 1.0 if hand == "left" else -1.0
    polygon = SupportPolygon(stance, talos.description.soles)
    for _ in range(10):
        place = rng.uniform([0.4, 0.1, 0.9], [0.55, 0.35, 1.1]) * (1.0, side, 1.0)
        target = poses.transform(poses.rotation_z(side * rng.uniform(-0.4, 0.1)), place)

        result = ik.solve(target, talos.q_home)

        assert result.within(IkTolerance()), place
        reached = talos.frame_pose(result.q, frame)
        assert np.linalg.norm(reached[:3, 3] - place) <= 5e-4
        assert poses.angle_between(reached[:3, :3], target[:3, :3]) <= 3e-3
        for sole, world_T_sole in stance.soles:
            assert talos.frame_pose(result.q, sole) == pytest.approx(world_T_sole, abs=1e-9)
        margin = polygon.com_margin_m(talos.com(result.q))
        assert result.com_margin_m == pytest.approx(margin)
        assert margin >= talos.description.com_margin_m


@pytest.mark.parametrize("solver", [PlacoIk, ReachIk])
def test_an_unreachable_pose_is_admitted(talos, stance, solver):
    ik = solver(StandingRobot(talos, stance), "right")

    result = ik.solve(poses.translation(1.6, -0.3, 1.0), talos.q_home)

    assert not result.within(IkTolerance())
    assert result.position_error_m > 0.1


@pytest.mark.parametrize("solver", [PlacoIk, ReachIk])
def test_the_same_question_has_the_same_answer(talos, stance, solver):
    target = poses.translation(0.5, -0.25, 1.0)

    first = solver(StandingRobot(talos, stance), "right").solve(target, talos.q_home).q
    second = solver(StandingRobot(talos, stance), "right").solve(target, talos.q_home).q

    assert np.array_equal(first, second)


@pytest.mark.parametrize("hand", ["left", "right"])
def test_following_many_poses_is_solving_one_after_another(talos, stance, hand):
    side = 1.0 if hand == "left" else -1.0
    turn = poses.rotation_z(-0.3 * side)
    targets = [poses.transform(turn, (0.45 + 0.03 * k, 0.25 * side, 1.0 - 0.08 * k)) for k in range(4)]
    ik = ReachIk(StandingRobot(talos, stance), hand)
    q = ik.solve(targets[0], talos.q_home).q
    one_by_one = []
    for target in targets[1:]:
        one_by_one.append(ik.solve(target, one_by_one[-1] if one_by_one else q, q_preferred=q).q)
        q = one_by_one[-1]

    followed = ik.follow(targets[1:], ik.solve(targets[0], talos.q_home).q)

    assert len(followed) == 3
    for answer, alone in zip(followed, one_by_one, strict=True):
        assert answer.within(IkTolerance())
        assert answer.q == pytest.approx(alone, abs=1e-6)


def test_following_ends_before_the_first_pose_that_is_out_of_reach(talos, stance):
    ik = ReachIk(StandingRobot(talos, stance), "right")
    near, far = poses.translation(0.5, -0.25, 1.0), poses.translation(1.6, -0.3, 1.0)

    followed = ik.follow([near, far, near], ik.solve(near, talos.q_home).q)

    assert len(followed) == 1


def test_a_low_pose_that_upright_knees_do_not_reach_is_reached_by_bending_them(talos, stance):
    ik, low = ReachIk(StandingRobot(talos, stance), "right"), poses.translation(0.5, -0.25, 0.3)

    assert not ik.solve(low, talos.q_home, upright=True).within(IkTolerance())
    assert ik.solve(low, talos.q_home).within(IkTolerance())
