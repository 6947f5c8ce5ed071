"""What an answer to a question means; every word of it counts."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from executive.dialogue.clarification import (
    Chosen,
    OpenQuestion,
    Unclear,
    Withdrawn,
    clarified,
    understood_answer,
)
from executive.meaning import Parsed, Question
from executive.session.driver import driven
from executive.understanding.command_parser import parse

CUPS = ("left red cup", "right red cup", "blue cup")


@pytest.mark.requirement("L6")
@pytest.mark.parametrize(
    ("answer", "index"),
    [
        ("1", 0), ("2", 1), ("the third", 2), ("number 2", 1), ("the second one", 1), ("last", 2),
        ("the left one", 0), ("left", 0), ("the one on the left", 0), ("the right red cup", 1), ("RIGHT!", 1),
        ("blue", 2), ("the blue one, please", 2), ("I mean the blue cup", 2), ("second from the left", 1),
        ("whichever", 0),
    ],
)  # fmt: skip
def test_an_answer_chooses(answer, index):
    assert understood_answer(answer, CUPS) == Chosen(index)


@pytest.mark.parametrize(
    "answer", ["never mind", "Never mind.", "cancel", "stop", "no", "none of them", "neither"]
)
def test_an_answer_withdraws(answer):
    assert understood_answer(answer, CUPS) == Withdrawn()


@pytest.mark.parametrize(
    "answer",
    ["red", "cup", "the green one", "4", "yes", "not the blue one", "blue and red", "", "  ", "x" * 999],
)
def test_an_answer_that_fits_none_or_several_is_unclear(answer):
    assert isinstance(understood_answer(answer, CUPS), Unclear)


@pytest.mark.parametrize("answer", ["yes", "ok", "the red cup"])
def test_a_single_choice_is_confirmed(answer):
    assert understood_answer(answer, ("red cup",)) == Chosen(0)


@given(st.text(max_size=300))
def test_any_text_is_some_answer(text):
    assert isinstance(understood_answer(text, CUPS), (Chosen, Withdrawn, Unclear))


def test_a_question_is_told_with_numbered_choices():
    assert OpenQuestion("which cup? there are 3", CUPS).lines() == [
        "which cup? there are 3", "  1  left red cup", "  2  right red cup", "  3  blue cup"
    ]  # fmt: skip


class Asked:
    """Somebody who gives these answers, and then no more; remembers what was asked."""

    def __init__(self, *answers):
        self.answers, self.questions = list(answers), []

    def about(self, parsed):
        return driven(clarified(parsed), self.answer)

    def answer(self, question):
        self.questions.append(question)
        return self.answers.pop(0) if self.answers else None


UNCLEAR = Parsed("go there", question=Question("where to?", ("go home", "pick up the red cup")))


def test_a_sentence_that_is_unclear_in_itself_is_replaced_by_the_choice():
    assert Asked("2").about(UNCLEAR).commands == parse("pick up the red cup").commands


def test_a_sentence_of_its_own_answers_as_well():
    assert Asked("pick up the blue box").about(UNCLEAR).commands == parse("pick up the blue box").commands


def test_an_answer_that_is_not_understood_is_asked_again_with_the_reason():
    asked = Asked("the moon", "1")

    assert asked.about(UNCLEAR).commands == parse("go home").commands
    assert asked.questions[1].tried == "'the moon' is none of the choices"


def test_no_answer_leaves_the_question_open_and_a_withdrawal_refuses():
    assert Asked().about(UNCLEAR).outcome == "question"
    assert Asked("never mind").about(UNCLEAR).outcome == "refused"
