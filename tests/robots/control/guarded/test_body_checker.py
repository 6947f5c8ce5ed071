"""Whole-body motions that are made as they go are judged as they are made."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from kinematics.collision import validity
from kinematics.collision.collision_world import CollisionWorld
from kinematics.geometry import poses
from kinematics.geometry.shapes import Box
from kinematics.model.stance import stance_at
from kinematics.model.standing_robot import StandingRobot
from kinematics.model.support_polygon import SupportPolygon
from kinematics.scene.opening_path import DrawerLine
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from kinematics.standing.free_coordinates import free_coordinates
from kinematics.standing.reserves import COM_RESERVE_M
from robots.control.gate.refusal import Limit
from robots.control.guarded.body_checker import BodyChecker
from robots.control.hands.yield_settings import YieldSettings
from robots.control.hands.yielding_hand import YieldingHand
from robots.control.motion_handle import MotionStatus
from robots.models.description import load_robot

HARDWARE = load_robot("talos").hardware

EMPTY = YieldSettings(lost_s=99.0)
"""For hands that hold nothing."""


def led_home(model, scene, s_to=0.12):
    q = model.q_home
    place = model.frame_pose(q, "tcp_left")[:3, 3]
    line = DrawerLine(place, np.pi)  # forwards
    stance = stance_at(model, q)
    return YieldingHand(
        StandingRobot(model, stance),
        "left",
        q,
        scene,
        (),
        line,
        0.0,
        s_to,
        grip=HARDWARE.grips["left"],
        bias=np.zeros(6),
        settings=EMPTY,
    )


@pytest.mark.requirement("S6")
def test_a_motion_towards_something_is_stopped_before_it_touches(rig, talos):
    place = talos.frame_pose(talos.q_home, "tcp_left")[:3, 3]
    post = SceneObject(
        "post", Box((0.04, 0.3, 0.3)), poses.translation(*(place + np.array([0.17, 0.0, 0.0]))), 0.004
    )
    handle = rig.loop.motion.start(led_home(talos, PlanningScene().with_object(post)))

    for _ in range(1500):
        rig.loop.step()

    assert handle.status is MotionStatus.REFUSED
    assert "collision" in handle.reason
    assert "post" in handle.reason
    assert not rig.loop.sensing.state().readings.v.any()


def test_a_body_that_leans_out_of_balance_is_refused(talos):
    motion = led_home(talos, PlanningScene())
    checker = BodyChecker(StandingRobot(talos, stance_at(talos, talos.q_home)), motion)
    assert checker.judge() is None

    q = motion.body.q.copy()
    q[0] += 0.16
    motion.body = replace(motion.body, q=q)

    refusal = checker.judge()
    assert refusal.limit is Limit.BALANCE
    assert refusal.value < refusal.bound


@pytest.mark.requirement("S6")
@pytest.mark.parametrize("judge", ["kernel", "samples"])
def test_every_loss_of_balance_is_told_as_one(talos, judge, monkeypatch):
    if judge == "samples":
        monkeypatch.setattr(validity, "_kernel_is_there", lambda: False)
    motion = led_home(talos, PlanningScene())
    stance = stance_at(talos, talos.q_home)
    space, kinds = free_coordinates(StandingRobot(talos, stance)), {}
    for ahead_m in np.linspace(0.0, 0.16, 33 if judge == "kernel" else 9):
        x = space.home.copy()
        x[0] += ahead_m
        q = space.to_q(x[None])[0][0]
        margin_m = SupportPolygon(stance, talos.description.soles).com_margin_m(talos.com(q))
        checker = BodyChecker(StandingRobot(talos, stance), motion)
        motion.body = replace(motion.body, q=q)
        kinds[margin_m - talos.description.com_margin_m] = checker.judge()

    unbalanced = [refusal for room_m, refusal in kinds.items() if room_m < COM_RESERVE_M - 1e-6]
    assert {refusal.limit for refusal in unbalanced} == {Limit.BALANCE}
    assert all(refusal.value < refusal.bound for refusal in unbalanced)
    assert not any(refusal for room_m, refusal in kinds.items() if room_m > COM_RESERVE_M + 1e-6)


def test_a_foot_that_cannot_stay_is_told_as_that(talos):
    motion = led_home(talos, PlanningScene())
    checker = BodyChecker(StandingRobot(talos, stance_at(talos, talos.q_home)), motion)
    q = motion.body.q.copy()
    q[2] += 0.2
    motion.body = replace(motion.body, q=q)

    refusal = checker.judge()

    assert refusal.limit is Limit.REACH
    assert "foot" in str(refusal)


def test_a_joint_beyond_what_plans_keep_is_told_with_its_numbers(talos):
    motion = led_home(talos, PlanningScene())
    checker = BodyChecker(StandingRobot(talos, stance_at(talos, talos.q_home)), motion)
    q, k = motion.body.q.copy(), talos.joint_index("head_1_joint")
    q[7 + k] = talos.upper_rad[k]
    motion.body = replace(motion.body, q=q)

    refusal = checker.judge()

    assert (refusal.limit, refusal.joint) == (Limit.POSITION, "head_1_joint")
    assert refusal.value > refusal.bound


@pytest.mark.parametrize(("place", "part"), [(1, "base"), (7 + 3, "leg_left_4_joint"), (-1, "head_2_joint")])
def test_what_is_no_number_is_told_as_that(talos, place, part):
    motion = led_home(talos, PlanningScene())
    checker = BodyChecker(StandingRobot(talos, stance_at(talos, talos.q_home)), motion)
    assert checker.judge() is None
    q = motion.body.q.copy()
    q[place] = np.nan
    motion.body = replace(motion.body, q=q)

    refusal = checker.judge()

    assert refusal.limit is Limit.NOT_FINITE
    assert str(refusal) == f"{part} is nan, not a finite number"


def holding_a_rod(model, end_m):
    """The left hand holds a rod upright, which ends so far above the floor and touches no link."""
    frame, length_m = model.description.tcp_frames["left"], 0.5
    tcp = model.frame_pose(model.q_home, frame)
    place = poses.translation(tcp[0, 3], tcp[1, 3], end_m + 0.5 * length_m)
    rod = SceneObject("rod", Box((0.02, 0.02, length_m)), place)
    links = [model.link_of(item) for item in model.geometry().geometryObjects]
    return PlanningScene().with_object(rod).with_attached("rod", frame, poses.inverse(tcp) @ place, links)


@pytest.mark.requirement("S6")
def test_what_a_hand_holds_is_stopped_before_it_meets_the_floor(talos):
    motion = led_home(talos, holding_a_rod(talos, 0.02))
    checker = BodyChecker(StandingRobot(talos, stance_at(talos, talos.q_home)), motion)
    assert checker.judge() is None

    motion.scene = holding_a_rod(talos, 0.002)

    refusal = checker.judge()
    assert refusal.limit is Limit.COLLISION
    assert set(refusal.joint.split(" and ")) == {"rod", "floor"}


def test_what_begins_near_the_floor_keeps_the_other_reserves(talos):
    motion = led_home(talos, holding_a_rod(talos, 0.002))
    checker = BodyChecker(StandingRobot(talos, stance_at(talos, talos.q_home)), motion)
    assert checker.judge() is None

    motion.body = replace(motion.body, q=hand_at_body(talos, 0.003))

    assert checker.judge().limit is Limit.COLLISION


@pytest.mark.requirement("S6")
def test_a_squat_in_which_the_thighs_meet_is_refused(talos):
    motion = led_home(talos, PlanningScene())
    stance = stance_at(talos, talos.q_home)
    space = free_coordinates(StandingRobot(talos, stance))
    checker = BodyChecker(StandingRobot(talos, stance), motion)
    assert checker.judge() is None

    x = space.home.copy()
    x[:6] += [-0.02, 0.05, -0.15, 0.2, 0.05, 0.3]
    motion.body = replace(motion.body, q=space.to_q(x[None])[0][0])

    refusal = checker.judge()
    assert refusal.limit is Limit.COLLISION
    assert refusal.joint.count("leg_") == 2


def test_legs_that_do_not_hold_the_feet_are_refused(talos):
    motion = led_home(talos, PlanningScene())
    checker = BodyChecker(StandingRobot(talos, stance_at(talos, talos.q_home)), motion)

    q = motion.body.q.copy()
    q[7 + talos.joint_index("leg_left_4_joint")] += 0.01
    motion.body = replace(motion.body, q=q)

    assert checker.judge().limit is Limit.STANCE


def hand_at_body(model, gap_m):
    """On the way from home to a posture in collision, where the robot's own links are so far apart."""
    inside, kept = model.q_home.copy(), CollisionWorld(model, PlanningScene(), self_margin_m=gap_m)
    inside[7 + model.joint_index("arm_left_3_joint")] -= 1.75
    assert kept.collides(inside)
    low, high = 0.0, 1.0
    for _ in range(30):
        middle = 0.5 * (low + high)
        hit = kept.collides(model.q_home + middle * (inside - model.q_home))
        low, high = (low, middle) if hit else (middle, high)
    return model.q_home + low * (inside - model.q_home)


@pytest.mark.requirement("S6")
def test_a_motion_is_stopped_before_its_own_links_touch(talos):
    motion = led_home(talos, PlanningScene())
    checker = BodyChecker(StandingRobot(talos, stance_at(talos, talos.q_home)), motion)
    assert checker.judge() is None

    motion.body = replace(motion.body, q=hand_at_body(talos, 0.003))

    assert checker.judge().limit is Limit.COLLISION


def test_what_begins_nearer_than_the_reserve_may_go_on(talos):
    motion = led_home(talos, PlanningScene())
    motion.body = replace(motion.body, q=hand_at_body(talos, 0.002))
    checker = BodyChecker(StandingRobot(talos, stance_at(talos, talos.q_home)), motion)

    assert checker.judge() is None
    motion.body = replace(motion.body, q=hand_at_body(talos, 0.001))
    assert checker.judge() is None
