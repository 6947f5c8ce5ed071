"""A standing robot does not go on swinging: torques of the legs against what nobody commanded."""

import numpy as np
import pytest

from robots.clock import ManualClock
from robots.control.balance.sway_damping import SwayDamping
from robots.control.loop.control_loop import ControlLoop
from robots.interface.hardware import RobotData
from robots.models.description import load_robot
from robots.scenes.scene_description import SceneDescription
from robots.simulated.world import build_world

HARDWARE = load_robot("talos").hardware

PUSH_N, PUSHED_S = 80.0, 0.1


def joint(talos, name):
    return talos.description.actuated.index(name)


def speeds(talos, **of):
    v = np.zeros(len(talos.description.actuated))
    for name, speed in of.items():
        v[joint(talos, f"{name}_joint")] = speed
    return v


def damped(talos, measured, commanded, efforts, periods=100):
    damping = SwayDamping(RobotData(talos.description, HARDWARE), 0.002)
    for _ in range(periods):
        damping.sense(measured, commanded)
    damping.add_to(efforts)
    return efforts


def test_legs_push_against_what_moves_them_and_other_joints_do_not(talos):
    v = speeds(talos, leg_left_6=0.02, leg_right_4=-0.01, arm_left_1=0.5)

    efforts = damped(talos, v, np.zeros_like(v), np.zeros_like(v))

    expected = speeds(talos, leg_left_6=-12.0, leg_right_4=6.0)
    np.testing.assert_allclose(efforts, expected, atol=1e-3)


def test_legs_that_move_as_they_are_told_are_left_alone(talos):
    v = speeds(talos, leg_left_4=0.8, leg_right_4=0.8)

    np.testing.assert_array_equal(damped(talos, v, v, np.zeros_like(v)), 0.0)


def test_it_asks_for_no_more_than_a_leg_can_give(talos):
    limits = np.array([talos.description.limits[name].effort for name in talos.description.actuated])
    v = speeds(talos, leg_left_6=-5.0, leg_right_4=5.0)
    weight = speeds(talos, leg_left_6=1.0, leg_right_4=-1.0) * 0.95 * limits

    efforts = damped(talos, v, np.zeros_like(v), weight)

    assert (np.abs(efforts) <= limits).all()
    ankle, knee = joint(talos, "leg_left_6_joint"), joint(talos, "leg_right_4_joint")
    assert efforts[ankle] == limits[ankle]
    assert efforts[knee] == -limits[knee]


def test_after_a_walk_it_begins_anew(talos):
    damping = SwayDamping(RobotData(talos.description, HARDWARE), 0.002)
    v = speeds(talos, leg_left_6=1.0)
    damping.sense(v, np.zeros_like(v))

    damping.forget()

    efforts = np.zeros_like(v)
    damping.add_to(efforts)
    np.testing.assert_array_equal(efforts, 0.0)


@pytest.mark.requirement("S4")
@pytest.mark.parametrize("along", [0, 1])
def test_a_robot_that_was_pushed_is_at_rest_half_a_second_later(talos, along):
    world = build_world(
        RobotData(talos.description, HARDWARE),
        SceneDescription("floor"),
        np.random.default_rng(3),
    )
    loop = ControlLoop(world.robot, talos, ManualClock(), lambda event: None)
    physics = world.truth._physics
    trunk = physics.body_id("torso_2_link")

    def run(seconds, push_n=0.0):
        fastest = 0.0
        physics.data.xfrc_applied[trunk, along] = push_n
        for _ in range(round(seconds / 0.002)):
            loop.step()
            fastest = max(fastest, np.abs(world.truth.joint_velocities()).max())
        return fastest

    run(0.3)
    assert run(PUSHED_S, PUSH_N) > 0.02
    run(0.5)

    assert run(0.7) < 0.015
    assert loop.statistics.refused == 0
