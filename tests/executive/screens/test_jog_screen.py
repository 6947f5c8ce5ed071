"""What a person who jogs sees at a terminal of 80 by 24."""

import pytest

from executive.manual.keys import COMMON, KEYS, Jogged, Mode
from executive.screens.jog_screen import JogScreen, jog_lines

REASON = (
    "the right arm meets something that nobody saw (arm_right_4_joint gives 5.7 Nm more than it needs), "
    "beside the table"
)
JOGGED = [Jogged(mode=mode, may_touch=True, steps=steps) for mode in KEYS for steps in (False, True)]


@pytest.mark.parametrize("jogged", JOGGED, ids=lambda one: f"{one.mode} {one.steps}")
@pytest.mark.parametrize("ending", [False, True])
def test_all_of_it_fits_with_nothing_cut_off(jogged, ending):
    lines = jog_lines(JogScreen("pick up the red cup", jogged, REASON, "it still walks", ending), 80)

    assert len(lines) <= 20
    assert max(map(len, lines)) <= 80
    assert not any(line.endswith("~") for line in lines)


def test_what_holds_it_back_is_named_to_its_last_word():
    lines = jog_lines(JogScreen("", Jogged(), REASON), 80)

    assert REASON in " ".join(" ".join(lines).split())


def names(key):
    return {" ": "space", "up": "up", "enter": "enter"}.get(key, key)


@pytest.mark.parametrize("mode", sorted(KEYS))
def test_every_key_of_a_mode_is_shown(mode: Mode):
    shown = " ".join(jog_lines(JogScreen("", Jogged(mode=mode)), 80)).replace("1-7", "1 2 3 4 5 6 7").split()

    assert {names(key) for key in (*KEYS[mode], *COMMON)} <= {*shown}


def test_a_line_that_would_flood_the_screen_ends_somewhere():
    lines = jog_lines(JogScreen("", Jogged(), "wall " * 400), 80)

    assert len(lines) <= 20
    assert any(line.endswith("~") for line in lines)
