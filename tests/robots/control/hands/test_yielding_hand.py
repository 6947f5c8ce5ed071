"""A hand that leads what it holds, and yields to it: against doors made of a few lines."""

from __future__ import annotations

import math

import numpy as np
import pinocchio as pin
import pytest

from kinematics.model.stance import stance_at
from kinematics.model.standing_robot import StandingRobot
from kinematics.scene.opening_path import DoorArc, DrawerLine
from kinematics.scene.planning_scene import PlanningScene
from robots.control.hands.yielding_hand import YieldingHand
from robots.interface.robot import RobotState
from robots.models.description import load_robot

HARDWARE = load_robot("talos").hardware

PERIOD_S = 0.002


class Held:
    """Plays a motion for a perfect body whose left hand feels what ``force`` says."""

    def __init__(self, model, motion, force):
        self._model, self._motion, self._force = model, motion, force
        self._data = model.pin.createData()
        self._frame = model.frame_id("tcp_left")
        self.gripper = (-0.45, -4.0)

    def play(self, seconds):
        """Run; the forces that were felt, N, shape (n, 3)."""
        felt = []
        for k in range(round(seconds / PERIOD_S)):
            body = self._motion.body
            force = self._force(self._tcp(body.q))
            felt.append(force)
            if self._motion.sample(k * PERIOD_S, self._state(k, body, force)) is None:
                break
        return np.array(felt)

    def _tcp(self, q):
        return self._model.frame_pose(q, "tcp_left")[:3, 3]

    def _state(self, k, body, force):
        model, data = self._model, self._data
        effort = pin.rnea(model.pin, data, body.q, body.v, body.a)[6:]
        armature = [model.description.armature[joint] for joint in model.joints]
        effort = effort + np.array(armature) * body.a[6:] + 1.0 * body.v[6:]
        pin.computeJointJacobians(model.pin, data, body.q)
        pin.updateFramePlacement(model.pin, data, self._frame)
        jacobian = pin.getFrameJacobian(model.pin, data, self._frame, pin.LOCAL_WORLD_ALIGNED)
        effort = effort - jacobian[:3, 6:].T @ force
        fingers = np.zeros((2, 2))
        fingers[:] = np.array(self.gripper)[:, None]
        q = np.concatenate([body.q[7:], fingers[0]])
        tau = np.concatenate([effort, fingers[1]])
        return RobotState(k * PERIOD_S, q, np.zeros_like(q), tau, np.zeros(3), np.zeros(3), np.zeros((2, 6)))


@pytest.fixture(scope="module")
def at_handle(talos):
    """A posture with the left hand before the chest."""
    q = talos.q_home
    return q, talos.frame_pose(q, "tcp_left")[:3, 3]


def leading(model, q, path, s_to, **more):
    scene, stance = PlanningScene(), stance_at(model, q)
    return YieldingHand(
        StandingRobot(model, stance),
        "left",
        q,
        scene,
        (),
        path,
        0.0,
        s_to,
        grip=HARDWARE.grips["left"],
        bias=np.zeros(6),
        **more,
    )


def nothing(_tcp):
    return np.zeros(3)


def drawer(place):
    return DrawerLine(place, 0.0)


def test_what_gives_way_is_led_to_the_end(talos, at_handle):
    q, place = at_handle
    motion = leading(talos, q, drawer(place), 0.1)

    Held(talos, motion, nothing).play(4.0)

    assert motion.report.outcome == "arrived"
    assert talos.frame_pose(motion.body.q, "tcp_left")[:3, 3] == pytest.approx(place - [0.1, 0, 0], abs=0.006)


def test_what_is_locked_is_told_to_be_stuck_and_let_be(talos, at_handle):
    q, place = at_handle

    def locked(tcp):
        return np.array([3000.0 * (place[0] - tcp[0]), 0.0, 0.0])

    motion = leading(talos, q, drawer(place), 0.3)
    felt = Held(talos, motion, locked).play(12.0)

    assert motion.report.outcome == "stuck"
    assert np.linalg.norm(felt, axis=1).max() <= 70.0
    assert np.linalg.norm(felt[-1]) < 15.0


def test_a_hinge_elsewhere_than_believed_makes_no_large_force(talos, at_handle):
    q, place = at_handle
    believed = DoorArc(place[:2] + np.array([0.05, 0.53]), 0.0, 1.0, 0.53, 0.05, place[2])
    true = DoorArc(believed.hinge_m + np.array([0.0, 0.03]), 0.0, 1.0, 0.56, 0.05, place[2])

    def door(tcp):
        away = tcp[:2] - true.hinge_m
        radius = np.linalg.norm(away)
        pull = 3000.0 * (true.lever_m - radius) * away / radius
        return np.array([*pull, 0.0])

    motion = leading(talos, q, believed.through(place, 0.0), math.radians(25.0))
    yielding = np.linalg.norm(Held(talos, motion, door).play(5.0), axis=1)

    assert motion.report.outcome == "arrived"
    assert yielding.max() < 20.0


def test_a_hand_that_closed_on_nothing_says_that_it_lost_it(talos, at_handle):
    q, place = at_handle
    motion = leading(talos, q, drawer(place), 0.2)
    held = Held(talos, motion, nothing)
    held.gripper = (-0.69, -0.1)

    held.play(4.0)

    assert motion.report.outcome == "lost"


def test_a_closing_drawer_that_meets_its_frame_has_arrived(talos, at_handle):
    q, place = at_handle
    line = DrawerLine(place + np.array([0.1, 0.0, 0.0]), 0.0)
    scene, stance = PlanningScene(), stance_at(talos, q)
    motion = YieldingHand(
        StandingRobot(talos, stance),
        "left",
        q,
        scene,
        (),
        line,
        0.1,
        -0.05,
        grip=HARDWARE.grips["left"],
        bias=np.zeros(6),
        stop_from=0.05,
    )

    def frame(tcp):
        return np.array([min(0.0, 3000.0 * (place[0] + 0.1 - tcp[0])), 0.0, 0.0])

    felt = Held(talos, motion, frame).play(8.0)

    assert motion.report.outcome == "arrived"
    assert np.linalg.norm(felt[-1]) < 20.0
