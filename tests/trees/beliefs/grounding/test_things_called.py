"""Which things a word means: by name, kind and sort, and what only a person can say."""

import numpy as np
import pytest

from kinematics.geometry import poses
from kinematics.geometry.shapes import Box, Cylinder
from kinematics.scene.label import Label
from kinematics.scene.planning_scene import PlanningScene, SceneObject
from robots.perception.seen_label import SeenLabel
from trees.beliefs.grounding.destination import person_meant
from trees.beliefs.grounding.grounding import Ambiguous, Found, Missing, ground
from trees.beliefs.scene.believed_thing import surroundings
from trees.tasks import ObjectDescription

TABLE = SceneObject("table", Box((0.6, 1.2, 0.04)), poses.translation(0.65, 0.0, 0.88), movable=False)
SOUP = Label("can", "red", ("tomato soup",), ("food",))
BEANS = Label("can", "green", ("beans",), ("food",))
PLAIN = Label("can", "blue")


def around(held=(), **labels):
    things = [
        SceneObject(
            name.replace("_", " "),
            Cylinder(0.03, 0.1),
            poses.translation(0.5, 0.2 * i - 0.3, 0.95),
            label=label,
        )
        for i, (name, label) in enumerate(labels.items())
    ]
    scene = PlanningScene().with_objects([TABLE, *things])
    for name in held:
        scene = scene.with_attached(name, "tcp_left", np.eye(4), [])
    return surroundings(scene, poses.translation(0.0, 0.0, 1.0), 0.05)


@pytest.mark.parametrize(
    ("kind", "names"),
    [
        ("tomato soup", ("tomato soup",)),
        ("tomato soup can", ("tomato soup",)),
        ("soup", ("tomato soup",)),
        ("beans", ("beans",)),
    ],
)
def test_a_word_means_what_bears_it_among_others_of_its_kind(kind, names):
    things = around(tomato_soup=SOUP, beans=BEANS, blue_can=PLAIN)

    assert ground(ObjectDescription(kind), things) == Found(names)


def test_what_is_named_so_comes_before_what_is_of_that_sort():
    things = around(food=Label("box", "blue", ("food",)), tomato_soup=SOUP)

    assert ground(ObjectDescription("food"), things) == Found(("food",))


def test_the_only_thing_of_a_sort_is_meant_and_told():
    found = ground(ObjectDescription("food"), around(tomato_soup=SOUP, blue_can=PLAIN))

    assert found == Found(("tomato soup",), "the tomato soup is the only food that I see")


def test_of_several_of_a_sort_a_person_says_which():
    asked = ground(ObjectDescription("food"), around(tomato_soup=SOUP, beans=BEANS))

    assert isinstance(asked, Ambiguous)
    assert {choice.name for choice in asked.choices} == {"tomato soup", "beans"}


def test_all_of_a_sort_are_those_that_are_named_so_and_those_that_are_of_it():
    things = around(food=Label("box", "blue", ("food",)), tomato_soup=SOUP, blue_can=PLAIN)

    found = ground(ObjectDescription("food"), things, None, "all")

    assert set(found.names) == {"food", "tomato soup"}


def test_what_bears_only_the_last_word_is_asked_about_and_never_taken():
    asked = ground(ObjectDescription("paint can"), around(tomato_soup=SOUP))

    assert isinstance(asked, Ambiguous)
    assert asked.message == "I see no paint can, only the tomato soup: is that meant?"


def test_a_colour_is_what_is_seen_and_no_word_of_a_name():
    things = around(red_bull=Label("can", "blue", ("red bull",)))

    assert isinstance(ground(ObjectDescription("can", "red"), things), Missing)
    assert ground(ObjectDescription("can", "blue"), things) == Found(("red bull",))


def test_what_is_in_the_hand_is_found_there_by_its_name():
    answer = ground(ObjectDescription("soup"), around(held=["tomato soup"], tomato_soup=SOUP))

    assert answer == Missing("the tomato soup is in the hand")


def people(**traits):
    persons = [
        SceneObject(
            name,
            Cylinder(0.24, 1.75),
            poses.translation(2.0, 0.8 * i, 0.875),
            movable=False,
            label=Label(name, traits=told),
        )
        for i, (name, told) in enumerate(traits.items())
    ]
    scene = PlanningScene().with_objects([TABLE, *persons])
    return surroundings(scene, poses.translation(0.0, 0.0, 1.0), 0.05)


def test_somebody_is_meant_of_whom_all_is_seen_that_was_said():
    guests = people(Ana=("sitting", "red shirt"), Ben=("sitting", "waving"), Zoe=("standing", "red shirt"))

    wanted = ObjectDescription("person", traits=("sitting", "red shirt"))

    assert person_meant(wanted, guests) == Found(("Ana",))


def test_somebody_whom_nobody_is_like_is_not_taken_for_another():
    wanted = ObjectDescription("person", traits=("lying",))

    assert person_meant(wanted, people(Ana=("sitting",))) == Missing("no person who is lying seen", True)


LIKE_CUP = SeenLabel("can", "blue", alike=("cup",))
MAYBE_SOUP = SeenLabel("can", "blue", alike=("tomato soup",))


def test_what_looks_like_it_is_taken_and_told_where_there_is_no_other():
    found = ground(ObjectDescription("cup"), around(thing=LIKE_CUP, soup=SOUP))

    assert isinstance(found, Found)
    assert (found.names, found.because) == (("thing",), "the blue can looks as if it might be the cup")


def test_of_several_that_look_like_it_a_person_says_which():
    found = ground(ObjectDescription("cup"), around(one=LIKE_CUP, other=LIKE_CUP))

    assert isinstance(found, Ambiguous)


def test_what_is_one_goes_before_what_looks_like_one():
    found = ground(ObjectDescription("cup"), around(cup=Label("cup", "red"), thing=LIKE_CUP))

    assert isinstance(found, Found)
    assert found.names == ("cup",)


def test_a_name_that_nobody_is_sure_of_is_asked_about():
    found = ground(ObjectDescription("tomato soup"), around(thing=MAYBE_SOUP))

    assert isinstance(found, Ambiguous)
    assert found.message == "I am not sure: is the blue can the tomato soup?"


@pytest.mark.parametrize(
    ("seen", "names", "found"),
    [
        (None, ("akita black bowl",), True),
        ("black", ("akita bowl",), True),
        ("white", ("akita black bowl",), False),
        (None, ("akita bowl",), False),
        (None, ("black akita bowl",), False),
    ],
)
def test_a_colour_is_the_one_that_is_seen_and_of_what_has_none_the_one_that_its_name_says(seen, names, found):
    things = around(it=Label("bowl", seen, names), other=Label("bowl", "red"))

    meant = ground(ObjectDescription("bowl", "black"), things)

    assert meant == Found(("it",)) if found else isinstance(meant, Missing)
