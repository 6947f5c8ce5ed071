"""Somebody who walks behind the robot."""

import math
from itertools import pairwise

import pytest

from robots.errors import SceneError
from robots.scenes.scene_description import Person
from robots.scenes.scene_file import read_scene
from robots.scenes.scene_writer import dump
from robots.simulated.people.trailing_person import BEHIND_M, TrailingPerson

PERIOD_S = 0.02


def follower(speed_m_s=0.8):
    return TrailingPerson(Person("Ana", (0.0, 0.0), 0.0, speed_m_s=speed_m_s, follows=True))


def led(person, *way, speed_m_s=0.4):
    """Walk the robot along some points; gives the least distance on the way."""
    least_m = math.inf
    for start, end in pairwise(way):
        count = math.ceil(math.dist(start, end) / (speed_m_s * PERIOD_S))
        for k in range(1, count + 1):
            share = k / count
            robot = tuple(a + share * (b - a) for a, b in zip(start, end, strict=True))
            person.tick(robot, PERIOD_S)
            least_m = min(least_m, math.dist(robot, (person.at.x_m, person.at.y_m)))
    return least_m


def test_a_person_who_has_not_met_the_robot_stays():
    ana = follower()

    led(ana, (4.0, 0.0), (6.0, 0.0))

    assert (ana.at.x_m, ana.at.y_m) == (0.0, 0.0)


def test_a_person_who_has_met_the_robot_walks_behind_it():
    ana = follower()

    least_m = led(ana, (1.0, 0.0), (5.0, 0.0))

    assert math.dist((5.0, 0.0), (ana.at.x_m, ana.at.y_m)) == pytest.approx(BEHIND_M, abs=0.05)
    assert least_m > 0.95


def test_a_person_goes_around_the_corner_that_the_robot_has_gone_around():
    ana = follower()

    led(ana, (1.0, 0.0), (3.0, 0.0), (3.0, 3.0))

    assert ana.at.x_m == pytest.approx(3.0, abs=0.02)


def test_a_slow_person_is_left_behind():
    ana = follower(speed_m_s=0.1)

    led(ana, (1.0, 0.0), (5.0, 0.0))

    assert math.dist((5.0, 0.0), (ana.at.x_m, ana.at.y_m)) > 3.0


def test_who_follows_is_read_and_written():
    scene = read_scene('[[person]]\nname = "Ana"\nposition_m = [2.0, 1.0]\nfollows = true\n', "a.toml", "a")

    assert scene.people[0].follows
    assert read_scene(dump(scene), "b.toml", "a").people == scene.people


def test_nobody_follows_who_goes_a_way():
    text = '[[person]]\nname = "Ana"\nposition_m = [2.0, 1.0]\nfollows = true\nway_m = [[3.0, 1.0]]\n'

    with pytest.raises(SceneError, match="say one of both"):
        read_scene(text, "a.toml", "a")
