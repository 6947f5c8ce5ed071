"""Names that no list holds are told by their capital, and by nothing else."""

import pytest

from executive.understanding.command_parser import parse


def person_of(sentence):
    parsed = parse(sentence).to_json()
    return parsed["tasks"][0].get("person") if parsed["tasks"] else None


@pytest.mark.parametrize("name", ["Herlinde", "Guðrún", "O'Malley", "Anne-Sophie", "Herlinde Baumgartner"])
def test_an_unknown_word_with_a_capital_is_a_name_as_it_was_written(name):
    assert person_of(f"wave to {name}") == name


@pytest.mark.parametrize("name", ["Ana Maria", "Mary Jane", "Jean Paul"])
def test_two_listed_names_side_by_side_are_those_of_one_person(name):
    assert person_of(f"wave to {name}") == name
    bring = parse(f"bring {name} the cup").to_json()["tasks"]
    assert bring[-1]["to"] == name


@pytest.mark.parametrize(
    ("sentence", "people"),
    [
        ("wave to Ana, Maria and Ben", ["Ana", "Maria", "Ben"]),
        ("wave to Ana and Maria", ["Ana", "Maria"]),
        ("wave to Ana Maria and Ben", ["Ana Maria", "Ben"]),
    ],
)
def test_names_in_a_list_are_of_several_people(sentence, people):
    assert [task["person"] for task in parse(sentence).to_json()["tasks"]] == people


def test_whose_a_thing_is_stands_beside_who_gets_it():
    (_, given) = parse("bring Ana Ben's cup").to_json()["tasks"]

    assert given["to"] == "Ana"


@pytest.mark.parametrize("sentence", ["wave to ana maria", "Wave To Ana Maria", "WAVE TO ANA MARIA"])
def test_without_capitals_that_tell_two_names_are_not_one(sentence):
    assert parse(sentence).refusal is not None


@pytest.mark.parametrize(
    "sentence",
    [
        "wave to hroswitha",
        "Wave To Herlinde",
        "WAVE TO HROSWITHA",
        "wave to Ana, Herlinde",
        "wave to the Yolanthe",
    ],
)
def test_where_a_capital_tells_nothing_the_word_stays_unknown(sentence):
    assert parse(sentence).refusal is not None


@pytest.mark.parametrize(
    ("sentence", "meant"),
    [("bring the cup to Kichen", "kitchen"), ("wave to Mraia", "maria"), ("wave to Annna", "anna")],
)
def test_a_known_word_that_was_mistyped_is_no_name(sentence, meant):
    assert f"did you mean {meant!r}" in parse(sentence).refusal.message


def test_a_name_that_is_only_like_a_listed_one_is_a_name_of_its_own():
    assert person_of("wave to Oliveria") == "Oliveria"


def test_somebody_of_whom_is_told_may_be_meant_by_him():
    parsed = parse("tell Ben that Herlinde is here and give him the cup")

    assert parsed.question.choices == ("Ben", "Herlinde")
