"""What is worked out late is as it was."""

import numpy as np
import pytest

from kinematics.requests.move import MoveRequest
from kinematics.scene.planning_scene import PlanningScene
from robots.fake.fake_sensing import FakeSensing


@pytest.fixture
def two_that_move(fake, fake_again):
    """Two of the same robot, in the same motion of the right arm."""
    joints = {"arm_right_1_joint": 0.3, "arm_right_2_joint": -0.6}
    for one in (fake, fake_again):
        move = MoveRequest(one.motion.reference(), one.motion.stance(), PlanningScene(), joints)
        step = one.planning.answer(move).step
        one.motion.start(one.planning.verdict(step.question))
    return fake, fake_again


def test_what_is_asked_for_late_is_what_was_felt_then(two_that_move):
    at_once, late = two_that_move
    felt = []
    for _ in range(6):
        at_once.step()
        late.step()
        felt.append(at_once.sensing.state())

    for state in felt:
        then = late.sensing.state_at(state.readings.stamp_s)
        np.testing.assert_array_equal(then.q, state.q)
        np.testing.assert_array_equal(then.readings.effort, state.readings.effort)
    assert not np.array_equal(felt[0].readings.effort, felt[-1].readings.effort)


def test_a_pull_that_is_over_was_felt_while_it_lasted(fake):
    fake.pull_n.update(right=(6.0, 0.0, 0.0))
    fake.step()
    pulled_s = fake.clock.now_s()
    fake.pull_n.clear()
    fake.step()

    during, after = fake.sensing.state_at(pulled_s), fake.sensing.state()

    assert np.abs(during.readings.effort - after.readings.effort).max() > 1.0


def test_the_state_nearest_to_a_time_is_found_among_those_that_are_kept():
    states = [object() for _ in range(150)]
    sensing = FakeSensing(0.0, lambda: states[0], 0.02)
    for k in range(1, 150):
        sensing.add(0.02 * k, lambda k=k: states[k])

    assert sensing.state() is states[149]
    assert sensing.state_at(2.4 + 0.009) is states[120]
    assert sensing.state_at(0.0) is states[50]  # the oldest of two seconds
