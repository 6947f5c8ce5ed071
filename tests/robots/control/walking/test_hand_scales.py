"""What hangs on a hand is weighed, and is part of the balance."""

import numpy as np
import pytest

from kinematics.model.robot_model import RobotModel
from robots.clock import ManualClock
from robots.control.loop.control_loop import ControlLoop
from robots.control.walking.hand_scales import HandScales
from robots.interface.hardware import RobotData
from robots.models.description import load_description, load_robot
from robots.scenes.scene_description import RobotStart, SceneDescription
from robots.simulated.world import build_world

PERIOD_S = 0.002
TALOS = RobotModel(load_description("talos"))
HARDWARE = load_robot("talos").hardware


class Laden:
    """TALOS with a weight at its left TCP: a force, with no inertia."""

    def __init__(self, mass_kg):
        self.world = build_world(
            RobotData(TALOS.description, HARDWARE),
            SceneDescription("floor", RobotStart()),
            np.random.default_rng(3),
        )
        self.loop = ControlLoop(self.world.robot, TALOS, ManualClock(), lambda _event: None, PERIOD_S)
        self.mass_kg = mass_kg
        self.body = self.world.physics.body_id("gripper_left_base_link")

    def run(self, seconds, seen=lambda: None):
        data = self.world.physics.data
        for _ in range(round(seconds / PERIOD_S)):
            weight = np.array([0.0, 0.0, -9.81 * self.mass_kg])
            lever = self.world.truth.world_T_tcp("left")[:3, 3] - data.xipos[self.body]
            data.xfrc_applied[self.body, :3] = weight
            data.xfrc_applied[self.body, 3:] = np.cross(lever, weight)
            self.loop.step()
            seen()


@pytest.mark.parametrize("mass_kg", [0.0, 3.0])
def test_a_weight_is_found_on_the_hand_that_bears_it(mass_kg):
    laden = Laden(mass_kg)
    scales = HandScales(TALOS, PERIOD_S)
    bodies = len(TALOS.joints)

    laden.run(1.0)
    laden.run(0.6, lambda: scales.sense(laden.loop.sensing.state().readings.effort[:bodies]))

    masses = scales.masses_kg(laden.loop.motion.reference())
    assert set(masses) == ({"left"} if mass_kg else set())
    assert masses.get("left", 0.0) == pytest.approx(mass_kg, abs=0.3)


def test_a_carried_mass_moves_the_com_towards_the_hand():
    laden = TALOS.carrying({"left": 3.0})
    hand = TALOS.frame_pose(TALOS.q_home, TALOS.description.tcp_frames["left"])[:3, 3]

    share = 3.0 / (TALOS.mass_kg + 3.0)
    assert laden.mass_kg == pytest.approx(TALOS.mass_kg + 3.0)
    assert laden.com(TALOS.q_home) == pytest.approx(
        (1.0 - share) * TALOS.com(TALOS.q_home) + share * hand, abs=1e-9
    )


def test_empty_hands_leave_the_model_as_it_is():
    assert TALOS.carrying({}) is TALOS
