"""The grammar, and the search for the parses of a sentence whose words may have several readings."""

from __future__ import annotations

import importlib.resources
from collections.abc import Callable, Iterator, Sequence
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
        alive = [_Partial(self._lark.parse_interactive([]), ())]
        for position, word in enumerate(words):
            following = [
                fed
                for partial in alive
                for reading in word.readings
                if (fed := partial.fed(_token(word, reading))) is not None
            ]
            if not following:
                return NoParse(position, self._expected(alive))
            if len(following) > MAX_ALTERNATIVES:
                raise TooManyParsesError
            alive = following
        complete = [partial.tokens for partial in alive if partial.fed(Token("$END", "")) is not None]
        if not complete:
            return NoParse(len(words), self._expected(alive))
        return [self._tree(tokens) for tokens in complete]

    def _tree(self, tokens: tuple[Token, ...]) -> ParseTree:
        state = self._lark.parse_interactive([])
        for token in tokens:
            state.feed_token(token)
        tree: ParseTree = state.feed_token(Token("$END", ""))
        return tree

    def _expected(self, alive: Sequence[_Partial]) -> frozenset[str]:
        fits = (name for name in self._names if any(partial.fed(Token(name, "")) for partial in alive))
        return frozenset(fits)


_fork: Callable[..., InteractiveParser] = InteractiveParser.copy


@dataclass(frozen=True, slots=True)
class _Partial:
    """The beginning of a parse: only what may follow is asked of ``state``.

    Forks share the trees built so far, which is cheap, and why the final tree is built anew.
    """

    state: InteractiveParser
    tokens: tuple[Token, ...]

    def fed(self, token: Token) -> _Partial | None:
        """One token further, or None when it does not fit."""
        following = _fork(self.state, deepcopy_values=False)
        try:
            following.feed_token(token)
        except UnexpectedInput:
            return None
        return _Partial(following, (*self.tokens, token))


class _ReadyTokens(Lexer):
    """The words are tokens already."""

    def __init__(self, lexer_conf: Any) -> None:
        """Take what Lark hands to every lexer; nothing of it is needed."""

    def lex(self, lexer_state: Any, _parser_state: Any = None) -> Iterator[Token]:
        """Hand the tokens on."""
        return iter(lexer_state)


def _token(word: Word, reading: Reading) -> Token:
    return Token(reading.word_class, reading.meaning, start_pos=word.start, end_pos=word.end)
