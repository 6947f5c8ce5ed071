"""What is done for people, on the robot that balances on its own feet, judged by the simulator's truth."""

import pytest

from tools.evaluate.orders import EpisodeOrder
from tools.evaluate.skills.episode import run_skill_episode


@pytest.mark.requirement("L12")
@pytest.mark.parametrize("suite", ["greet", "follow"])
def test_somebody_is_truly_greeted_and_followed(suite):
    record = run_skill_episode(suite, EpisodeOrder(0))

    assert record.claimed, record.failure
    assert record.truth
    assert not record.fell
    assert not record.furniture_contacts
