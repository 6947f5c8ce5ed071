"""Words that people use are known, and none of them leaves open what is meant."""

import pytest

from executive.understanding.command_parser import parse


@pytest.mark.parametrize(
    "thing", ["fish", "salad bowl", "nail clippers", "tongs", "bunch of flowers", "dentures"]
)
def test_a_thing_is_one_thing(thing):
    tasks = parse(f"bring me the {thing}").to_json()["tasks"]

    assert [task["action"] for task in tasks] == ["pick", "hand_over"]
    assert "count" not in tasks[0]


def test_two_fish_are_counted():
    assert parse("pick up two fish").to_json()["tasks"][0]["count"] == 2


@pytest.mark.parametrize("name", ["Taylor", "Jürgen", "Priyanka", "Siobhan", "Megan"])
def test_a_name_keeps_its_writing(name):
    assert parse(f"wave to {name}").to_json()["tasks"] == [{"action": "wave", "person": name}]


@pytest.mark.parametrize("room", ["family room", "nurses' station", "packing station", "waiting area"])
def test_a_room_is_a_place_to_go(room):
    assert parse(f"go to the {room}").to_json()["tasks"] == [{"action": "walk_to", "to": room}]
