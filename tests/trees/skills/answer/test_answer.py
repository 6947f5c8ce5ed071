"""Answers: the day and time come from an injected calendar, the robot from what it is told of itself."""

from dataclasses import replace
from datetime import datetime

import pytest

from robots.fake.fake_world import person
from tests.trees.household_stage import run, said
from trees.events import Said
from trees.self_knowledge import Calendar, Identity
from trees.skills.answer import AnswerTask

NEW_YEARS_EVE = Calendar(datetime(2027, 12, 31, 23, 59))
TALLY = Identity("Tally", "Lodestar", "Norway", "Fjord University", "I like cups.")


def answered(stage, question, identity=TALLY, calendar=NEW_YEARS_EVE):
    stage.toolbox = replace(stage.toolbox, identity=identity, calendar=calendar)
    run(stage, AnswerTask("tell me", question))
    return said(stage)


@pytest.mark.requirement("L12")
@pytest.mark.parametrize(
    ("question", "words"),
    [
        ("time", "it is 23:59"),
        ("day", "today is Friday"),
        ("date", "today is Friday, the 31st of December 2027"),
        ("tomorrow", "tomorrow is Saturday, the 1st of January 2028"),
        ("day of the week", "today is Friday"),
        ("day of the month", "today is the 31st of December"),
        ("name", "my name is Tally"),
        ("team", "my team is Lodestar"),
        ("country", "I come from Norway"),
        ("affiliation", "my affiliation is Fjord University"),
        ("about yourself", "I like cups."),
    ],
)
def test_each_question_has_its_answer(stage, question, words):
    assert answered(stage, question) == [words]


@pytest.mark.parametrize(
    ("question", "words"),
    [
        ("name", "my name is TALOS"),
        ("team", "nobody has told me my team"),
        ("about yourself", "I am TALOS, a humanoid robot"),
    ],
)
def test_what_nobody_told_the_robot_is_not_made_up(stage, question, words):
    assert answered(stage, question, Identity()) == [words]


def test_time_goes_on_with_the_clock(stage):
    stage.fake.clock.advance(61.0)

    assert answered(stage, "time") == ["it is 00:00"]


def test_a_question_without_an_answer_is_told_with_those_that_have_one(stage):
    tree = run(stage, AnswerTask("tell me", "weather"))

    assert "no answer to 'weather', only to time, day" in tree.failure.message


def test_the_answer_is_for_whom_it_is_asked_for(stage_with):
    stage = stage_with(person("Ben", (1.3, -0.5)), person("Ana", (1.4, 0.5)))

    run(stage, AnswerTask("tell Ana the time", "time", "Ana"))

    assert [event.to for event in stage.events if isinstance(event, Said)] == ["Ana"]


@pytest.mark.parametrize(
    ("day", "said_so"),
    [(1, "1st"), (2, "2nd"), (3, "3rd"), (4, "4th"), (11, "11th"), (12, "12th"), (13, "13th"), (22, "22nd")],
)
def test_days_of_the_month_are_counted_as_people_do(stage, day, said_so):
    words = answered(stage, "day of the month", calendar=Calendar(datetime(2026, 5, day, 8)))

    assert words == [f"today is the {said_so} of May"]
