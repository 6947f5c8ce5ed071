"""What nobody has seen is felt by the arm that meets it: it stops, says so, and the way back is free."""

from __future__ import annotations

import numpy as np
import pytest

from kinematics.following.jog_reference import HandJog
from kinematics.model.robot_model import RobotModel
from kinematics.scene.planning_scene import PlanningScene
from robots.clock import ManualClock
from robots.control.loop.control_loop import ControlLoop
from robots.models.description import load_robot
from robots.scenes.scene_description import Furniture, RobotStart, SceneDescription
from robots.simulated.world import build_world

PERIOD_S = 0.002
TOP_M = 1.2


class BesideATable:
    """TALOS at a table that its planning scene does not hold, jogged by keys held down."""

    def __init__(self):
        data = load_robot("talos")
        table = Furniture("table", "table", (0.5, 1.8, TOP_M), (0.58, 0.0))
        scene = SceneDescription("floor", RobotStart(), furniture=(table,))
        self.world = build_world(data, scene, np.random.default_rng(3))
        self.loop = ControlLoop(
            self.world.robot, RobotModel(data.description), ManualClock(), [].append, PERIOD_S
        )
        self.run(0.6)
        self.jogging = self.loop.jogging.start(PlanningScene())
        self.most_n = 0.0

    def run(self, seconds):
        for _ in range(round(seconds / PERIOD_S)):
            self.loop.step()

    def held_down(self, linear, seconds):
        said = set()
        for _ in range(round(seconds / 0.04)):
            self.jogging.steer(HandJog("right", "world", np.array(linear), np.zeros(3)))
            for _ in range(20):
                self.loop.step()
                self.most_n = max(self.most_n, self.pressed_n())
            said.add(self.jogging.report.held_back)
        return said

    def pressed_n(self):
        contacts = self.world.truth.contacts
        return sum(contact.force_n for contact in contacts.robot_with_furniture())

    @property
    def tcp_m(self):
        return self.world.truth.world_T_tcp("right")[:3, 3]


@pytest.fixture
def beside():
    return BesideATable()


@pytest.mark.requirement("S10")
def test_a_hand_that_meets_an_unseen_table_stops_and_says_so_and_the_opposite_key_leads_away(beside):
    beside.held_down((0.12, 0.0, 0.0), 0.8)
    said = beside.held_down((0.0, 0.0, -0.12), 1.4)
    pressed_n, low = beside.pressed_n(), beside.tcp_m[2]
    beside.held_down((0.0, 0.0, 0.12), 0.5)

    assert any("the right arm meets something that nobody saw" in one for one in said), said
    assert 1.0 < pressed_n < 15.0
    assert beside.most_n < 40.0
    assert beside.pressed_n() == 0.0
    assert beside.tcp_m[2] > low + 0.02
    assert beside.loop.defects == ()
    assert beside.loop.statistics.refused == 0
    assert not beside.world.truth.fallen()
