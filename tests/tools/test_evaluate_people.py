"""Random episodes with people who walk, such as a robot can follow and lead."""

import math

import pytest

from tools.evaluate.people import ways
from tools.evaluate.scenes import episode_rng
from tools.evaluate.skills.registry import SKILL_SUITES


@pytest.mark.parametrize("suite", ["follow", "follow_lost", "guide", "guide_left"])
def test_the_same_seed_makes_the_same_episode(suite):
    first, second = (SKILL_SUITES[suite].trial(episode_rng(3, 10)) for _ in range(2))

    assert first.tasks == second.tasks
    assert first.scene.people == second.scene.people


@pytest.mark.parametrize("seed", range(3))
def test_nobody_walks_into_the_robot_that_is_to_follow(seed):
    trial = SKILL_SUITES["follow"].trial(episode_rng(seed, 10))

    start = trial.scene.robot_start
    walker = next(one for one in trial.scene.people if one.name == trial.aim)
    assert all(math.dist((start.x_m, start.y_m), point) >= ways.AWAY_M for point in walker.way_m)


def test_who_turns_back_on_the_robot_is_not_walked_behind():
    robot, start = (0.0, 0.0), (1.5, 0.0)

    assert ways.is_walked_away(start, [(3.0, 0.0), (3.0, 2.0)], robot)
    assert not ways.is_walked_away(start, [(3.0, 0.0), (1.5, 0.2)], robot)
    assert not ways.is_walked_away(start, [(0.2, 0.5)], robot)


def test_who_is_led_comes_along_behind():
    trial = SKILL_SUITES["guide"].trial(episode_rng(1, 10))

    assert [one.follows for one in trial.scene.people if one.name == trial.aim] == [True]
