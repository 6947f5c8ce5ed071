from dataclasses import replace

import numpy as np
import pytest

from kinematics.checking.settings import SPARE_M
from kinematics.geometry import poses
from kinematics.geometry.shapes import Ball, Box, Cylinder
from kinematics.motion.trajectory import Trajectory
from kinematics.motion.verdict import CheckedTrajectory, FindingKind, Unsafe
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from tools.checking.solid_world import SolidWorld

SHOULDER = "arm_right_1_joint"


def hand_at(talos, q):
    return talos.frame_pose(q, "tcp_right")[:3, 3]


def finger_at(talos, q):
    return talos.frame_pose(q, "gripper_right_fingertip_1_link")[:3, 3]


@pytest.fixture(scope="module")
def swing(motions):
    """The right arm turns outwards and back."""
    return motions.joint(SHOULDER, 0.8, 1.6, 161, and_back=True)


@pytest.mark.requirement("S6")
@pytest.mark.parametrize("fraction", [0.2, 0.31, 0.5])
def test_a_rod_of_5_mm_in_the_way_is_found(talos, swing, checker, findings_of, fraction):
    q = swing.q[int(fraction * 160)]
    rod = SceneObject("rod", Cylinder(0.0025, 0.3), poses.transform(np.eye(3), finger_at(talos, q)))

    assert any(
        kind is FindingKind.SCENE_COLLISION and "rod" in names
        for kind, *names in findings_of(checker.check(swing, PlanningScene().with_object(rod)))
    )


@pytest.mark.parametrize("fraction", [0.2, 0.31, 0.5])
def test_the_place_of_a_collision_is_on_the_rod_that_is_hit(talos, swing, checker, fraction):
    place = finger_at(talos, swing.q[int(fraction * 160)])
    rod = SceneObject("rod", Cylinder(0.0025, 0.3), poses.transform(np.eye(3), place))
    (finding, *_) = checker.check(swing, PlanningScene().with_object(rod)).findings

    across = np.hypot(*(np.array(finding.place_m) - place)[:2])
    assert across < 0.02
    assert abs(finding.place_m[2] - place[2]) < 0.17


def test_a_finding_that_is_no_contact_has_no_place(talos, swing, checker):
    quick = Trajectory(swing.joints, swing.stance, 0.1 * swing.t_s, swing.q, 10.0 * swing.v)

    assert {one.place_m for one in checker.check(quick, PlanningScene()).findings} == {None}


@pytest.mark.requirement("S6")
def test_a_plate_between_two_samples_is_found(talos, checker, swing, findings_of):
    # two samples only: the way between them is 0.5 m long, and the plate 5 mm thick
    ends = [0, 80]
    coarse = Trajectory(swing.joints, swing.stance, np.array([0.0, 1.5]), swing.q[ends], swing.v[ends])
    between = 0.5 * (swing.q[0] + swing.q[80])
    pose = poses.transform(np.eye(3), hand_at(talos, between))
    plate = SceneObject("plate", Box((0.3, 0.005, 0.3)), pose)
    free = SceneObject("plate", Box((0.3, 0.005, 0.3)), poses.translation(0.0, 0.0, 2.0) @ pose)

    assert isinstance(checker.check(coarse, PlanningScene().with_object(free)), CheckedTrajectory)
    assert "plate" in str(checker.check(coarse, PlanningScene().with_object(plate)))


@pytest.mark.requirement("S6")
@pytest.mark.parametrize("fraction", [0.2, 0.31, 0.45])
def test_what_is_hit_on_the_way_out_and_back_is_told_when_it_is_hit_first(
    talos, swing, checker, findings_of, fraction
):
    rod = SceneObject(
        "rod", Cylinder(0.0025, 0.3), poses.translation(*finger_at(talos, swing.q[int(fraction * 160)]))
    )
    scene = PlanningScene().with_object(rod)

    first_s = checker.check(swing, scene).findings[0].t_s

    assert first_s < fraction * 1.6
    until = swing.t_s < first_s - 0.005
    cut = Trajectory(swing.joints, swing.stance, swing.t_s[until], swing.q[until], swing.v[until])
    assert {kind for kind, *_ in findings_of(checker.check(cut, scene))} == {FindingKind.BOUNDARY_VELOCITY}


@pytest.mark.requirement("S6")
def test_a_hand_that_rests_too_near_is_told_from_the_beginning_while_the_head_turns(talos, motions, checker):
    looking = motions.joint("head_2_joint", 0.8, 3.0, 301)
    x, y, z = hand_at(talos, talos.q_home)
    ball = SceneObject("ball", Ball(0.05), poses.translation(x + 0.2, y, z))
    gap_m = exact_gap(talos, PlanningScene().with_object(ball))
    near, kept = (PlanningScene().with_object(replace(ball, margin_m=gap_m + by)) for by in (1e-4, -1e-4))

    answer = checker.check(looking, near)

    assert isinstance(checker.check(looking, kept), CheckedTrajectory)
    assert isinstance(answer, Unsafe)
    assert answer.findings[0].t_s < 0.05  # the first interval that is looked at without compiled code
    assert answer.findings[0].value == pytest.approx(gap_m, abs=1e-6)


@pytest.mark.requirement("S6")
def test_the_margin_of_an_object_is_kept_to_a_tenth_of_a_millimetre(talos, motions, checker):
    still = motions.still()
    x, y, z = hand_at(talos, talos.q_home)
    scene = PlanningScene().with_object(SceneObject("ball", Ball(0.05), poses.translation(x + 0.2, y, z)))
    near = checker.check(still, scene)
    assert isinstance(near, CheckedTrajectory)
    ball = scene.objects["ball"]
    gap = exact_gap(talos, scene)

    kept = checker.check(still, scene.with_object(replace(ball, margin_m=gap - 1e-4)))
    broken = checker.check(still, scene.with_object(replace(ball, margin_m=gap + 1e-4)))

    assert isinstance(kept, CheckedTrajectory)
    assert isinstance(broken, Unsafe)
    assert broken.findings[0].value == pytest.approx(gap, abs=1e-6)
    assert broken.findings[0].limit == pytest.approx(gap + 1e-4)


@pytest.mark.requirement("S6")
def test_what_is_checked_has_room_for_a_lead_in_at_its_start(talos, motions, checker):
    away = motions.joint("arm_left_4_joint", -0.3)
    x, y, z = hand_at(talos, talos.q_home)
    ball = SceneObject("ball", Ball(0.05), poses.translation(x + 0.2, y, z))
    gap_m = exact_gap(talos, PlanningScene().with_object(ball))

    def judged(room_m):
        return checker.check(away, PlanningScene().with_object(replace(ball, margin_m=gap_m - room_m)))

    for room_m in np.linspace(0.02, 0.98, 25) * SPARE_M:
        assert isinstance(judged(room_m), Unsafe), room_m
    assert isinstance(judged(5.0 * SPARE_M), CheckedTrajectory)


def exact_gap(talos, scene):
    world = SolidWorld(talos, scene, only=frozenset(scene.objects))
    return float((world.gaps(talos.q_home) + world.margins).min())


@pytest.mark.requirement("S6")
def test_a_self_collision_names_both_links_and_the_first_time(talos, motions, checker, findings_of):
    # the raised forearm turns inwards into the trunk
    inwards = motions.joint("arm_right_3_joint", 2.0, 4.0, 401)

    answer = checker.check(inwards, PlanningScene())

    assert isinstance(answer, Unsafe)
    first = answer.findings[0]
    assert first.kind is FindingKind.SELF_COLLISION
    assert len(first.subject) == 2
    assert all(talos.pin.existFrame(name) for name in first.subject)
    assert list(answer.findings) == sorted(answer.findings, key=lambda finding: finding.t_s)
    until = inwards.t_s < first.t_s - 0.01
    cut = Trajectory(inwards.joints, inwards.stance, inwards.t_s[until], inwards.q[until], inwards.v[until])
    left = findings_of(checker.check(cut, PlanningScene()))
    assert left == {(FindingKind.BOUNDARY_VELOCITY, "arm_right_3_joint")}


@pytest.mark.requirement("S6")
def test_what_a_hand_holds_is_judged_against_scene_and_robot(talos, motions, checker, findings_of):
    gripper = talos.description.grippers["right"]
    cup = SceneObject("cup", Cylinder(0.05, 0.3), np.eye(4))
    scene = (
        PlanningScene()
        .with_object(cup)
        .with_attached("cup", gripper.tcp_frame, np.eye(4), gripper.touch_links)
    )
    tip = talos.frame_pose(talos.q_home, gripper.tcp_frame) @ poses.translation(0, 0, 0.14)
    ball = SceneObject("ball", Ball(0.02), poses.transform(np.eye(3), tip[:3, 3] + [0.0, 0.0, 0.03]))
    still = motions.still()

    assert findings_of(checker.check(still, scene)) == set()
    assert (FindingKind.HELD_OBJECT_COLLISION, "cup", "ball") in findings_of(
        checker.check(still, scene.with_object(ball))
    )
    allowed = scene.with_object(ball).allowing([("cup", "ball")])
    assert not any("cup" in names for _, *names in findings_of(checker.check(still, allowed)))
    untouchable = scene.with_detached("cup", np.eye(4)).with_attached("cup", gripper.tcp_frame, np.eye(4), [])
    kinds = {kind for kind, *_ in findings_of(checker.check(still, untouchable))}
    assert kinds == {FindingKind.HELD_OBJECT_COLLISION}


def test_allowed_pairs_are_not_judged(talos, motions, checker, findings_of):
    ball = SceneObject("ball", Ball(0.05), poses.translation(*hand_at(talos, talos.q_home)))
    scene = PlanningScene().with_object(ball)
    touching = findings_of(checker.check(motions.still(), scene))
    assert touching

    allowed = scene.allowing([(link, "ball") for _, link, _ in touching])

    assert findings_of(checker.check(motions.still(), allowed)) == set()


def test_the_floor_is_there_without_being_told(talos, motions, checker, findings_of):
    gripper = talos.description.grippers["right"]
    height = float(hand_at(talos, talos.q_home)[2])
    pole = SceneObject("pole", Cylinder(0.01, 2.0 * height + 0.02), np.eye(4))
    upright = poses.inverse(talos.frame_pose(talos.q_home, gripper.tcp_frame))
    upright[:3, 3] = 0.0
    scene = (
        PlanningScene()
        .with_object(pole)
        .with_attached("pole", gripper.tcp_frame, upright, gripper.touch_links)
    )

    assert (FindingKind.HELD_OBJECT_COLLISION, "pole", "floor") in findings_of(
        checker.check(motions.still(), scene)
    )


def test_the_same_question_gets_the_same_answer(talos, swing, checker):
    scene = PlanningScene().with_object(
        SceneObject("ball", Ball(0.05), poses.translation(*hand_at(talos, swing.q[80])))
    )

    assert str(checker.check(swing, scene)) == str(checker.check(swing, scene))
    assert checker.check(swing, scene).findings == checker.check(swing, scene).findings
