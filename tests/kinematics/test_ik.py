import numpy as np
import pytest

from kinematics import poses
from kinematics.ik import IkTolerance, WholeBodyIk
from kinematics.stance import SupportPolygon


@pytest.mark.parametrize("hand", ["left", "right"])
def test_residuals_of_reachable_poses_are_what_they_claim(talos, stance, hand):
    rng = np.random.default_rng(3)
    ik = WholeBodyIk(talos, stance, hand)
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


def test_an_unreachable_pose_is_admitted(talos, stance):
    ik = WholeBodyIk(talos, stance, "right")

    result = ik.solve(poses.translation(1.6, -0.3, 1.0), talos.q_home)

    assert not result.within(IkTolerance())
    assert result.position_error_m > 0.1


def test_the_same_question_has_the_same_answer(talos, stance):
    target = poses.translation(0.5, -0.25, 1.0)

    first = WholeBodyIk(talos, stance, "right").solve(target, talos.q_home).q
    second = WholeBodyIk(talos, stance, "right").solve(target, talos.q_home).q

    assert np.array_equal(first, second)
