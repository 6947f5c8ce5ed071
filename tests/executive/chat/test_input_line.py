"""The line that is typed: characters, the cursor, lines before it, and keys that ask for something."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from executive.chat.input_line import InputLine, Wish


def typed(*parts, history=()):
    line = InputLine(history)
    found = [one for part in parts for one in line.feed(part)]
    return line, found


@pytest.mark.parametrize(
    ("keys", "text", "cursor"),
    [
        ("wavx\x7fe", "wave", 4),
        ("ave\x1b[H" + "w", "wave", 1),
        ("wave\x1b[D\x1b[D\x1b[3~", "wae", 2),
        ("pick up the cup\x17", "pick up the ", 12),
        ("wave\x15", "", 0),
        ("wave\x1b[D\x0b", "wav", 3),
        ("wave\x01\x1b[C\x05!", "wave!", 5),
        ("grüße", "grüße", 5),
        ("a\x1bb\tc", "abc", 3),
    ],
)
def test_keys_edit_the_line(keys, text, cursor):
    line, found = typed(keys)

    assert (line.text, line.cursor, found) == (text, cursor, [])


def test_enter_hands_the_line_over_and_begins_another():
    line, found = typed("wave\rpick up the cup\rgo")

    assert found == ["wave", "pick up the cup"]
    assert line.text == "go"


@pytest.mark.parametrize(
    ("key", "wish"),
    [
        ("\x18", Wish.STOP),
        ("\x10", Wish.PAUSE),
        ("\x1b[5~", Wish.BACK),
        ("\x1b[6~", Wish.FORTH),
        ("\x04", Wish.END),
    ],
)
def test_keys_ask_for_something_beside_the_line(key, wish):
    assert typed(key)[1] == [wish]


def test_the_key_that_ends_does_not_when_something_is_typed():
    assert typed("wave\x04")[1] == []


def test_arrows_bring_back_the_lines_before_and_the_line_that_was_begun():
    line, _ = typed("wa\x1b[A", history=["first", "second"])
    assert line.text == "second"

    line.feed("\x1b[A\x1b[A")
    assert line.text == "first"

    line.feed("\x1b[B\x1b[B")
    assert line.text == "wa"


def test_a_key_that_arrives_in_two_pieces_is_one_key():
    line, found = typed("ab\x1b[", "D", "c")

    assert (line.text, found) == ("acb", [])


@given(st.text(max_size=60))
def test_whatever_is_typed_leaves_the_cursor_in_the_line(keys):
    line, _ = typed(keys, history=["before"])

    assert 0 <= line.cursor <= len(line.text)
    assert line.text.isprintable()
