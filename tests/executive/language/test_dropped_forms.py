"""Rare wordings are no commands: they are refused or asked about, and never mean something else."""

import pytest

from executive.understanding.command_parser import parse


@pytest.mark.parametrize(
    "sentence",
    [
        "bring to Ana the cup",
        "take from the table the cup",
        "clear the bowl off the table",
        "let Ana have the cup",
        "stick the cup on the shelf",
        "put it with the others",
        "put the cup where the bowl is",
        "go to Ana's location",
        "go to where Ana is",
        "go to the kitchen at 0.3 m/s",
        "go by the sofa",
        "go kitchen",
        "turn left then right",
        "make a quarter turn to the left",
        "two steps forward",
        "leave the door open",
        "is the fridge open?",
        "watch Ana",
        "look around",
        "greet Ana by waving",
        "greet Ana by saying hello",
        "give Ana a wave",
        "tell me where she is",
        "say hello to Ana from me",
        "say the magic word",
        "is Ana sitting in the kitchen?",
        "go to the two chairs",
        "take a photo frame from the shelf",
        "before doing anything, wave",
    ],
)
def test_a_rare_wording_is_not_acted_on(sentence):
    assert parse(sentence).commands == ()
