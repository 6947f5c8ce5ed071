"""People who walk along a way of their own."""

import math

import numpy as np
import pytest

from kinematics.geometry.shapes import Cylinder
from robots.errors import SceneError
from robots.models.description import load_robot
from robots.scenes.scene_description import Person, SceneDescription
from robots.scenes.scene_file import read_scene
from robots.scenes.scene_writer import dump
from robots.simulated.people.walking_people import standing_at
from robots.simulated.world import build_world

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


def world_with(*people):
    scene = SceneDescription("a room", people=people)
    return build_world(load_robot("talos"), scene, np.random.default_rng(0))


def place_of(world, name):
    return next(one for one in world.truth.solids() if one.name == name).world_T_object[:3, 3]


def test_a_body_is_where_its_way_has_led_and_is_seen_there():
    world = world_with(Person("Ana", (2.0, 1.0), 0.0, way_m=((3.0, 1.0),), speed_m_s=0.5))

    for _ in range(500):
        world.robot.advance(0.002)

    assert place_of(world, "Ana") == pytest.approx((2.5, 1.0, 0.875), abs=0.01)


@pytest.mark.parametrize(("posture", "height_m"), [("standing", 1.75), ("sitting", 1.30), ("lying", 0.34)])
def test_the_solid_of_a_person_holds_the_whole_body_in_every_posture(posture, height_m):
    world = world_with(Person("Ana", (2.0, 0.0), 0.3, posture=posture))
    model, data = world.physics.model, world.physics.data
    seen = next(one for one in world.truth.solids() if one.name == "Ana")
    own_T_world = np.linalg.inv(seen.world_T_object)

    for geom in range(model.ngeom):
        name = model.geom(geom).name
        if not name.startswith("Ana/") or name.endswith(("pad", "palm")):
            continue
        axis = data.geom_xmat[geom].reshape(3, 3)[:, 2] * model.geom_size[geom][1]
        for end in (data.geom_xpos[geom] + axis, data.geom_xpos[geom] - axis):
            x, y, z = (own_T_world @ [*end, 1.0])[:3]
            out = model.geom_size[geom][0] - 0.02
            assert abs(z) + out <= 0.5 * height_m, name
            if isinstance(seen.shape, Cylinder):
                assert math.hypot(x, y) + out <= seen.shape.radius_m, name
            else:
                assert np.all(np.abs((x, y)) + out <= 0.5 * np.array(seen.shape.size_m[:2])), name

    assert seen.shape.height_m == height_m
