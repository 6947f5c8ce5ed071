"""The loop on the simulated robot: it stands, moves its arms, is stopped, and goes on standing."""

from types import SimpleNamespace

import numpy as np
import pytest

from kinematics.checking.trajectory_checker import TrajectoryChecker
from kinematics.geometry import poses
from kinematics.motion.verdict import CheckedTrajectory
from kinematics.scene.planning_scene import PlanningScene
from robots.clock import ManualClock
from robots.control.loop.control_loop import ControlLoop
from robots.control.motion_handle import MotionStatus
from robots.interface.hardware import RobotData
from robots.models.description import load_robot
from robots.scenes.scene_description import SceneDescription
from robots.simulated.world import build_world

HARDWARE = load_robot("talos").hardware


@pytest.fixture
def standing(talos):
    """A robot on an empty floor."""

    def make(seed=0):
        world = build_world(
            RobotData(talos.description, HARDWARE),
            SceneDescription("floor"),
            np.random.default_rng(seed),
        )
        clock, events = ManualClock(), []
        loop = ControlLoop(world.robot, talos, clock, events.append)
        return SimpleNamespace(world=world, truth=world.truth, loop=loop, events=events, model=talos)

    return make


def run(rig, seconds, each=None):
    for k in range(round(seconds / 0.002)):
        rig.loop.step()
        if each is not None and k % 10 == 0:
            each()


def estimation_error(rig):
    true = poses.inverse(rig.truth.world_T_odom()) @ rig.truth.world_T_base()
    q = rig.loop.sensing.state().q
    return (
        float(np.linalg.norm(q[:3] - true[:3, 3])),
        poses.angle_between(true[:3, :3], poses.rotation_from_quaternion(q[3:7])),
    )


def waving(rig, motions):
    """Both arms and the waist, proven by the checker itself."""
    plan = motions.arms(rig.loop.motion.reference(), amount=0.6, duration_s=1.6).trajectory
    checked = TrajectoryChecker(rig.model).check(plan, PlanningScene())
    assert isinstance(checked, CheckedTrajectory), checked
    return checked


@pytest.mark.requirement("M1")
def test_it_stands_for_ten_seconds_without_drifting(standing):
    rig = standing()
    start, drift, errors = rig.truth.com()[:2].copy(), [], []

    def watch():
        drift.append(np.abs(rig.truth.com()[:2] - start).max())
        errors.append(estimation_error(rig))

    run(rig, 10.0, watch)

    assert max(drift) < 0.002
    assert np.max(errors, axis=0)[0] < 0.002
    assert np.max(errors, axis=0)[1] < 0.002
    assert rig.loop.statistics.refused == 0
    assert not rig.truth.fallen()


@pytest.mark.requirement("M1")
def test_waving_both_arms_it_keeps_its_balance_and_knows_where_its_base_is(standing, motions):
    rig = standing()
    handle = rig.loop.motion.start(waving(rig, motions))
    errors, tracking, margins = [], [], []

    def watch():
        errors.append(estimation_error(rig))
        measured = rig.loop.sensing.state().readings.q[:30]
        tracking.append(np.abs(measured - rig.loop.motion.reference()[7:]).max())
        margins.append(rig.truth.com_margin_m())

    run(rig, 2.0, watch)

    assert handle.status is MotionStatus.DONE
    assert np.max(errors, axis=0)[0] < 0.002
    assert np.max(errors, axis=0)[1] < 0.002
    assert max(tracking) < 0.003
    assert min(margins) > 0.06
    assert rig.loop.statistics.refused == 0


@pytest.mark.requirement("S1", "S7")
@pytest.mark.parametrize("how", ["cancel", 1, 2, "refusal"])
def test_stopped_in_full_swing_it_comes_to_rest_and_goes_on_standing(standing, motions, how):
    rig = standing()
    checked = waving(rig, motions)
    if how == "refusal":
        v = checked.trajectory.v.copy()
        v[90, 6 + rig.model.joint_index("arm_left_2_joint")] += 0.2
        plan = checked.trajectory
        checked = motions.sealed(type(plan)(plan.joints, plan.stance, plan.t_s, plan.q, v))
    handle = rig.loop.motion.start(checked)
    run(rig, 0.8)
    if how == "cancel":
        rig.loop.motion.cancel(handle, "enough")
    elif how != "refusal":
        rig.loop.stop(how, "a person wants it")
    run(rig, 1.5)

    assert handle.status is (MotionStatus.REFUSED if how == "refusal" else MotionStatus.CANCELED)
    assert np.abs(rig.loop.sensing.state().readings.v).max() < 0.05
    assert rig.truth.com_margin_m() > 0.06
    assert not rig.truth.fallen()


def test_the_same_seed_gives_the_same_bytes(standing, motions):
    def bytes_of_a_run():
        rig = standing(seed=7)
        rig.loop.motion.start(waving(rig, motions))
        rig.loop.grippers["left"].close()
        run(rig, 0.6)
        state = rig.loop.sensing.state()
        return state.q.tobytes() + state.readings.effort.tobytes() + state.readings.foot_wrench.tobytes()

    assert bytes_of_a_run() == bytes_of_a_run()


@pytest.mark.parametrize("hand", ["left", "right"])
def test_an_empty_hand_closes_and_opens_without_a_false_hold(standing, hand):
    rig = standing()
    gripper = rig.loop.grippers[hand]
    handle = gripper.close()
    held = []
    run(rig, 1.5, lambda: held.append(gripper.reading().holding))

    assert handle.status is MotionStatus.DONE
    assert not any(held)
    assert gripper.reading().opening_m < 0.002
    handle = gripper.open()
    run(rig, 1.2)
    assert handle.status is MotionStatus.DONE
    assert gripper.reading().opening_m > 0.09
    assert rig.loop.statistics.refused == 0


def test_a_hand_opens_no_wider_than_it_is_told(standing):
    rig = standing()
    gripper = rig.loop.grippers["left"]
    gripper.close()
    run(rig, 1.5)
    handle = gripper.open(0.04)
    run(rig, 1.2)

    assert handle.status is MotionStatus.DONE
    assert gripper.reading().opening_m == pytest.approx(0.04, abs=0.004)
