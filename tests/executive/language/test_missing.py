"""What a sentence leaves out is asked for; nothing that was said before is taken for it."""

import pytest

from executive.understanding.command_parser import parse
from executive.understanding.conversation import Conversation


@pytest.mark.requirement("L6")
@pytest.mark.parametrize(
    ("said", "text"),
    [
        ("Move the boxes.", "Move the boxes where?"),
        ("put the bowl, please", "put the bowl where?"),
        ("Pick up.", "Pick up what?"),
        ("Okay robot, open.", "Okay robot, open what?"),
        ("put the bowl on the", "put the bowl on the what?"),
        ("give the cup to", "give the cup to whom?"),
        ("hand me", "what shall be given?"),
        ("say", "say what?"),
        ("tell Ana", "tell Ana what?"),
        ("pick up the cup and", "pick up the cup and what?"),
        ("red cup pls", "what shall be done with 'red cup'?"),
        ("The cup and the bowl.", "what shall be done with 'The cup and the bowl'?"),
        ("Coffee, please!", "what shall be done with 'Coffee'?"),
    ],
)
def test_what_is_missing_is_asked_for(said, text):
    assert parse(said).question.text == text


def test_a_number_without_a_unit_is_asked_with_a_sentence_for_each():
    question = parse("move forward 2").question

    assert question.text == "move forward 2 what: meters or degrees or seconds?"
    assert question.choices == (
        "move forward 2 meters",
        "move forward 2 degrees",
        "move forward 2 seconds",
    )
    assert parse(question.choices[0]).commands


@pytest.mark.parametrize(
    "said",
    [
        "don't pick up the",
        "throw the",
        "if Ana comes, open",
        "good morning",
        "go on",
        "Ana",
    ],
)
def test_what_is_no_beginning_of_a_command_stays_refused(said):
    assert parse(said).outcome == "refused"


@pytest.mark.requirement("L6")
@pytest.mark.parametrize(
    ("said", "answer", "meant"),
    [
        ("move the boxes", "to the kitchen", "move the boxes to the kitchen"),
        ("put the bowl", "on the table.", "put the bowl on the table"),
        ("pick up", "the red cup", "pick up the red cup"),
        ("pick up", "open the fridge", "open the fridge"),
        ("put the bowl on the", "shelf", "put the bowl on the shelf"),
        ("move forward 2", "seconds", "move forward 2 seconds"),
        ("move forward 2", "meters", "move forward 2 meters"),
        ("the red cup", "pick it up", "pick up the red cup"),
        ("give the cup to", "Ana", "give the cup to Ana"),
    ],
)
def test_an_answer_completes_the_sentence(answered, said, answer, meant):
    meaning = answered(parse(said), answer)

    assert meaning.to_json()["tasks"] == parse(meant).to_json()["tasks"] != []


def test_an_answer_that_completes_nothing_is_no_command(answered):
    assert not answered(parse("put the bowl"), "wibble").commands


@pytest.mark.parametrize("said", ["the red cup", "red cup, please", "pick up the", "put the bowl"])
def test_nothing_that_was_said_before_is_taken_for_it(said):
    conversation = Conversation()
    conversation.understand("pick up the blue cup")

    assert conversation.understand(said).parsed.outcome == "question"
