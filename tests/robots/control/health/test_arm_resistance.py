"""On the simulated body: what jams in an arm is stuck, what presses on the hand is a touch."""

import numpy as np
import pytest

from robots.clock import ManualClock
from robots.control.control_loop import ControlLoop
from robots.control.events import HealthChanged
from robots.control.motion_handle import MotionStatus
from robots.scene_description import SceneDescription
from robots.simulated.world import build_world

PERIOD_S = 0.002


class Standing:
    """A robot on a bare floor."""

    def __init__(self, model):
        scene = SceneDescription("floor")
        self.world = build_world(model.description, scene, np.random.default_rng(3))
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
