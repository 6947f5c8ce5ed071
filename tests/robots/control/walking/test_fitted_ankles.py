"""Legs that stay as the floor has turned their ankles."""

import numpy as np
import pytest

from kinematics.model.robot_model import RobotModel
from kinematics.walking.pattern.pattern_sample import Phase
from robots.control.motion_handle import MotionStatus
from robots.control.walking.fitted_ankles import FittedAnkles
from robots.models.description import load_description
from tools.evaluate.disturbed.bare_walk import BareWalk
from tools.evaluate.disturbed.rough import scattered_plates
from tools.evaluate.scenes import episode_rng

PERIOD_S = 0.002


@pytest.fixture(scope="module")
def model():
    return RobotModel(load_description("talos"))


class Ending:
    """The end of a walk on a floor that turns an ankle."""

    def __init__(self, model, turned_rad, offset_rad=None):
        n = len(model.joints)
        self.ankle = model.joint_index(model.description.groups["left_leg"][4])
        self.told = np.zeros(n)
        self.felt = np.zeros(n)
        self.felt[self.ankle] = turned_rad
        self.ankles = FittedAnkles(model, np.zeros(n) if offset_rad is None else offset_rad, PERIOD_S)

    def go_on(self, phase, seconds):
        """Positions and velocities that were told, shape (periods, n) each."""
        found = []
        for _ in range(round(seconds / PERIOD_S)):
            self.ankles.follow(phase, self.told, self.felt)
            q, v = self.told.copy(), np.zeros(len(self.told))
            self.ankles.add_to(q, v)
            found.append((q, v))
        q, v = zip(*found, strict=True)
        return np.array(q), np.array(v)


def test_a_turned_ankle_is_told_to_stay_as_it_is(model):
    ending = Ending(model, 0.06)

    q, _ = ending.go_on(Phase.CLOSE, 0.6)

    assert q[-1, ending.ankle] == pytest.approx(0.06, abs=0.009)
    assert np.count_nonzero(q[-1]) == 1


def test_what_is_fitted_is_kept_while_the_ankle_follows_what_it_is_told(model):
    ending = Ending(model, 0.06)
    q, _ = ending.go_on(Phase.CLOSE, 0.4)

    for _ in range(20):  # an ankle that becomes stiff goes where it is told
        ending.felt[ending.ankle] = q[-1, ending.ankle]
        q, _ = ending.go_on(Phase.SETTLE, 0.03)

    assert q[-1, ending.ankle] > 0.05


def test_an_ankle_on_a_level_floor_is_told_the_plan(model):
    ending = Ending(model, 0.006)

    q, v = ending.go_on(Phase.CLOSE, 0.6)

    assert not q.any()
    assert not v.any()


def test_it_stays_fitted_at_rest_and_gives_way_to_the_next_walk(model):
    ending = Ending(model, 0.06)
    ending.go_on(Phase.CLOSE, 0.6)

    rest, _ = ending.go_on(Phase.REST, 0.2)
    assert ending.ankles.at_rest
    assert rest[-1, ending.ankle] > 0.05

    walking, _ = ending.go_on(Phase.SHIFT, 0.7)
    assert abs(walking[-1, ending.ankle]) < 1e-3


def test_positions_are_where_the_velocities_lead(model):
    ending = Ending(model, 0.06)
    q, v = (
        np.vstack(parts)
        for parts in zip(
            ending.go_on(Phase.CLOSE, 0.3),
            ending.go_on(Phase.REST, 0.1),
            ending.go_on(Phase.SWING, 0.3),
            strict=True,
        )
    )

    led = q[:-1] + 0.5 * PERIOD_S * (v[1:] + v[:-1])
    np.testing.assert_allclose(q[1:], led, atol=1e-12)
    assert np.abs(np.diff(v, axis=0)).max() / PERIOD_S < 8.1


def test_it_begins_where_the_robot_stands(model):
    offset = np.zeros(len(model.joints))
    offset[model.joint_index(model.description.groups["right_leg"][5])] = 0.04

    q, _ = Ending(model, 0.0, offset).go_on(Phase.SHIFT, PERIOD_S)

    np.testing.assert_allclose(q[0], offset, atol=1e-4)


@pytest.mark.requirement("M6")
def test_a_robot_that_stands_on_the_edge_of_a_plate_stays_there_and_walks_on():
    rng = episode_rng(11, 21)
    linear, angular = float(rng.uniform(-0.3, 0.5)), float(rng.uniform(-0.5, 0.5))
    body = BareWalk("talos", 11, scattered_plates(rng))
    body.go_on(0.4)

    first = body.set_out(linear, angular)
    body.go_on(2.5)
    assert body.stands_again(first)
    tilts = [np.arccos(min(float(pose[2, 2]), 1.0)) for _, pose in body.loop.motion.stance().soles]
    assert max(tilts) > 0.01

    second = body.set_out(-linear, angular)
    body.go_on(1.5)
    assert second.status is MotionStatus.RUNNING
    assert body.loop.statistics.refused == 0
    assert not body.world.truth.fallen()
