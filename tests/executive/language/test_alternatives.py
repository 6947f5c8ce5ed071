"""Alternatives are a question wherever they stand, each choice a sentence that answers it."""

import json
from pathlib import Path

import pytest

from executive.understanding.command_parser import parse

CORPUS = Path(__file__).parents[2] / "corpus" / "alternatives_are_asked.jsonl"


@pytest.mark.requirement("L2", "L6")
@pytest.mark.parametrize(
    ("said", "text", "choices"),
    [
        (
            "Give Luca the red or the blue mug.",
            "the red or the blue mug: which one is meant?",
            ["Give Luca the red mug", "Give Luca the blue mug"],
        ),
        (
            "Put the plate on the table or on the shelf.",
            "on the table or on the shelf: which one is meant?",
            ["Put the plate on the table", "Put the plate on the shelf"],
        ),
        ("turn left or right", "left or right: which one is meant?", ["turn left", "turn right"]),
        (
            "turn left or right 90 degrees",
            "left or right: which one is meant?",
            ["turn left 90 degrees", "turn right 90 degrees"],
        ),
        (
            "pick up the cup with your left or right hand",
            "left or right hand: which one is meant?",
            ["pick up the cup with your left hand", "pick up the cup with your right hand"],
        ),
        (
            "bring me two or three cups",
            "two or three cups: which one is meant?",
            ["bring me two cups", "bring me three cups"],
        ),
        (
            "bring me one of the following: the can, the bottle or the cup",
            "the can, the bottle or the cup: which one is meant?",
            ["bring me the can", "bring me the bottle", "bring me the cup"],
        ),
        ("please wave or go home", "wave or go home: which one is meant?", ["please wave", "please go home"]),
        (
            "pick up the cup in the box or the bowl",
            "the cup in the box or the bowl: which one is meant?",
            ["pick up the cup in the box", "pick up the cup in the bowl", "pick up the bowl"],
        ),
    ],
)
def test_alternatives_are_asked_about_with_a_sentence_for_each(said, text, choices):
    question = parse(said).question

    assert question.text == text
    assert list(question.choices) == choices


def test_every_choice_makes_tasks():
    said = [json.loads(line)["say"] for line in CORPUS.read_text("utf-8").splitlines()]

    for sentence in said:
        question = parse(sentence).question
        for choice in question.choices if question is not None else ():
            assert parse(choice).commands, (sentence, choice)


@pytest.mark.requirement("L6")
@pytest.mark.parametrize(
    ("said", "answer", "meant"),
    [
        ("give Luca the red or the blue mug", "the blue one", "give Luca the blue mug"),
        ("give Luca the red or the blue mug", "1", "give Luca the red mug"),
        ("put the plate on the table or on the shelf", "on the shelf", "put the plate on the shelf"),
        ("turn left or right", "left", "turn left"),
        ("walk to Ana or to Tom", "Tom", "walk to Tom"),
        ("pick up the cup or the bowl", "the bowl, please", "pick up the bowl"),
        ("wave or go home", "go home", "go home"),
        ("bring me two or three cups", "three", "bring me three cups"),
    ],
)
def test_an_answer_chooses_one_of_them(answered, said, answer, meant):
    meaning = answered(parse(said), answer)

    assert meaning.to_json()["tasks"] == parse(meant).to_json()["tasks"] != []


def test_what_leaves_something_else_open_is_asked_without_choices():
    question = parse("put it on the table or on the shelf").question

    assert question.text.startswith("on the table or on the shelf: which one is meant")
    assert "'it'" in question.text
    assert question.choices == ()
