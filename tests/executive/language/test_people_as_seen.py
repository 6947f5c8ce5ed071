"""People are told from others by pose, gesture and clothes, in the words of a scene."""

import json

import pytest

from executive.understanding.command_parser import parse
from robots.scenes.scene_description import GESTURES, POSTURES


def tasks(text):
    return json.loads(json.dumps(parse(text).to_json()["tasks"]))


def person(*traits, **slots):
    return {"kind": "person", **slots, "traits": list(traits)}


@pytest.mark.parametrize(
    ("said", "trait"),
    [
        ("the sitting person", "sitting"),
        ("a standing person", "standing"),
        ("the person who is lying", "lying"),
        ("the waving person", "waving"),
        ("a person waving", "waving"),
        ("the person raising their left arm", "raising left arm"),
        ("the person who is raising his right arm", "raising right arm"),
        ("the person pointing to the left", "pointing left"),
        ("the person pointing to the right", "pointing right"),
        ("the person wearing a red shirt", "red shirt"),
        ("the person in a blue t-shirt", "blue t shirt"),
        ("the person dressed in a grey T shirt", "gray t shirt"),
    ],
)
def test_somebody_is_told_by_what_is_seen(said, trait):
    assert tasks(f"walk to {said}") == [{"action": "walk_to", "to": person(trait)}]


def test_every_pose_and_gesture_of_a_scene_can_be_said():
    for trait in (*POSTURES, *GESTURES):
        said = trait.replace("left arm", "their left arm").replace("right arm", "their right arm")

        assert tasks(f"wave to the person who is {said}") == [{"action": "wave", "person": person(trait)}]


def test_several_things_may_be_seen_of_one():
    expected = [{"action": "wave", "person": person("sitting", "red shirt")}]

    assert tasks("wave to the sitting person wearing a red shirt") == expected


def test_where_somebody_is_may_be_said_behind_what_is_seen():
    told = person("waving", relation={"is": "in", "to": "kitchen"})

    assert tasks("hand the cup to the waving person in the kitchen") == [
        {"action": "hand_over", "object": {"kind": "cup"}, "to": told}
    ]
    assert tasks("say hello to the person in the red shirt at the desk") == [
        {
            "action": "greet",
            "person": person("red shirt", relation={"is": "next_to", "to": "desk"}),
        }
    ]


def test_how_somebody_is_somewhere_is_a_pose():
    told = person("sitting", relation={"is": "on", "to": "sofa"})

    assert tasks("wave to the person sitting on the sofa") == [{"action": "wave", "person": told}]
    assert tasks("wave to the person who is on the sofa") == [
        {"action": "wave", "person": {"kind": "person", "relation": {"is": "on", "to": "sofa"}}}
    ]


@pytest.mark.parametrize(
    ("said", "expected"),
    [
        ("find a waving person in the living room", {"person": person("waving"), "from": "living room"}),
        ("find people wearing blue jackets", {"person": person("blue jacket")}),
        ("find the people in blue jackets", {"person": person("blue jacket"), "count": "all"}),
    ],
)
def test_people_are_looked_for_by_what_is_seen(said, expected):
    assert tasks(said) == [{"action": "find", **expected}]


@pytest.mark.parametrize(
    ("said", "trait"),
    [
        ("how many sitting persons are in the kitchen", "sitting"),
        ("how many people are waving in the kitchen", "waving"),
        ("how many people in the kitchen are wearing red jackets", "red jacket"),
        ("count the persons raising their left arm in the kitchen", "raising left arm"),
    ],
)
def test_people_are_counted_by_what_is_seen(said, trait):
    assert tasks(said) == [{"action": "count", "object": person(trait), "from": "kitchen"}]


def test_how_many_are_standing_may_be_asked_without_a_place():
    assert tasks("how many people are standing") == [{"action": "count", "object": person("standing")}]


@pytest.mark.parametrize("said", ["wave to the person in a coat", "walk to the person wearing a shirt"])
def test_of_clothes_the_colour_is_asked_for(said):
    assert "of which colour" in parse(said).question.text


@pytest.mark.parametrize("said", ["find the waving cup", "look at the sitting dog", "take the lying bottle"])
def test_of_a_thing_no_pose_is_seen(said):
    assert parse(said).refusal is not None


def test_a_thing_in_clothes_is_in_them():
    shirt = {"kind": "shirt", "color": "red"}

    assert tasks("find the keys in the red shirt") == [
        {"action": "find", "object": {"kind": "keys"}, "from": shirt}
    ]


@pytest.mark.parametrize(
    "said",
    ["do not wave to the waving person", "if the person is waving, wave to them", "is the person sitting"],
)
def test_what_is_seen_makes_no_order(said):
    assert parse(said).outcome != "tasks"
