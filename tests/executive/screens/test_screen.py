"""The screen as people see it, at two sizes, without colour and without Unicode; snapshots as plain text."""

import re
from dataclasses import replace
from pathlib import Path

import pytest

from executive.dialogue.clarification import OpenQuestion
from executive.screens.rows import text_of
from executive.screens.screen import ScreenState, screen
from tools.pictures.draw_screens import ASKING, EXAMPLES, RUNNING, STOPPED

SNAPSHOTS = Path(__file__).parent / "screens"
SIZES = ((80, 24), (160, 50))


def shown(state, width, height, unicode=True):
    return text_of(screen(state, width, height, unicode))


@pytest.mark.requirement("U1")
@pytest.mark.parametrize("size", SIZES, ids="{0[0]}x{0[1]}".format)
@pytest.mark.parametrize("name", sorted(EXAMPLES))
def test_the_screen_is_as_it_was_looked_at(name, size):
    """After a wanted change: look at what comes out, and write it with python -m
    tools.pictures.draw_screens.
    """
    width, height = size
    file = SNAPSHOTS / f"{name}_{width}x{height}.txt"

    assert shown(EXAMPLES[name], width, height) + "\n" == file.read_text("utf-8")


@pytest.mark.requirement("U1")
@pytest.mark.parametrize("width", [20, 40, 80, 119, 120, 160, 250])
@pytest.mark.parametrize("height", [5, 10, 24, 50])
def test_every_size_holds_the_screen(width, height):
    for state in EXAMPLES.values():
        lines = shown(state, width, height).split("\n")
        assert len(lines) <= height
        assert max(map(len, lines)) <= width


def test_80_by_24_tells_everything_that_matters():
    text = shown(RUNNING, 80, 24)

    assert "talos in tabletop, seed 7" in text
    assert "NORMAL" in text
    assert re.search(r"now     pick/reach/stream reach: \d\d%", text)
    assert re.search(r"failed  the red cup is not where it was \(moved [\d.]+ mm", text)
    assert "c cancel   e emergency stop   p pause" in text


@pytest.mark.requirement("L6")
def test_an_open_question_shows_its_choices_and_keys():
    text = shown(ASKING, 80, 24)

    assert "asked   which cup? there are 2" in text
    assert "        2  red cup" in text
    assert "a answer in words" in text


def test_an_emergency_stop_is_never_cut_off():
    for width in (40, 80, 160):
        assert "EMERGENCY" in shown(STOPPED, width, 24).split("\n")[0]


def test_pausing_is_shown():
    assert "PAUSED" in shown(replace(RUNNING, paused=True), 80, 24)


def test_a_terminal_without_unicode_gets_ascii():
    assert shown(RUNNING, 80, 24, unicode=False).isascii()


def test_before_the_first_tick_nothing_is_under_way():
    assert "nothing is under way" in shown(ScreenState(), 80, 24)


def test_control_characters_of_a_message_do_not_reach_the_terminal():
    question = OpenQuestion("which\x1b[31m one?", ("a\x07", "b"))
    state = replace(RUNNING, question=question, failure="\x1b[2J", log=("\x1b]0;x",), task="\x1b[1m")

    for size in SIZES:
        assert "\x1b" not in shown(state, *size)
        assert "\x07" not in shown(state, *size)
