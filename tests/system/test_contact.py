"""What touches the hand unexpectedly ends the motion, not the robot's balance."""

import pytest

from tools.evaluate.episode import run_episode
from tools.evaluate.orders import EpisodeOrder


@pytest.mark.slow
@pytest.mark.requirement("M2", "M4")
def test_a_hand_that_comes_down_on_a_knocked_cup_stops_and_the_robot_stands():
    # in this episode the cup is pushed by 4 cm, out of sight under the hand; without the contact
    # watch the arm presses on it until the robot tips over
    record = run_episode(EpisodeOrder(422, fault="knocked"))

    assert record.fault_fired
    assert not record.fell
    assert record.outcome == "done"
    assert record.truth
