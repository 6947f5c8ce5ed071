"""The chat's screen as people see it, at two sizes, without colour and without Unicode."""

from dataclasses import replace
from pathlib import Path

import pytest

from executive.chat.chat_screen import ChatView, chat_screen, transcript
from executive.chat.robot_watch import RobotStanding
from executive.chat.utterance import Utterance
from executive.screens.rows import text_of
from tools.pictures.draw_chat import EXAMPLES
from tools.pictures.screen_pictures import SIZES

SNAPSHOTS = Path(__file__).parent / "screens"


def shown(view, width, height, unicode=True):
    return text_of(chat_screen(view, width, height, unicode))


@pytest.mark.requirement("U1")
@pytest.mark.parametrize("size", SIZES, ids="{0[0]}x{0[1]}".format)
@pytest.mark.parametrize("name", sorted(EXAMPLES))
def test_the_screen_is_as_it_was_looked_at(name, size):
    """After a wanted change: look at what comes out, and write it with python -m tools.pictures.draw_chat."""
    width, height = size
    file = SNAPSHOTS / f"{name}_{width}x{height}.txt"

    assert shown(EXAMPLES[name], width, height) + "\n" == file.read_text("utf-8")


@pytest.mark.requirement("U1")
@pytest.mark.parametrize("width", [20, 40, 80, 119, 120, 160, 250])
@pytest.mark.parametrize("height", [5, 10, 24, 50])
def test_every_size_holds_the_screen_with_the_line_that_is_typed(width, height):
    for view in [*EXAMPLES.values(), ChatView()]:
        lines = shown(view, width, height).split("\n")
        assert len(lines) <= height
        assert max(map(len, lines)) <= width
        assert any(line.startswith(("you ›", "answer ›")) for line in lines)


@pytest.mark.requirement("L6")
def test_an_open_question_stands_in_the_conversation_and_the_line_is_for_its_answer():
    text = shown(EXAMPLES["asking"], 80, 24)

    assert "robot  which cup? there are 2" in text
    assert "         2  red cup" in text
    assert "answer › the re" in text


def test_a_long_line_shows_the_end_that_is_typed():
    view = replace(EXAMPLES["working"], text="x" * 100 + "end", cursor=103)

    assert shown(view, 80, 24).split("\n")[-2].endswith("xend")


def test_what_was_said_before_is_scrolled_back_to():
    said = tuple(Utterance("you", (f"line {number}",)) for number in range(60))
    view = ChatView(said=said, back=30)

    assert "line 59" not in shown(view, 80, 24)
    assert "more rows below: PgDn" in shown(view, 80, 24)
    assert "line 0" in shown(replace(view, back=1000), 80, 24)


def test_what_moves_a_cursor_does_not_reach_the_terminal():
    view = ChatView(said=(Utterance("robot", ("red\x1b[2Jcup\x07",)),), text="\x1b[A", cursor=0)

    assert "\x1b" not in shown(view, 80, 24)
    assert "\x07" not in shown(view, 80, 24)


def test_a_terminal_without_unicode_gets_ascii():
    for view in EXAMPLES.values():
        assert shown(view, 80, 24, unicode=False).isascii()


@pytest.mark.requirement("S4")
@pytest.mark.parametrize("width", [40, 80, 160])
def test_an_emergency_stop_and_a_silent_robot_are_never_cut_off(width):
    engaged = ChatView(place="talos in clutter", now=RobotStanding(emergency="a person said so"))
    silent = ChatView(now=RobotStanding(silent="no answer within 5 s"))

    assert "EMERGENCY" in shown(engaged, width, 24).split("\n")[0]
    assert "NO ANSWER" in shown(silent, width, 24).split("\n")[0]


def test_words_of_wide_letters_stay_within_the_columns():
    view = ChatView(said=(Utterance("you", ("杯" * 200,)),))

    assert max(len(line) for line in shown(view, 80, 24).split("\n")[2:-3]) <= 7 + 37


def test_the_transcript_tells_who_said_what():
    said = (Utterance("you", ("wave",)), Utterance("robot", ("which?", "  1  this")))

    assert transcript(said) == ["you    wave", "robot  which?", "         1  this"]
