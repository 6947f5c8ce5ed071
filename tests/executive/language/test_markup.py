"""Marks around words are taken away where the text means nothing with them."""

import pytest

from executive.understanding.command_parser import parse


def tasks_of(text):
    return parse(text).to_json()["tasks"]


@pytest.mark.parametrize(
    "text",
    [
        "**pick up** the cup",
        "`pick up the cup`",
        "pick up the <cup>",
        "pick up 'the cup'",
        "```\npick up the cup\n```",
    ],
)
def test_marks_around_words_say_nothing(text):
    assert tasks_of(text) == [{"action": "pick", "object": {"kind": "cup"}}]


@pytest.mark.parametrize(
    "text",
    [
        "**do not** pick up the cup",
        "Ana says 'pick up the cup'",
        "pick up the box with 'cup' on it",
        "what does 'pick up the cup' mean?",
        "ask Ana 'pick up the cup'",
        "write 'pick up the cup'",
    ],
)
def test_what_is_quoted_is_not_done_where_it_is_spoken_written_or_denied(text):
    assert tasks_of(text) == []


@pytest.mark.parametrize("text", ["tell Tom the shift <script> is over", "tell Ben I love `id` him"])
def test_marks_are_not_taken_out_of_what_may_be_said(text):
    assert tasks_of(text) == []


def test_words_to_say_keep_their_marks():
    assert tasks_of('say "**hello**"')[0]["text"] == "**hello**"
