"""What is asked, permitted, planned, warned of or half said is no order: it is asked back."""

import pytest

from executive.understanding.command_parser import parse


@pytest.mark.parametrize(
    "said",
    [
        "is it possible to open the fridge?",
        "are you able to pick up the cup",
        "you may open the fridge",
        "the plan is to open the fridge",
        "the task is to open the fridge",
        "I hope you can open the fridge",
        "Pick up the cup. Put the plate under it",
        "pick up the last one",
        "give me your cup",
        "take the cup off",
        "find me a pen",
        "Careful, the cup is hot. Pick it up",
        "wave, wave to Ana",
        "tell Ana that dinner is ready period",
    ],
)
def test_what_may_be_no_order_is_asked(said):
    parsed = parse(said)

    assert parsed.commands == ()
    assert parsed.question is not None


@pytest.mark.parametrize(
    "said",
    [
        "did you open the fridge",
        "I was told to open the fridge",
        "wave wave to Ana",
        "you see a cup on the table",
        "look at Ana open the fridge",
        "bring Ana the red cup, Tom can go to the bedroom",
        "should I open the fridge?",
    ],
)
def test_a_report_is_never_done(said):
    assert parse(said).commands == ()
