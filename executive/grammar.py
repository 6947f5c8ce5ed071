"""The grammar, and the search for the parses of a sentence whose words may have several readings."""

from __future__ import annotations

import copy
import importlib.resources
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from lark import Lark, Token, Tree, UnexpectedInput
from lark.lexer import Lexer
from lark.parsers.lalr_interactive_parser import InteractiveParser

from executive.tokens import UNKNOWN, Word
from executive.vocabulary import Reading, Vocabulary

MAX_ALTERNATIVES = 16
"""Parses that are followed side by side; an everyday sentence has one or two."""

ParseTree = Tree[Token]


@dataclass(frozen=True, slots=True)
class NoParse:
    """Where the grammar could not go on.

    Attributes:
        position: Index of the word that does not fit; the number of words when the sentence ends early.
        expected: Word classes that would have fitted there.
    """

    position: int
    expected: frozenset[str]


class TooManyParsesError(Exception):
    """A sentence with more readings than can be followed."""


class Grammar:
    """LALR tables over the word classes of a vocabulary.

    A word with several readings splits the parse; every one that reaches the end is returned, so that
    a real ambiguity is seen and never settled silently.
    """

    def __init__(self, vocabulary: Vocabulary) -> None:
        rules = importlib.resources.files("executive").joinpath("grammar.lark").read_text("utf-8")
        self._names = sorted({*vocabulary.classes, UNKNOWN})
        self._lark = Lark(
            rules + "".join(f"\n%declare {name}" for name in self._names) + "\n",
            parser="lalr",
            lexer=_ReadyTokens,
            propagate_positions=True,
        )

    def parses(self, words: Sequence[Word]) -> list[ParseTree] | NoParse:
        """Every parse of the words, or where it breaks off.

        Raises:
            TooManyParsesError: More than ``MAX_ALTERNATIVES`` parses run side by side.
        """
        alive = [self._lark.parse_interactive([])]
        for position, word in enumerate(words):
            following = [
                fed
                for state in alive
                for reading in word.readings
                if (fed := _feed(state, _token(word, reading))) is not None
            ]
            if not following:
                return NoParse(position, self._expected(alive))
            if len(following) > MAX_ALTERNATIVES:
                raise TooManyParsesError
            alive = following
        trees = [tree for state in alive if (tree := _finish(state)) is not None]
        return trees or NoParse(len(words), self._expected(alive))

    def _expected(self, alive: Sequence[InteractiveParser]) -> frozenset[str]:
        fits = (name for name in self._names if any(_feed(state, Token(name, "")) for state in alive))
        return frozenset(fits)


class _ReadyTokens(Lexer):
    """The words are tokens already."""

    def __init__(self, lexer_conf: Any) -> None:
        """Take what Lark hands to every lexer; nothing of it is needed."""

    def lex(self, lexer_state: Any, _parser_state: Any = None) -> Iterator[Token]:
        """Hand the tokens on."""
        return iter(lexer_state)


def _token(word: Word, reading: Reading) -> Token:
    return Token(reading.word_class, reading.meaning, start_pos=word.start, end_pos=word.end)


def _feed(state: InteractiveParser, token: Token) -> InteractiveParser | None:
    following: InteractiveParser = copy.copy(state)
    try:
        following.feed_token(token)
    except UnexpectedInput:
        return None
    return following


def _finish(state: InteractiveParser) -> ParseTree | None:
    try:
        tree: ParseTree = copy.copy(state).feed_token(Token("$END", ""))
    except UnexpectedInput:
        return None
    return tree
