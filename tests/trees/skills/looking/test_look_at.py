from dataclasses import replace

import numpy as np
import pytest
from py_trees.common import Status

from kinematics.geometry import poses
from kinematics.motion.verdict import Finding, FindingKind, Unsafe
from kinematics.requests.move import MoveRequest
from kinematics.requests.step import NoPlan
from trees.beliefs.sight.sight import in_view, off_axis_rad
from trees.failures import FailureKind
from trees.policy import Gaze
from trees.skills.looking.hand_ways import UnseenPlaces
from trees.skills.looking.look_at import LookAt, LookAtTarget, LookAtUnseen, joints_that_show

DOWN_LEFT = Gaze("down left", tilt_rad=0.5, pan_rad=0.4, lean_rad=0.1)


def position(stage, joint):
    return stage.fake.sensing.state().q[7 + stage.toolbox.model.joint_index(joint)]


def test_the_head_ends_at_the_gaze(stage):
    assert stage.run(LookAt("look", stage.toolbox, DOWN_LEFT)) is Status.SUCCESS
    assert position(stage, "head_1_joint") == pytest.approx(0.5)
    assert position(stage, "head_2_joint") == pytest.approx(0.4)
    assert position(stage, "torso_2_joint") == pytest.approx(0.1)


def test_everything_else_is_told_to_stay(stage):
    stage.run(LookAt("look", stage.toolbox, DOWN_LEFT))

    (move,) = [request for request in stage.fake.planning.requests if isinstance(request, MoveRequest)]
    assert move.keep_others
    assert set(move.joints) == {"head_1_joint", "head_2_joint", "torso_1_joint", "torso_2_joint"}
    assert move.joints["torso_1_joint"] == 0.0


def test_a_gaze_beyond_the_limits_stops_at_them(stage):
    stage.run(LookAt("look", stage.toolbox, Gaze("down", tilt_rad=3.0)))

    assert position(stage, "head_1_joint") == pytest.approx(0.785398 - 0.01, abs=1e-4)


def test_a_head_that_looks_there_already_does_not_move(stage):
    stage.run(LookAt("look", stage.toolbox, DOWN_LEFT))
    started = len(stage.fake.motion.started)

    assert stage.run(LookAt("look", stage.toolbox, DOWN_LEFT)) is Status.SUCCESS
    assert len(stage.fake.motion.started) == started


DRAWN_BACK = Gaze("drawn back", tilt_rad=0.77, lean_rad=0.45, back_m=0.09)


def asked_pelvis_m(stage):
    moves = [request for request in stage.fake.planning.requests if isinstance(request, MoveRequest)]
    return moves[-1].pelvis_m


def test_eyes_that_are_drawn_back_take_the_pelvis_along_and_the_next_gaze_brings_it_home(stage):
    stage.run(LookAt("look", stage.toolbox, DRAWN_BACK))
    assert asked_pelvis_m(stage) == pytest.approx((-0.09, 0.0, 0.0))

    stage.run(LookAt("look", stage.toolbox, DOWN_LEFT))
    assert asked_pelvis_m(stage) == pytest.approx((0.09, 0.0, 0.0))


def test_a_look_at_something_turns_the_head_alone_wherever_the_pelvis_is(knowing, target):
    knowing.run(LookAt("look", knowing.toolbox, DRAWN_BACK))

    knowing.run(LookAtTarget("look", knowing.toolbox), target=target)

    assert asked_pelvis_m(knowing) == (0.0, 0.0, 0.0)


def test_a_pelvis_that_is_back_already_stays_there(stage):
    stage.run(LookAt("look", stage.toolbox, DRAWN_BACK))
    started = len(stage.fake.motion.started)

    stage.run(LookAt("look", stage.toolbox, DRAWN_BACK))

    assert len(stage.fake.motion.started) == started


def test_the_last_gaze_shows_what_stands_before_the_body(stage):
    model, edge = stage.toolbox.model, np.array([0.30, 0.0, 1.05])
    half_rad = 0.5 * model.description.camera.vertical_fov_rad
    policy = stage.toolbox.policy

    def seen_from(gaze):
        stage.run(LookAt("look", stage.toolbox, gaze))
        return abs(off_axis_rad(stage.fake.world.world_T_camera(), edge)[1]) < half_rad

    assert not any(seen_from(gaze) for gaze in policy.search_gazes)
    assert seen_from(policy.last_gaze)


def test_the_trunk_leans_only_for_what_the_head_alone_does_not_show(stage):
    far, at_the_near_edge = np.array([0.8, 0.1, 0.9]), np.array([0.38, -0.24, 0.84])

    assert set(joints_that_show(stage.toolbox, far)) == {"head_1_joint", "head_2_joint"}
    assert joints_that_show(stage.toolbox, at_the_near_edge)["torso_2_joint"] > 0.1


def test_the_target_comes_to_the_middle_of_the_picture(stage, target):
    assert stage.run(LookAtTarget("look", stage.toolbox), target=target) is Status.SUCCESS

    camera = stage.fake.world.world_T_camera()
    right, down = off_axis_rad(camera, target.odom_T_object[:3, 3])
    assert abs(right) < 0.01
    assert down < 0.43  # in the picture; the tilt joint ends before the cup is in its middle


@pytest.mark.requirement("P2")
@pytest.mark.parametrize("leaning", [True, False])
def test_a_closer_look_leans_over_what_the_head_alone_does_not_show(stage, target, leaning):
    near = replace(target, odom_T_object=poses.translation(0.38, -0.24, 0.84))

    stage.run(LookAtTarget("look", stage.toolbox, leaning=leaning), target=near)

    assert (position(stage, "torso_2_joint") > 0.1) == leaning


def test_an_object_in_the_hand_is_looked_for_there(knowing, target):
    scene = knowing.told.scene
    knowing.told.update(scene.with_attached("red cup", "tcp_left", np.eye(4), []))
    knowing.run(LookAtTarget("look", knowing.toolbox), target=target)

    hand = knowing.toolbox.model.frame_pose(knowing.fake.sensing.state().q, "tcp_left")[:3, 3]
    assert abs(off_axis_rad(knowing.fake.world.world_T_camera(), hand)[0]) < 0.05


def test_no_plan_is_infeasible_with_the_planners_reasons(stage):
    stage.fake.planning.no_plan = NoPlan("the head is blocked", {"collision": 3})
    leaf = LookAt("look", stage.toolbox, DOWN_LEFT)

    assert stage.run(leaf) is Status.FAILURE
    assert leaf.failure.kind is FailureKind.INFEASIBLE
    assert leaf.failure.numbers == {"collision": 3}


@pytest.mark.requirement("S6")
def test_an_unsafe_motion_is_never_started(stage):
    finding = Finding(FindingKind.SELF_COLLISION, 0.1, ("head_2_link", "torso_2_link"), -0.01, 0.0)
    stage.fake.planning.unsafe = lambda request: Unsafe((finding,))
    leaf = LookAt("look", stage.toolbox, DOWN_LEFT)

    assert stage.run(leaf) is Status.FAILURE
    assert leaf.failure.kind is FailureKind.UNSAFE
    assert leaf.failure.numbers["subject"] == "head_2_link and torso_2_link"
    assert stage.fake.motion.started == []


def test_a_plan_for_a_scene_of_the_past_is_thrown_away(stage):
    leaf = stage.ready(LookAt("look", stage.toolbox, DOWN_LEFT))
    stage.tick(leaf)
    stage.told.update(stage.told.scene.with_objects([]))

    while stage.tick(leaf) is Status.RUNNING:
        pass

    assert "stale" in leaf.failure.message
    assert stage.fake.motion.started == []


def test_a_joint_that_does_not_follow_is_named(stage):
    stage.fake.robot.stuck.add("head_2_joint")
    leaf = LookAt("look", stage.toolbox, DOWN_LEFT)

    assert stage.run(leaf) is Status.FAILURE
    assert leaf.failure.kind is FailureKind.EXECUTION
    assert leaf.failure.numbers["joint"] == "head_2_joint"


@pytest.mark.requirement("S7")
def test_a_halt_while_planning_forgets_the_job(stage):
    leaf = stage.ready(LookAt("look", stage.toolbox, DOWN_LEFT))
    stage.tick(leaf)

    leaf.stop(Status.INVALID)

    assert stage.fake.planning.jobs[0].canceled


@pytest.mark.requirement("S7")
def test_a_halt_while_moving_leaves_the_robot_holding(stage):
    leaf = stage.ready(LookAt("look", stage.toolbox, DOWN_LEFT))
    while not stage.fake.motion.moving:
        stage.tick(leaf)

    leaf.stop(Status.INVALID)

    assert not stage.fake.motion.moving


def test_the_eyes_go_to_the_middle_of_what_was_not_seen(stage):
    places = np.array([(1.4, -0.3, 0.93), (1.6, -0.1, 0.93)])

    assert stage.run(LookAtUnseen("look", stage.toolbox), unseen=UnseenPlaces(places)) is Status.SUCCESS

    model = stage.toolbox.model
    eye = model.frame_pose(stage.fake.sensing.state().q, model.description.camera.frame)
    assert np.abs(off_axis_rad(eye, places.mean(axis=0))).max() < 0.05


def test_of_places_on_both_sides_the_eyes_go_to_those_that_are_more(stage):
    right = np.array([(0.5, -0.6, 0.93), (0.5, -0.7, 0.93), (0.6, -0.6, 0.93)])
    left = np.array([(0.5, 0.7, 0.93), (0.5, 0.6, 0.93)])

    places = UnseenPlaces(np.vstack([left, right]))
    assert stage.run(LookAtUnseen("look", stage.toolbox), unseen=places) is Status.SUCCESS

    model = stage.toolbox.model
    camera = model.description.camera
    eye = model.frame_pose(stage.fake.sensing.state().q, camera.frame)
    assert all(in_view(camera, eye, place) for place in right)
    assert not any(in_view(camera, eye, place) for place in left)


def test_where_everything_was_seen_the_eyes_stay(stage):
    started = len(stage.fake.motion.started)

    unseen = UnseenPlaces(np.zeros((0, 3)))

    assert stage.run(LookAtUnseen("look", stage.toolbox), unseen=unseen) is Status.SUCCESS
    assert len(stage.fake.motion.started) == started


@pytest.mark.requirement("P2")
def test_the_trunk_does_not_lean_over_what_would_be_too_near_to_the_eyes(stage):
    at_the_near_edge = np.array([0.40, -0.06, 1.03])

    leans = joints_that_show(stage.toolbox, at_the_near_edge)
    stays = joints_that_show(stage.toolbox, at_the_near_edge, clear_m=0.05)

    assert leans["torso_2_joint"] > 0.1
    assert "torso_2_joint" not in stays
    assert "torso_2_joint" in joints_that_show(stage.toolbox, np.array([0.40, -0.06, 0.8]), clear_m=0.05)
