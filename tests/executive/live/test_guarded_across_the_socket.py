"""Walks and hands that yield, asked for across the socket and made on the other side."""

import numpy as np
import pytest

from executive.live.control_client.yielding_client import YieldingClient
from kinematics.geometry import poses
from kinematics.geometry.shapes import Box
from kinematics.scene.opening_path import DrawerLine
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from kinematics.walking.pattern.steering import VelocitySteering
from robots.control.hands.yield_order import YieldOrder
from robots.control.motion_handle import MotionStatus
from trees.world_model import WorldModel

AHEAD = np.array([1.0, 0.0, 0.0])


def order(talos, far_m=0.05, near_m=0.0, **more):
    tcp_m = talos.frame_pose(talos.q_home, "tcp_left")[:3, 3]
    return YieldOrder(
        "left", PlanningScene(), (), DrawerLine(tcp_m, 0.0), near_m, far_m, bias=np.zeros(6),
        holding=False, **more,
    )  # fmt: skip


def until(executive, condition, ticks):
    for _ in range(ticks):
        if condition():
            return True
        executive.ticks(1)
    return False


@pytest.mark.requirement("S6")
def test_a_hand_leads_across_the_socket_and_tells_what_it_felt(executive, talos):
    motion = executive.yielding.start(order(talos))
    assert motion.report.outcome == "running"

    assert until(executive, lambda: motion.handle.finished, 250)

    assert motion.handle.status is MotionStatus.DONE, motion.handle.reason
    assert motion.report.outcome == "arrived"
    assert motion.report.s == pytest.approx(0.05)
    moved = talos.frame_pose(executive.motion.reference(), "tcp_left")[:3, 3]
    before = talos.frame_pose(talos.q_home, "tcp_left")[:3, 3]
    assert before[0] - moved[0] == pytest.approx(0.05, abs=0.01)


def test_a_hand_that_only_yields_comes_to_rest_when_it_is_told_to_finish(executive, talos):
    motion = executive.yielding.start(order(talos, far_m=0.0))
    executive.ticks(30)
    assert motion.handle.status is MotionStatus.RUNNING

    motion.finish()

    assert until(executive, lambda: motion.handle.finished, 100)
    assert motion.report.outcome == "arrived"


@pytest.mark.requirement("S7")
def test_a_hand_that_leads_is_cancelled_and_rests(executive, talos):
    motion = executive.yielding.start(order(talos, far_m=0.25))
    assert until(executive, lambda: motion.report.s > 0.03, 200)

    executive.motion.cancel(motion.handle, "by the test")

    assert until(executive, lambda: executive.link.report.resting, 50)
    assert motion.handle.status is MotionStatus.CANCELED
    assert not executive.far.loop.statistics.refused


@pytest.mark.requirement("S6")
def test_an_order_for_an_older_world_is_refused_as_stale(executive, talos):
    executive.world.update(PlanningScene(version=3))
    executive.ticks(2)
    behind = YieldingClient(executive.link, executive.motion, talos, WorldModel())

    motion = behind.start(order(talos))
    executive.ticks(2)

    assert motion.handle.status is MotionStatus.REFUSED
    assert "stale" in motion.handle.reason


@pytest.mark.requirement("S6")
def test_the_other_side_does_not_lead_into_what_is_in_the_way(executive, talos):
    tcp_m = talos.frame_pose(talos.q_home, "tcp_left")[:3, 3]
    wall = SceneObject("wall", Box((0.04, 0.4, 0.4)), poses.translation(*(tcp_m + AHEAD * 0.12)))
    ahead = YieldOrder(
        "left", PlanningScene().with_objects([wall]), (), DrawerLine(tcp_m + AHEAD * 0.3, 0.0), 0.3, 0.0,
        bias=np.zeros(6), holding=False,
    )  # fmt: skip
    motion = executive.yielding.start(ahead)

    assert until(executive, lambda: motion.handle.finished, 250)

    assert motion.handle.status is MotionStatus.REFUSED
    assert "wall" in motion.handle.reason


def test_a_walk_is_under_way_until_the_robot_stands_again(executive, talos):
    settings = talos.description.walking
    assert not executive.walking.active

    handle = executive.walking.walk(VelocitySteering(settings, 0.0, 0.2), "walk")
    assert executive.walking.active
    executive.ticks(60)
    assert handle.status is MotionStatus.RUNNING, handle.reason
    assert executive.link.report.walking
    assert not executive.link.report.resting

    executive.walking.cancel(handle, "by the test")
    assert handle.status is MotionStatus.CANCELED
    assert executive.walking.active

    assert until(executive, lambda: not executive.walking.active, 250)
    assert executive.link.report.resting


@pytest.mark.requirement("S3")
def test_a_walk_whose_commander_has_gone_is_brought_to_its_end(executive, talos):
    executive.walking.walk(VelocitySteering(talos.description.walking, 0.0, 0.2), "walk")
    executive.ticks(60)

    executive.link.close()
    executive.far.run(4.0)

    assert "connection" in executive.far.stops[0].reason
    assert not executive.far.loop.walking.active


def test_a_second_walk_is_refused_while_one_is_under_way(executive, talos):
    settings = talos.description.walking
    executive.walking.walk(VelocitySteering(settings, 0.0, 0.2), "walk")
    executive.ticks(10)

    second = executive.walking.walk(VelocitySteering(settings, 0.0, -0.2), "walk")
    executive.ticks(2)

    assert second.status is MotionStatus.REFUSED
    assert "walks already" in second.reason


@pytest.mark.requirement("S5")
def test_range_scans_come_while_they_are_asked_for_and_an_old_one_is_none(executive):
    sensor = executive.far.ranging
    sensor.points_m, sensor.silent = np.array([[1.5, 0.0, 0.1]]), False
    assert executive.ranging.scan() is None

    executive.ticks(12)
    np.testing.assert_allclose(executive.ranging.scan(), [[1.5, 0.0, 0.1]])

    sensor.silent = True
    executive.ticks(25)
    assert executive.ranging.scan() is None
