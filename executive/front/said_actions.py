"""Which actions the verbs of some words may mean: the parser reads each with something to be done to."""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from pathlib import Path

from executive.config import config_files
from executive.understanding.command_parser import CommandParser, parser_with
from executive.vocabulary.place_words import place_words
from executive.vocabulary.written import split_words

_AROUND = (
    *("{}", "{} me", "{} the cup", "{} me the cup", "{} for the cup", "{} at the cup", "{} the fridge"),
    *("{} the table", "{} to the table", "{} me to the table", "{} the cup to the table"),
    *("{} the cup on the table", "{} the cup in the box", "{} the cup to me"),
)
"""What a verb is read with: whatever it is done to, there is one that it goes with."""
_LONGEST = 3


def actions_said(text: str) -> frozenset[str]:
    """The actions that the words of a text may mean; none where it holds no verb of a command.

    Args:
        text: What the person said.
    """
    parser = parser_with(config_files(), place_words())
    words = [word for word, _, _ in split_words(text.replace("’", "'"))]
    found = (_actions(phrase, config_files()) for phrase in set(_verbs(parser, words)))
    return frozenset().union(*found)


def _verbs(parser: CommandParser, words: list[str]) -> Iterator[str]:
    for index in range(len(words)):
        for length in range(1, _LONGEST + 1):
            phrase = " ".join(words[index : index + length])
            if index + length <= len(words) and parser.may_command(phrase):
                yield phrase


@lru_cache(maxsize=512)
def _actions(phrase: str, files: tuple[Path, ...]) -> frozenset[str]:
    parser = parser_with(files)
    read = (parser.parse(around.format(phrase)) for around in _AROUND)
    return frozenset(command.action for parsed in read for command in parsed.commands)
