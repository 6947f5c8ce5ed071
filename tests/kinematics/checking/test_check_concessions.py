"""What a planner asks to be overlooked is bounded by the checker's own rules."""

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.geometry.shapes import Ball, Box
from kinematics.motion.verdict import CheckedTrajectory, FindingKind, Unsafe
from kinematics.scene.concessions import Concession, ConcessionReason
from kinematics.scene.planning_scene import PlanningScene, SceneObject

FINGER = "gripper_right_fingertip_3_link"
LINKS = ("gripper_right_base_link", FINGER)


def ball(talos, gap_m, movable=True):
    """Ahead of the right hand at home, at about a distance."""
    ahead = poses.translation(0.022 + 0.05 + gap_m, -0.058, 0.0)
    place = talos.frame_pose(talos.q_home, "tcp_right") @ ahead
    return SceneObject("ball", Ball(0.05), place, margin_m=0.03, movable=movable)


def conceded(names, reason, distance_m=None):
    return tuple(Concession(frozenset((name, "ball")), reason, "move", distance_m) for name in names)


def near_links(talos, scene, motion, checker):
    """The links that a motion brings too near to the ball."""
    answer = checker.check(motion, scene)
    assert isinstance(answer, Unsafe)
    return {name for one in answer.findings for name in one.subject} - {"ball"}


def kinds(answer):
    return {one.kind for one in answer.findings} if isinstance(answer, Unsafe) else set()


@pytest.fixture
def start_near(talos, motions, checker):
    scene = PlanningScene().with_object(ball(talos, 0.015))
    motion = motions.still()
    return scene, motion, near_links(talos, scene, motion, checker)


def test_a_start_inside_the_margin_is_conceded_as_much_as_it_needs(checker, start_near):
    scene, motion, links = start_near

    answer = checker.check(motion, scene, conceded(links, ConcessionReason.STARTS_NEAR, 0.008))

    assert isinstance(answer, CheckedTrajectory)


def test_more_than_half_of_the_distance_at_the_start_is_not_given_away(checker, start_near):
    scene, motion, links = start_near

    answer = checker.check(motion, scene, conceded(links, ConcessionReason.STARTS_NEAR, 0.0))

    assert FindingKind.CONCESSION in kinds(answer)


@pytest.mark.parametrize("reason", [ConcessionReason.STARTS_NEAR, ConcessionReason.STARTS_IN_CONTACT])
def test_a_pair_that_starts_apart_is_conceded_nothing_at_the_start(talos, motions, checker, reason):
    scene = PlanningScene().with_object(ball(talos, 0.2))
    distance_m = 0.01 if reason is ConcessionReason.STARTS_NEAR else None

    answer = checker.check(motions.still(), scene, conceded(LINKS, reason, distance_m))

    assert kinds(answer) == {FindingKind.CONCESSION}


def test_a_scene_whose_margins_were_not_kept_is_judged_as_it_is(checker, start_near):
    scene, motion, _ = start_near

    assert FindingKind.SCENE_COLLISION in kinds(checker.check(motion, scene))


def test_contact_at_the_start_with_furniture_is_not_conceded(talos, motions, checker):
    scene = PlanningScene().with_object(ball(talos, -0.01, movable=False))
    motion = motions.still()
    links = near_links(talos, scene, motion, checker)

    answer = checker.check(motion, scene, conceded(links, ConcessionReason.STARTS_IN_CONTACT))

    assert {FindingKind.CONCESSION, FindingKind.SCENE_COLLISION} <= kinds(answer)


def test_a_contact_at_the_start_may_end_and_may_not_become_deeper(talos, motions, checker):
    scene = PlanningScene().with_object(ball(talos, -0.005))
    fingers = [f"gripper_right_fingertip_{k}_link" for k in (1, 2)]
    asked = conceded(fingers, ConcessionReason.STARTS_IN_CONTACT)
    asked += conceded(["gripper_right_inner_double_link"], ConcessionReason.STARTS_NEAR, 0.0)

    away = checker.check(motions.joint("arm_right_4_joint", -0.3), scene, asked)
    deeper = checker.check(motions.joint("arm_right_2_joint", -0.5), scene, asked)

    assert FindingKind.CONCESSION not in kinds(away)
    assert FindingKind.CONCESSION in kinds(deeper)


@pytest.mark.parametrize(
    "reason",
    [
        ConcessionReason.GRASPED_OBJECT,
        ConcessionReason.HANDLE_IN_HAND,
        ConcessionReason.SUPPORT_OF_HELD_OBJECT,
    ],
)
def test_an_elbow_is_conceded_nothing_that_a_hand_is(talos, motions, checker, reason):
    scene = PlanningScene().with_object(ball(talos, 0.2, movable=reason is ConcessionReason.GRASPED_OBJECT))

    answer = checker.check(motions.still(), scene, conceded(["arm_right_4_link"], reason))

    assert kinds(answer) == {FindingKind.CONCESSION}


def test_a_hand_may_touch_what_it_grasps(talos, motions, checker):
    scene = PlanningScene().with_object(ball(talos, -0.01))
    hand = talos.description.grippers["right"].touch_links
    answer = checker.check(motions.still(), scene, conceded(hand, ConcessionReason.GRASPED_OBJECT))

    assert FindingKind.CONCESSION not in kinds(answer)
    assert not any(set(one.subject) & set(hand) for one in getattr(answer, "findings", ()))


def test_only_one_hand_grasps(talos, motions, checker):
    scene = PlanningScene().with_object(ball(talos, 0.2))
    both = [talos.description.grippers[hand].touch_links[0] for hand in ("right", "left")]

    answer = checker.check(motions.still(), scene, conceded(both, ConcessionReason.GRASPED_OBJECT))

    assert [one.subject for one in answer.findings] == [tuple(sorted((both[1], "ball")))]


@pytest.mark.parametrize("reason", list(ConcessionReason))
def test_two_links_of_the_robot_are_never_conceded(motions, checker, reason):
    pair = Concession(frozenset(("arm_left_4_link", "arm_right_4_link")), reason, "move")

    answer = checker.check(motions.still(), PlanningScene(), [pair])

    assert kinds(answer) == {FindingKind.CONCESSION}


def test_what_is_at_rest_may_be_where_it_is_and_what_moves_may_not(talos, motions, checker):
    wall = SceneObject(
        "ball", Box((0.1, 0.1, 0.1)), ball(talos, -0.02).world_T_object, margin_m=0.01, movable=False
    )
    scene = PlanningScene().with_object(wall)
    links = near_links(talos, scene, motions.still(), checker)
    resting = conceded(links, ConcessionReason.AT_REST)

    assert isinstance(checker.check(motions.joint("head_2_joint", -0.1), scene, resting), CheckedTrajectory)
    waving = checker.check(motions.joint("arm_right_4_joint", -0.4), scene, resting)
    assert kinds(waving) & {FindingKind.CONCESSION, FindingKind.SCENE_COLLISION}


def test_concessions_about_what_is_gone_say_nothing(motions, checker):
    gone = conceded([FINGER], ConcessionReason.GRASPED_OBJECT)

    assert np.isfinite(checker.check(motions.still(), PlanningScene(), gone).min_com_margin_m)
