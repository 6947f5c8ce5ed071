"""People of a scene who take what is offered, and those who do not."""

import math

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.geometry.shapes import Cylinder
from robots.models.description import load_robot
from robots.scenes.scene_description import Furniture, Person, SceneDescription, SceneItem
from robots.simulated.body.person_model import hand_body
from robots.simulated.world import build_world

PERIOD_S = 0.002


def can(place_m):
    pose = poses.translation(*place_m, 0.955)
    return SceneItem("blue can", "can", "blue", Cylinder(0.03, 0.11), 0.2, 0.7, pose)


def world_with(*people, more=()):
    top = Furniture("table", "table", (0.3, 0.3, 0.9), (0.8, -0.2))
    place = poses.translation(0.72, -0.2, 0.955)
    cup = SceneItem("red cup", "cup", "red", Cylinder(0.03, 0.11), 0.2, 0.7, place)
    scene = SceneDescription("by a table", people=people, furniture=(top,), objects=(cup, *more))
    return build_world(load_robot("talos"), scene, np.random.default_rng(0))


def pass_time(world, seconds):
    for _ in range(round(seconds / PERIOD_S)):
        world.robot.advance(PERIOD_S)


@pytest.fixture
def offers(monkeypatch):
    """Lets a world believe that the robot holds the cup out."""

    def offer(world, to="Ana"):
        monkeypatch.setattr(world.truth.contacts, "in_pads_only", lambda: {"red cup": "right"})
        world.people.see_offer(to)

    return offer


def test_who_takes_things_carries_away_what_is_offered(offers):
    world = world_with(Person("Ben", (2.4, 1.5), math.pi), Person("Ana", (1.2, -0.2), math.pi, takes=True))
    before = world.truth.world_T_object("red cup")[:3, 3]

    offers(world)
    pass_time(world, 5.0)

    assert any(name.startswith("Ana/") for name in world.truth.contacts.of_object("red cup"))
    assert world.truth.world_T_object("red cup")[0, 3] > before[0] + 0.15


@pytest.mark.parametrize("yaw_rad", [0.0, 1.6, -2.0])
def test_who_looks_elsewhere_turns_to_what_is_offered(offers, yaw_rad):
    world = world_with(Person("Ana", (1.2, -0.2), yaw_rad, takes=True))
    before = world.truth.world_T_object("red cup")[:3, 3]

    offers(world)
    pass_time(world, 7.0)

    assert any(name.startswith("Ana/") for name in world.truth.contacts.of_object("red cup"))
    assert world.truth.world_T_object("red cup")[0, 3] > before[0] + 0.15
    hand = world.physics.data.body(hand_body("Ana")).xmat.reshape(3, 3)
    assert hand[0, 0] == pytest.approx(-1.0, abs=0.02)  # the forearm points at the cup


@pytest.mark.parametrize(("to", "taker"), [("Ana", "Ana"), ("Ben", "Ben"), ("Zoe", "Ben"), ("person", "Ben")])
def test_whom_it_is_for_takes_it_else_who_is_nearest(offers, to, taker):
    world = world_with(
        Person("Ana", (1.2, -0.6), math.pi, takes=True),
        Person("Ben", (1.2, 0.0), math.pi, takes=True),
        Person("Zoe", (1.4, 0.7), math.pi),
    )

    offers(world, to)

    assert [person.name for person in world.people._people if person.offered] == [taker]


def test_who_has_something_lays_it_aside_for_the_next_thing(monkeypatch):
    world = world_with(Person("Ana", (1.2, -0.2), math.pi, takes=True), more=(can((0.72, -0.08)),))
    for thing in ("red cup", "blue can"):
        monkeypatch.setattr(world.truth.contacts, "in_pads_only", lambda thing=thing: {thing: "right"})
        world.people.see_offer("Ana")
        pass_time(world, 5.0 if thing == "red cup" else 12.0)

    assert any(name.startswith("Ana/") for name in world.truth.contacts.of_object("blue can"))
    assert not any(name.startswith("Ana/") for name in world.truth.contacts.of_object("red cup"))
    assert world.truth.world_T_object("red cup")[0, 3] > 1.3  # behind Ana
    assert world.truth.world_T_object("red cup")[2, 3] < 0.08


def test_who_does_not_take_things_leaves_it_where_it_is(offers):
    world = world_with(Person("Ana", (1.2, -0.2), math.pi))

    offers(world)
    pass_time(world, 1.0)

    assert world.truth.contacts.of_object("red cup") == ("table/top",)


def test_nobody_reaches_out_where_nothing_is_held():
    world = world_with(Person("Ana", (1.2, -0.2), math.pi, takes=True))

    world.people.see_offer("Ana")
    pass_time(world, 1.0)

    assert world.truth.contacts.of_object("red cup") == ("table/top",)
