"""People who walk along a way of their own."""

import math

import pytest

from robots.errors import SceneError
from robots.scenes.scene_description import Person
from robots.scenes.scene_file import read_scene
from robots.scenes.scene_writer import dump
from robots.simulated.people.walking_people import standing_at

ANA = Person("Ana", (1.0, 0.0), 0.0, way_m=((2.0, 0.0), (2.0, 1.0)), speed_m_s=0.5, starts_s=1.0)


@pytest.mark.parametrize(
    ("now_s", "x_m", "y_m", "yaw_rad"),
    [
        (0.0, 1.0, 0.0, 0.0),
        (2.0, 1.5, 0.0, 0.0),
        (3.0, 2.0, 0.0, 0.0),
        (4.0, 2.0, 0.5, math.pi / 2),
        (60.0, 2.0, 1.0, math.pi / 2),
    ],
)
def test_a_person_walks_from_point_to_point_and_stays_at_the_last(now_s, x_m, y_m, yaw_rad):
    at = standing_at(ANA, now_s)

    assert (at.x_m, at.y_m, at.yaw_rad) == pytest.approx((x_m, y_m, yaw_rad))


SCENE = """
[[person]]
name = "Ana"
position_m = [2.0, 1.0]
posture = "sitting"
gesture = "waving"
clothes = ["red shirt", "blue jeans"]

[[person]]
name = "Ben"
position_m = [2.0, -1.0]
way_m = [[3.0, -1.0]]
speed_m_s = 0.3
starts_s = 2.0
"""


def test_what_people_do_and_wear_is_read_and_written():
    scene = read_scene(SCENE, "a.toml", "a")

    assert scene.people[0].clothes == ("red shirt", "blue jeans")
    assert read_scene(dump(scene), "b.toml", "a").people == scene.people


@pytest.mark.parametrize(
    ("old", "new", "reason"),
    [
        ('"sitting"', '"siting"', "sitting"),
        ('"waving"', '"wave"', "waving"),
        ('"red shirt"', '"rot shirt"', "a colour and a piece of clothing"),
        ("speed_m_s = 0.3", "speed_m_s = 9.0", "at most 2 m/s"),
        ("way_m = [[3.0, -1.0]]", "way_m = [3.0]", "a list of places"),
    ],
)
def test_what_nobody_can_be_or_do_is_told(old, new, reason):
    with pytest.raises(SceneError, match=reason):
        read_scene(SCENE.replace(old, new), "a.toml", "a")
