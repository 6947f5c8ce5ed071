"""What is unclear in the words is settled before anything moves."""

import json

import pytest

from executive.dialogue.settle_words import settled
from executive.session.events import InputTaken, QuestionAsked
from executive.understanding.statement import Statement
from executive.understanding.understanding import understand

DOUBTFUL = json.dumps([{"command": "go home", "confidence": 0.4}])


class Person:
    """Gives these answers, and then no more."""

    def __init__(self, *answers):
        self.answers, self.questions = list(answers), []

    def answer(self, question):
        self.questions.append(question)
        return self.answers.pop(0) if self.answers else None


def said(text):
    return Statement.of(understand(text))


@pytest.mark.requirement("L6")
def test_an_answer_completes_the_sentence_and_both_are_told_with_their_times():
    told, times_s = [], iter((1.0, 4.5))

    statement = settled(said("pick up"), Person("the red cup"), "ask", told.append, lambda: next(times_s))

    assert [command.action for command in statement.parsed.commands] == ["pick"]
    assert told == [QuestionAsked(1.0, "pick up", "pick up what?"), InputTaken(4.5, "answer", "the red cup")]


@pytest.mark.requirement("L8")
@pytest.mark.parametrize(
    ("on_question", "answers", "outcome"),
    [
        ("ask", ["sure"], "tasks"),
        ("ask", ["no"], "refused"),
        ("first", [], "tasks"),
        ("fail", [], "question"),
    ],
)
def test_low_confidence_is_confirmed_or_not_and_keeps_where_it_comes_from(on_question, answers, outcome):
    person = Person(*answers)

    statement = settled(said(DOUBTFUL), person, on_question, lambda _event: None)

    assert statement.parsed.outcome == outcome
    assert [one.confidence for one in statement.provenance] == ([0.4] if outcome == "tasks" else [])
    assert len(person.questions) == len(answers)


def test_a_question_that_is_expected_is_not_asked():
    expecting = Statement(said("pick up").parsed, expect="question")
    person, told = Person("the red cup"), []

    assert settled(expecting, person, "ask", told.append) is expecting
    assert not person.questions
    assert not told


@pytest.mark.requirement("L5")
def test_what_is_no_skill_is_refused():
    assert settled(said("watch me"), Person(), "ask", lambda _event: None).parsed.outcome == "refused"
