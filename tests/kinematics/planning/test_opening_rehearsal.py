"""What a rehearsal tells is what the judge found, and it judges what the online checker will."""

import numpy as np
import pytest

from kinematics.collision.standing_judge import StandingJudge
from kinematics.following.opening_motion import com_shift_m
from kinematics.geometry import poses
from kinematics.geometry.shapes import Box
from kinematics.kernel.refusal import NotFree
from kinematics.model.stance import Stance
from kinematics.model.standing_robot import StandingRobot
from kinematics.planning.opening_rehearsal import rehearse
from kinematics.scene.opening_path import DrawerLine
from kinematics.scene.planning_scene import PlanningScene, SceneObject


def led_forwards(model, stance, scene=None, far_m=0.05):
    tcp_m = model.frame_pose(model.q_home, "tcp_left")[:3, 3]
    line = DrawerLine(tcp_m, np.pi)
    return rehearse(
        StandingRobot(model, stance), "left", model.q_home, scene or PlanningScene(), (), line, 0.0, far_m
    )  # fmt: skip


def test_a_free_way_is_gone_to_its_end(talos, stance):
    assert led_forwards(talos, stance).reason == ""


@pytest.mark.parametrize(
    ("found", "told"),
    [
        (NotFree("balance"), "the robot would lean too far over its feet"),
        (NotFree("reach"), "the feet could not stay where they are"),
        (NotFree("contact", ("arm_left_5_link", "door")), "something is in the way of the arm"),
    ],
)
def test_a_rehearsal_ends_for_the_reason_that_was_found(talos, stance, monkeypatch, found, told):
    monkeypatch.setattr(StandingJudge, "not_free", lambda _self, _x, _q: found)

    assert led_forwards(talos, stance).reason == told


@pytest.mark.requirement("S6")
def test_a_way_on_which_something_held_meets_the_ground_is_not_gone(talos, stance):
    frame = talos.description.tcp_frames["left"]
    tcp = talos.frame_pose(talos.q_home, frame)
    rod_at = poses.translation(tcp[0, 3], tcp[1, 3], 0.25 + 0.002)
    links = [talos.link_of(item) for item in talos.geometry().geometryObjects]
    step = SceneObject("floor", Box((2.0, 2.0, 2.0)), poses.translation(0.0, 0.0, -1.0))
    rod = SceneObject("rod", Box((0.02, 0.02, 0.5)), rod_at)
    scene = PlanningScene().with_objects([step, rod])
    low = scene.with_attached(
        "rod", frame, poses.inverse(tcp) @ poses.translation(0, 0, -0.01) @ rod_at, links
    )

    assert led_forwards(talos, stance, low).reason == "something is in the way of the arm"


def test_a_pull_tips_a_robot_on_a_platform_as_it_does_on_the_floor(talos, stance):
    raised = Stance(tuple((frame, poses.translation(0.0, 0.0, 0.1) @ pose) for frame, pose in stance.soles))
    outward = np.array([-1.0, 0.0, 0.0])

    on_floor = com_shift_m(StandingRobot(talos, stance), outward, 1.0, 40.0)

    np.testing.assert_allclose(
        com_shift_m(StandingRobot(talos, raised), outward, 1.1, 40.0), on_floor, atol=1e-12
    )
