"""What a person jogs goes through motion, online checker and gate, and brakes on silence."""

from __future__ import annotations

import numpy as np
import pytest

from kinematics.following.jog_reference import HandJog, JointJog
from kinematics.geometry import poses
from kinematics.geometry.shapes import Box
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from robots.control.motion_handle import MotionStatus

TABLE = SceneObject(
    "table", Box((0.6, 1.4, 0.04)), poses.translation(0.5, -0.6, 1.1), margin_m=0.015, movable=False
)


def hand(*linear, frame="world"):
    return HandJog("right", frame, np.array(linear, dtype=float), np.zeros(3))


def steps(rig, count):
    for _ in range(count):
        rig.loop.step()


def held_down(rig, jogging, jog, seconds):
    """A key that is repeated every 40 ms."""
    for _ in range(round(seconds / 0.04)):
        jogging.steer(jog)
        steps(rig, 20)


def moving(rig):
    return bool(np.abs(rig.robot.commands[-1].v).max() > 0.0)


def tcp(rig):
    model = rig.loop.model
    return model.frame_pose(rig.loop.motion.reference(), model.description.tcp_frames["right"])[:3, 3]


def test_one_press_is_a_bounded_step_and_silence_brakes(rig):
    jogging, before = rig.loop.jogging.start(PlanningScene()), tcp(rig)
    steps(rig, 5)

    jogging.steer(hand(0.05, 0.0, 0.0))
    steps(rig, 150)

    assert not moving(rig)
    assert 0.002 < (tcp(rig) - before)[0] < 0.012


def test_a_key_that_is_held_down_goes_on(rig):
    jogging, before = rig.loop.jogging.start(PlanningScene()), tcp(rig)

    held_down(rig, jogging, hand(0.05, 0.0, 0.0), 2.0)

    assert (tcp(rig) - before)[0] > 0.08


def test_the_table_stops_the_hand_and_is_named_and_up_leads_away(rig):
    jogging = rig.loop.jogging.start(PlanningScene().with_object(TABLE))

    held_down(rig, jogging, hand(0.0, 0.0, -0.1), 6.0)
    low, said = tcp(rig)[2], jogging.report.held_back
    held_down(rig, jogging, hand(0.0, 0.0, 0.1), 0.6)

    assert "table" in said
    assert jogging.handle.status is MotionStatus.RUNNING
    assert tcp(rig)[2] > low + 0.02
    assert rig.loop.statistics.refused == 0


def test_silence_for_a_second_ends_it_and_the_body_is_free_for_others(rig):
    jogging = rig.loop.jogging.start(PlanningScene())
    jogging.steer(JointJog("arm_right_4_joint", -0.2))

    steps(rig, 900)

    assert jogging.handle.status is MotionStatus.DONE
    assert rig.loop.motion.resting


@pytest.mark.requirement("S10")
@pytest.mark.parametrize("seed", range(4))
def test_random_keys_are_never_refused_by_checker_or_gate(rig, seed):
    rng = np.random.default_rng(seed)
    jogging = rig.loop.jogging.start(PlanningScene().with_object(TABLE))
    joints = [joint for joint in rig.loop.model.joints if joint.startswith(("arm", "head", "torso"))]

    for _ in range(12):
        if rng.random() < 0.4:
            jog = JointJog(str(rng.choice(joints)), float(rng.choice([-0.3, 0.3])))
        else:
            frame = str(rng.choice(["world", "base", "tool"]))
            way, turn = rng.normal(size=3), rng.normal(size=3)
            jog = HandJog(str(rng.choice(["left", "right"])), frame, 0.12 * way, 0.3 * turn)
        held_down(rig, jogging, jog, float(rng.uniform(0.04, 1.5)))

    assert rig.loop.statistics.refused == 0
    assert jogging.handle.status is MotionStatus.RUNNING
