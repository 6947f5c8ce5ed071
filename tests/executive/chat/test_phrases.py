"""What a typed line asks of the chat itself."""

import pytest

from executive.chat.phrases import Ask, asked_of_chat


@pytest.mark.parametrize(
    ("line", "asked"),
    [
        ("stop", Ask.STOP),
        ("STOP!!!", Ask.STOP),
        ("Please, stop.", Ask.STOP),
        ("stop the robot", Ask.STOP),
        ("cancel", Ask.CANCEL),
        ("Never mind!", Ask.CANCEL),
        ("pause", Ask.PAUSE),
        ("go on", Ask.GO_ON),
        ("reset", Ask.RESET),
        ("/reset", Ask.RESET),
        ("Why?", Ask.WHY),
        ("why not", Ask.WHY),
        ("What happened?", Ask.WHY),
        ("what do you see?", Ask.SEEN),
        ("what’s there", Ask.SEEN),
        ("status", Ask.STANDING),
        ("help", Ask.HELP),
        ("?", Ask.HELP),
        ("quit", Ask.END),
    ],
)
def test_a_line_asks_something_of_the_chat(line, asked):
    assert asked_of_chat(line) is asked


@pytest.mark.parametrize(
    "line",
    [
        "pick up the red cup",
        "wave until I say stop",
        "why is the cup on the table",
        "help Ana",
        "drop it",
        "wait for 5 seconds",
        "continue to the kitchen",
        "",
        "...",
        "stop " * 100,
    ],
)
def test_a_sentence_is_for_the_robot(line):
    assert asked_of_chat(line) is None
