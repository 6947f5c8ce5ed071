"""On the simulated body: what jams in an arm is stuck, what presses on the hand is a touch."""

import numpy as np
import pytest

from robots.clock import ManualClock
from robots.control.events import HealthChanged
from robots.control.health.arm_resistance import ArmResistance
from robots.control.loop.control_loop import ControlLoop
from robots.control.motion_handle import MotionStatus
from robots.interface.hardware import RobotData
from robots.interface.robot import JointSetpoint, RobotState
from robots.models.description import load_robot
from robots.scenes.scene_description import SceneDescription
from robots.simulated.world import build_world

HARDWARE = load_robot("talos").hardware

PERIOD_S = 0.002


class Standing:
    """A robot on a bare floor."""

    def __init__(self, model):
        scene = SceneDescription("floor")
        self.world = build_world(RobotData(model.description, HARDWARE), scene, np.random.default_rng(3))
        self.events = []
        self.loop = ControlLoop(self.world.robot, model, ManualClock(), self.events.append)
        self.run(0.3)

    def run(self, seconds):
        for _ in range(round(seconds / PERIOD_S)):
            self.loop.step()

    def found(self):
        return [(e.ailment, e.part) for e in self.events if isinstance(e, HealthChanged) and e.present]

    def press(self, force_n, seconds):
        """Push the right hand between its fingers, harder and harder, and leave it at that."""
        physics, truth = self.world.physics, self.world.truth
        body = physics.body_id("arm_right_7_link")
        for k in range(round(seconds / PERIOD_S)):
            force = np.asarray(force_n) * min(1.0, k * PERIOD_S / seconds)
            lever = truth.world_T_tcp("right")[:3, 3] - physics.data.xipos[body]
            physics.data.xfrc_applied[body] = (*force, *np.cross(lever, force))
            self.loop.step()


@pytest.fixture
def standing(talos):
    return Standing(talos)


@pytest.mark.requirement("F5")
@pytest.mark.parametrize(
    ("joint", "way_rad"),
    [("arm_right_1_joint", -0.15), ("arm_right_4_joint", 0.1), ("arm_left_6_joint", 0.15)],
)
def test_a_jammed_joint_of_an_arm_ends_its_motion_as_stuck(standing, motions, joint, way_rad):
    standing.world.body_faults.jam(joint)
    handle = standing.loop.motion.start(motions.joint(standing.loop.motion.reference(), joint, way_rad))
    standing.run(1.5)

    assert standing.found() == [("joint stuck", joint)]
    assert handle.status is not MotionStatus.DONE
    assert any("joint stuck" in reason for reason in standing.loop.defects)


@pytest.mark.requirement("F5")
@pytest.mark.parametrize("force_n", [(0.0, 0.0, 45.0), (0.0, 40.0, 20.0), (-42.0, 0.0, -53.0)], ids=str)
def test_a_hand_that_something_presses_is_not_stuck(standing, force_n):
    standing.press(force_n, 0.5)
    standing.run(1.0)

    assert standing.found() == []
    behind = np.abs(standing.loop.setpoint.q - standing.loop.sensing.state().readings.q)
    assert behind.max() > 0.02  # a joint that nothing presses would count as stuck


SHOULDER = "arm_right_2_joint"


def at_a_wedged_cup(talos):
    """Torques of the right arm that was stopped by a cup which did not give way (`question`, seed 620032)."""
    torques = np.zeros(len(talos.joints))
    torques[talos.group("right_arm")] = 2.27, 13.61, 5.42, 3.48, -0.77, 1.42, 0.16
    return torques


def stuck_joints(talos, torques):
    """What is found when joints that do not move come to give so much more than their motion needs."""
    resistance, n = (
        ArmResistance(talos, HARDWARE, PERIOD_S),
        len(talos.description.actuated),
    )
    q, still, found = np.zeros(n), np.zeros(n), []
    q[: len(talos.joints)] = talos.q_home[7:]
    q[talos.group("right_arm")] = 0.545, -0.79, 0.016, -0.806, -0.346, 0.733, 0.67
    for k in range(300):
        effort = np.zeros(n)
        effort[: len(torques)] = torques * min(1.0, k / 100)
        state = RobotState(k * PERIOD_S, q, still, effort, np.zeros(3), np.zeros(3), np.zeros((2, 6)))
        ahead = JointSetpoint(k * PERIOD_S, k, "it", q + 0.005 * np.sign(effort), still, still)
        found += resistance.judge(state, ahead)
    return {finding.part for finding in found}


@pytest.mark.requirement("F5")
def test_a_hand_at_what_does_not_give_way_is_not_stuck_though_one_joint_feels_nearly_all_of_it(talos):
    torques = at_a_wedged_cup(talos)
    alone = np.zeros_like(torques)
    shoulder = talos.joint_index(SHOULDER)
    alone[shoulder] = torques[shoulder]

    assert stuck_joints(talos, torques) == set()
    assert stuck_joints(talos, alone) == {SHOULDER}


WRIST = "arm_left_7_joint"
# What the left arm felt while a fingertip hit a cup, and 0.4 s later, when all but the wrist was back
# (`point_at`, seed 392020, from a time when arms were stretched over tables that nobody had looked at).
HIT = -12.6, -15.1, -21.5, 21.0, 1.9, -1.4, 9.8
AFTERWARDS = 2.0, 0.3, -1.6, 7.7, 0.3, 1.3, 7.7


def feel(resistance, talos, arm_nm, seconds):
    """Let the left arm feel torques beyond what its motion needs."""
    n = len(talos.description.actuated)
    q, still, effort = np.zeros(n), np.zeros(n), np.zeros(n)
    effort[talos.group("left_arm")] = arm_nm
    for k in range(round(seconds / PERIOD_S)):
        state = RobotState(k * PERIOD_S, q, still, effort, np.zeros(3), np.zeros(3), np.zeros((2, 6)))
        resistance.judge(state, JointSetpoint(k * PERIOD_S, k, "it", q, still, still))
        if k % 10 == 0:
            yield resistance.touched(WRIST, talos.q_home)


@pytest.mark.requirement("F5")
def test_a_wrist_that_was_bent_by_a_hit_is_not_stuck_though_the_rest_of_its_arm_is_back(talos):
    resistance = ArmResistance(talos, HARDWARE, PERIOD_S)

    assert list(feel(resistance, talos, HIT, 0.3))[-1]
    later = list(feel(resistance, talos, AFTERWARDS, 1.0))

    assert all(later[:20])
    assert not later[-1]


def test_a_wrist_that_nothing_has_hit_is_held_back_by_itself(talos):
    resistance = ArmResistance(talos, HARDWARE, PERIOD_S)

    assert not any(feel(resistance, talos, AFTERWARDS, 0.5))
