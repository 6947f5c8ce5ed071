"""The fake's yielding hand follows its path to the end, and says when it has lost what it held."""

import numpy as np
import pytest

from kinematics.scene.opening_path import DoorArc
from kinematics.scene.planning_scene import PlanningScene
from robots.control.hands.yield_order import YieldOrder


@pytest.fixture
def lead(fake, model):
    """Leads the left hand from where it is along a door's arc."""
    frame = model.description.tcp_frames["left"]
    at = model.frame_pose(fake.motion.reference(), frame)[:3, 3]
    hinge = np.array([at[0], at[1] + 0.5])
    arc = DoorArc(hinge, 0.0, 1.0, 0.5, 0.0, float(at[2]))

    def to(s, holding):
        order = YieldOrder("left", PlanningScene(), (), arc, 0.0, s, holding=holding)
        return fake.yielding.start(order)

    return to


def test_it_arrives_at_the_end_of_the_path(fake, model, lead, play):
    moving = lead(0.3, holding=False)

    play(moving.handle)

    tcp = model.frame_pose(fake.motion.reference(), model.description.tcp_frames["left"])
    assert moving.report.outcome == "arrived"
    np.testing.assert_allclose(tcp[:3, 3], moving.order.path.at(0.3).position_m, atol=0.02)


def test_a_hand_that_holds_nothing_has_lost_it(lead, play):
    moving = lead(0.3, holding=True)

    play(moving.handle)

    assert moving.report.outcome == "lost"
