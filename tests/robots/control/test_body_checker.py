"""Whole-body motions that are made as they go are judged as they are made."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from kinematics import poses
from kinematics.collision import CollisionWorld
from kinematics.opening_path import DrawerLine
from kinematics.scene import PlanningScene, SceneObject
from kinematics.shapes import Box
from kinematics.stance import stance_at
from robots.control.body_checker import BodyChecker
from robots.control.motion_handle import MotionStatus
from robots.control.refusal import Limit
from robots.control.yield_settings import YieldSettings
from robots.control.yielding_hand import YieldingHand

EMPTY = YieldSettings(lost_s=99.0)
"""For hands that hold nothing."""


def led_home(model, scene, s_to=0.12):
    q = model.q_home
    place = model.frame_pose(q, "tcp_left")[:3, 3]
    line = DrawerLine(place, np.pi)  # forwards
    stance = stance_at(model, q)
    return YieldingHand(
        model, stance, "left", q, scene, (), line, 0.0, s_to, bias=np.zeros(6), settings=EMPTY
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
    checker = BodyChecker(talos, stance_at(talos, talos.q_home), motion)
    assert checker.judge() is None

    q = motion.body.q.copy()
    q[0] += 0.16
    motion.body = replace(motion.body, q=q)

    assert checker.judge() is not None


def test_legs_that_do_not_hold_the_feet_are_refused(talos):
    motion = led_home(talos, PlanningScene())
    checker = BodyChecker(talos, stance_at(talos, talos.q_home), motion)

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
    checker = BodyChecker(talos, stance_at(talos, talos.q_home), motion)
    assert checker.judge() is None

    motion.body = replace(motion.body, q=hand_at_body(talos, 0.003))

    assert checker.judge().limit is Limit.COLLISION


def test_what_begins_nearer_than_the_reserve_may_go_on(talos):
    motion = led_home(talos, PlanningScene())
    motion.body = replace(motion.body, q=hand_at_body(talos, 0.002))
    checker = BodyChecker(talos, stance_at(talos, talos.q_home), motion)

    assert checker.judge() is None
    motion.body = replace(motion.body, q=hand_at_body(talos, 0.001))
    assert checker.judge() is None
