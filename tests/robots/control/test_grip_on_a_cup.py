"""The gripper control on a simulated cup: force without truth, and an honest answer when it is gone."""

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.geometry.shapes import Cylinder
from robots.clock import ManualClock
from robots.control.loop.control_loop import ControlLoop
from robots.control.motion_handle import MotionStatus
from robots.interface.hardware import RobotData
from robots.models.description import load_robot
from robots.scenes.scene_description import SceneDescription, SceneItem
from robots.simulated.world import build_world

HARDWARE = load_robot("talos").hardware


class Hold:
    """A cup kept in the air between the fingers until they have closed on it."""

    def __init__(self, model, radius_m, hand):
        cup = SceneItem(
            "cup", "cup", "red", Cylinder(radius_m, 0.11), 0.3, 0.6, poses.translation(3.0, 0.0, 0.055)
        )
        self.world = build_world(
            RobotData(model.description, HARDWARE),
            SceneDescription("hand", objects=(cup,)),
            np.random.default_rng(1),
        )
        self.loop = ControlLoop(self.world.robot, model, ManualClock(), lambda event: None)
        self.hand, self.gripper = hand, self.loop.grippers[hand]
        self.run(0.1)
        place = self.world.truth.world_T_tcp(hand).copy()
        handle = self.gripper.close()
        for _ in range(600):
            self.world.faults.teleport("cup", place)
            self.loop.step()
        assert handle.status is MotionStatus.DONE, handle.reason
        self.run(0.3)

    def run(self, seconds):
        for _ in range(round(seconds / 0.002)):
            self.loop.step()

    def place_in_hand(self):
        return self.world.truth.tcp_T_object(self.hand, "cup")[:3, 3].copy()


@pytest.mark.requirement("M1", "M2")
@pytest.mark.parametrize(("radius_m", "hand"), [(0.02, "left"), (0.03, "right"), (0.038, "left")])
def test_a_cup_is_held_with_the_described_effort_until_it_is_taken(talos, radius_m, hand):
    hold = Hold(talos, radius_m, hand)

    reading, before = hold.gripper.reading(), hold.place_in_hand()
    assert reading.holding
    assert reading.effort_nm == pytest.approx(HARDWARE.grips[hand].effort_nm, abs=0.1)
    assert reading.opening_m == pytest.approx(2.0 * radius_m, abs=0.004)
    hold.run(2.0)
    assert np.linalg.norm(hold.place_in_hand() - before) < 0.0005

    hold.world.faults.remove("cup")
    hold.run(0.1)
    assert not hold.gripper.reading().holding
    hold.run(0.4)
    assert hold.gripper.reading().opening_m < 0.02
    assert hold.loop.statistics.refused == 0
