"""What the things of a place are called is understood there, and nowhere else."""

import pytest

from executive.understanding.command_parser import parse
from executive.vocabulary.in_a_place import words_of_the_place
from trees.tasks import ObjectDescription

PLACE = ("zorblax", "macaroni and cheese", "groceries", "Tomato-Soup", "cup", "WD40 can", "object0")


def meant(sentence):
    with words_of_the_place(PLACE):
        parsed = parse(sentence)
    assert parsed.refusal is None
    assert parsed.question is None
    return [command.object for command in parsed.commands if isinstance(command.object, ObjectDescription)]


@pytest.mark.parametrize(
    ("sentence", "kinds"),
    [
        ("pick up the zorblax", ["zorblax"]),
        ("find the zorblaxes", ["zorblax"]),
        ("bring me the macaroni and cheese", ["macaroni and cheese"]),
        ("put the macaroni and the cheese on the table", ["macaroni", "cheese"]),
        ("bring me the groceries", ["groceries"]),
        ("pick up the tomato soup", ["tomato soup"]),
        ("take the mug", ["cup"]),
        ("pick up the WD40 can", ["wd40 can"]),
        ("pick up object0", ["object0"]),
    ],
)
def test_a_thing_of_the_place_is_called_as_it_is_there(sentence, kinds):
    assert [one.kind for one in meant(sentence)] == kinds


def test_a_word_of_one_place_is_not_known_elsewhere():
    meant("pick up the zorblax")

    assert parse("pick up the zorblax").refusal.word == "zorblax"


@pytest.mark.parametrize("said", ["bedside table", "nightstand", "night stand"])
def test_furniture_is_called_as_the_place_calls_it_by_whatever_word(said):
    with words_of_the_place(("bedside table",)):
        (task,) = parse(f"put the cup on the {said}").to_json()["tasks"]

    assert task["on"] == "bedside table"


def test_several_pieces_are_called_as_the_place_calls_one():
    with words_of_the_place(("bedside table",)):
        (command,) = parse("count the nightstands").commands

    assert command.object.kind == "bedside table"


def test_furniture_of_which_the_place_tells_more_keeps_its_short_name():
    with words_of_the_place(("kitchen counter",)):
        (task,) = parse("put the cup on the counter").to_json()["tasks"]

    assert task["on"] == "counter"


@pytest.mark.parametrize(
    ("things", "said", "kind"),
    [
        (("wooden cabinet",), "open the top drawer of the cabinet", "cabinet"),
        (("wine rack",), "put the cup on the rack", "rack"),
        (("wooden cabinet", "wine rack"), "put the cup on the top of the cabinet", "cabinet"),
        (("wooden cabinet",), "put the cup on the rack", "shelf"),
        ((), "put the cup in the cabinet", "cupboard"),
    ],
)
def test_furniture_that_ends_on_a_word_is_what_that_word_means_there(things, said, kind):
    with words_of_the_place(things):
        (task,) = parse(said).to_json()["tasks"]

    where = task.get("on") or task.get("to") or task["object"]["relation"]["to"]
    assert where == kind


@pytest.mark.parametrize(("things", "kind"), [(("wooden cabinet",), "cabinet"), ((), "cupboard")])
def test_so_are_several_of_them(things, kind):
    with words_of_the_place(things):
        (command,) = parse("how many cabinets are there").commands

    assert command.object.kind == kind


PEOPLE = ("Will", "R2D2", "Mary-Jane", "Doctor Who", "Ana", "Bo", "kwnd")


@pytest.mark.parametrize("name", PEOPLE)
@pytest.mark.parametrize(
    "sentence",
    [
        "wave to {}",
        "find {} in the kitchen",
        "take the cup from the table and bring it to {}",
        "go to the kitchen, find {} and say hello to them",
        "tell {} that dinner is ready",
    ],
)
def test_a_person_of_the_place_is_called_as_there_is_said(name, sentence):
    with words_of_the_place((), PEOPLE):
        parsed = parse(sentence.format(name))

    assert parsed.refusal is None
    assert parsed.question is None
    assert f"'{name}'" in str(parsed.to_json())


@pytest.mark.parametrize("said", ["wave to mary-jane", "wave to doctor who", "wave to will"])
def test_a_name_of_the_place_may_be_said_in_small_letters(said):
    with words_of_the_place((), PEOPLE):
        (command,) = parse(said).commands

    assert command.person in PEOPLE


def test_what_somebody_of_the_place_has_is_theirs():
    with words_of_the_place((), ("Bo",)):
        (command,) = parse("find Bo's cup").commands

    assert command.object.name == "Bo's cup"


def test_a_name_of_one_place_is_not_known_elsewhere():
    with words_of_the_place((), ("Kwnd",)):
        assert parse("wave to kwnd").commands

    assert parse("wave to kwnd").refusal.word == "kwnd"


def test_a_word_stays_what_it_is_though_somebody_is_called_by_it():
    with words_of_the_place((), ("Will", "Rose", "Green")):
        (command,) = parse("will you pick up the green cup").commands

    assert command.object == ObjectDescription("cup", "green")


@pytest.mark.parametrize("noun", ["microwave", "larder", "tall larder", "credenza", "kiln"])
def test_what_has_a_door_can_be_opened_whatever_it_is_called(noun):
    with words_of_the_place((noun, "cup"), fronts=(f"{noun} door",)):
        (opened,) = parse(f"open the {noun}").commands
        (door,) = parse(f"close the {noun} door").commands
        assert parse("open the cup").refusal.word == "cup"

    assert opened.object == door.object == ObjectDescription(noun)


@pytest.mark.parametrize("noun", ["larder", "tall larder", "credenza"])
def test_what_nobody_told_to_have_a_door_cannot_be_opened(noun):
    with words_of_the_place((noun,), fronts=("fridge door",)):
        assert not parse(f"open the {noun}").commands


def test_a_drawer_is_said_to_be_in_what_has_drawers():
    with words_of_the_place(
        ("cabinet", "wooden credenza"), fronts=("cabinet drawer", "wooden credenza drawer")
    ):
        (drawer,) = parse("open the top drawer of the cabinet").commands
        (other,) = parse("open the top drawer of the credenza").commands

    assert (drawer.object.kind, drawer.object.ordinal) == ("drawer", "top")
    assert str(drawer.object.relation.to) == "cabinet"
    assert str(other.object.relation.to) == "credenza"


@pytest.mark.parametrize(
    ("said", "ordinal"),
    [
        ("open the cabinet drawer", None),
        ("open the top cabinet drawer", "top"),
        ("close the bottom drawer of the cabinet", "bottom"),
        ("put the cup in the lower cabinet drawer", "bottom"),
    ],
)
def test_the_cabinet_drawer_is_the_drawer_of_the_cabinet(said, ordinal):
    with words_of_the_place(("cabinet", "cup"), fronts=("cabinet drawer",)):
        (command,) = parse(said).commands

    drawer = command.to if hasattr(command, "to") else command.object
    assert (drawer.kind, drawer.ordinal, str(drawer.relation.to)) == ("drawer", ordinal, "cabinet")


@pytest.mark.parametrize(
    "said", ["open the cabinet microwave", "open the fridge cabinet", "open the drawer fridge"]
)
def test_two_pieces_are_not_one(said):
    assert not parse(said).commands
