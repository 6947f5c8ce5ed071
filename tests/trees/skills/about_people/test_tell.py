"""What is told of somebody is what was seen; what was not seen is told as such."""

from dataclasses import replace

import pytest

from robots.fake.fake_world import person
from robots.scenes.scene_description import Region
from tests.trees.household_stage import run, said
from trees.events import Said
from trees.skills.about_people import TellTask
from trees.tasks import ObjectDescription

SEEN = ("raising left arm", "red shirt", "black trousers", "sitting")
ANA, BEN = person("Ana", (1.3, 0.5)), person("Ben", (1.4, -0.5))
PERSON = ObjectDescription("person")


@pytest.mark.parametrize(
    ("about", "words"),
    [
        ("name", "the name of the person is Ana"),
        ("pose", "Ana is sitting"),
        ("gesture", "Ana is raising the left arm"),
        ("clothes", "Ana wears black trousers and a red shirt"),
    ],
)
def test_what_was_seen_of_somebody_is_told(stage_with, about, words):
    tree = run(stage_with(replace(ANA, traits=SEEN)), TellTask("tell", about, PERSON))

    assert tree.evidence["said"] == words
    assert tree.evidence["known"]


@pytest.mark.parametrize(
    ("about", "words"),
    [
        ("pose", "I cannot tell whether Ana is sitting or standing"),
        ("gesture", "I cannot tell what Ana does"),
        ("clothes", "I cannot tell what Ana wears"),
    ],
)
def test_what_was_not_seen_is_not_made_up(stage_with, about, words):
    tree = run(stage_with(ANA), TellTask("tell", about, PERSON))

    assert tree.evidence["said"] == words
    assert not tree.evidence["known"]


def test_who_was_seen_with_the_arms_at_rest_makes_no_gesture(stage_with):
    tree = run(stage_with(replace(ANA, traits=("standing",))), TellTask("tell", "gesture", PERSON))

    assert tree.evidence["said"] == "I see Ana make no gesture"


def test_somebody_without_a_known_name_is_told_so(stage_with):
    stranger = replace(ANA, name="person", traits=("standing",))

    tree = run(stage_with(stranger), TellTask("tell", "name", PERSON))

    assert tree.evidence["said"] == "I do not know the name of the person"


def test_a_trait_that_one_look_leaves_out_is_told_from_another(stage_with):
    stage = stage_with(replace(ANA, traits=("red shirt", "sitting")))
    stage.when("look again", lambda: stage.fake.world.put(replace(ANA, traits=())))

    run(stage, TellTask("tell", "clothes", PERSON))

    assert said(stage) == ["Ana wears a red shirt"]


def test_of_several_people_in_a_room_somebody_says_which(stage_with):
    stage = stage_with(ANA, BEN)
    stage.toolbox = replace(stage.toolbox, places={"hall": Region("hall", (1.3, 0.0), (2.0, 3.0))})

    tree = run(stage, TellTask("tell", "name", PERSON, "hall"))

    assert set(tree.failure.choice_names) == {"Ana", "Ben"}
    assert tree.failure.choice_slot == "of"


def test_it_is_told_to_whom_it_is_for(stage_with):
    stage = stage_with(replace(ANA, traits=("sitting",)), BEN)

    run(stage, TellTask("tell Ben", "pose", ObjectDescription("person", traits=("sitting",)), person="Ben"))

    assert [(e.text, e.to) for e in stage.events if isinstance(e, Said)] == [("Ana is sitting", "Ben")]


def test_what_is_told_of_nobody_is_named(stage_with):
    tree = run(stage_with(ANA), TellTask("tell", "age", PERSON))

    assert "nothing is told of people as 'age', only name, pose, gesture and clothes" in tree.failure.message
