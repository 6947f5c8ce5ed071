"""From a sentence to commands, a question, or a refusal. Never an exception, never half understood."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import lru_cache
from pathlib import Path
from types import MappingProxyType
from typing import Any

from executive.config import cache_directory, config_files
from executive.language.chart.chart import Chart, TooTangledError
from executive.language.chart.grammar import Rule, load_rules
from executive.language.chart.meanings import MEANINGS as SENTENCES
from executive.language.chart.outcomes import Outcome, explains_best, outcomes_of
from executive.language.commands.selection import MEANINGS as SELECTIONS
from executive.language.commands.selection import Selection, description_of
from executive.language.explain.missing import what_is_missing
from executive.language.explain.refusals import Explainer, examples, printable
from executive.language.phrases.values import Nominal, Trouble
from executive.language.text.lattice import Lattice
from executive.language.text.names import looks_like_a_name
from executive.language.text.tokens import MalformedTextError, normalise, pieces_of
from executive.language.text.word import Piece
from executive.meaning import Command, Parsed, Question, Refusal, wording
from executive.vocabulary import NOWHERE, PlaceWords, Vocabulary, load_vocabulary
from executive.vocabulary.place_words import place_words
from executive.vocabulary.written import split_words
from trees.tasks import ObjectDescription, SayTask

__all__ = ["CommandParser", "examples", "parse", "parse_selection", "parser_with", "printable"]

_MEANINGS = MappingProxyType({**SENTENCES, **SELECTIONS})


LONGEST_PHRASE = 200
"""Characters of a sentence that is offered to skills of other packages."""


def parse(text: str, config: Path | None = None, *, remembers: bool = False) -> Parsed:
    """Understand one text. It is untrusted: any string gives an answer.

    Args:
        text: What was said.
        config: A file with words of the user's own, besides that of the configuration folder.
        remembers: Whether who does it will remember where things were that it picked up: "put it back".

    Raises:
        VocabularyError: A file of words is malformed.
    """
    parsed = parser_with(config_files(config), place_words()).parse(text, remembers)
    if parsed.refusal is not None and len(text) <= LONGEST_PHRASE:
        from trees.extensions import extensions  # it looks through all packages: only when it is asked

        outside: Any = extensions().for_phrase(text)
        if outside is not None:
            return Parsed(text, commands=(outside,))
    return parsed


def parse_selection(text: str) -> ObjectDescription | None:
    """Understand an answer that tells one thing from others: "the left one", "red", "the cup by the box".

    None when it is no such answer.
    """
    return parser_with(config_files(), place_words()).parse_selection(text)


@lru_cache(maxsize=4)
def parser_with(user_files: tuple[Path, ...] = (), place: PlaceWords = NOWHERE) -> CommandParser:
    """The parser with a user's own words, and those of a place.

    Args:
        user_files: Word lists of the user's.
        place: What its things and its people are called.

    Raises:
        VocabularyError: A file of words is malformed.
    """
    vocabulary = load_vocabulary(user_files, cache_directory())
    if place != NOWHERE:
        from executive.vocabulary.of_place import of_place  # a mere sentence needs none

        vocabulary = of_place(vocabulary, place)
    return CommandParser(vocabulary, _rules())


@lru_cache(maxsize=1)
def _rules() -> Mapping[str, Rule]:
    return load_rules(cache_directory())


class CommandParser:
    """Vocabulary and grammar, ready to parse."""

    def __init__(self, vocabulary: Vocabulary, rules: Mapping[str, Rule]) -> None:
        self.vocabulary = vocabulary
        self._rules = rules
        self._verbs = rules["command"].first
        self._explainer = Explainer(vocabulary)

    def parse(self, text: str, remembers: bool = False) -> Parsed:
        """Understand one text; a line that ends without a mark ends a sentence."""
        try:
            lattice = self._lattice(text)
            chart = self._chart(lattice)
            outcomes = outcomes_of(chart.meanings(), self._people_in, self.may_command, remembers)
        except MalformedTextError as malformed:
            return Parsed(text, refusal=Refusal(malformed.message, malformed.word, examples()[0]))
        except TooTangledError as tangled:
            return Parsed(text, refusal=Refusal(str(tangled), None, examples()[0]))
        if not outcomes:
            missing = what_is_missing(lattice, chart)
            if missing is not None and not self._explainer.forbids(lattice, chart):
                return Parsed(text, question=missing)
            return Parsed(text, refusal=self._explainer.explain(lattice, chart))
        return self._answer(text, outcomes, lattice.manners())

    def parse_selection(self, text: str) -> ObjectDescription | None:
        """Understand an answer that tells one thing from others."""
        try:
            found = self._chart(self._lattice(text)).meanings("selection")
        except (MalformedTextError, TooTangledError):
            return None
        selections = {description_of(one) for one in found if isinstance(one, Selection)} - {None}
        return selections.pop() if len(selections) == 1 else None

    def _lattice(self, text: str) -> Lattice:
        plain = normalise(text)
        return Lattice(plain, pieces_of(plain), self.vocabulary, self._explainer.is_mistyped)

    def _chart(self, lattice: Lattice) -> Chart:
        return Chart(self._rules, _MEANINGS, lattice)

    def may_command(self, text: str) -> bool:
        """Whether some words begin as a command does."""
        said = [word for word, _, _ in split_words(text)]
        first = self.vocabulary.matches(said, 0) if said else ()
        return any(reading.word_class in self._verbs for _, reading in first)

    def _people_in(self, text: str) -> tuple[Nominal, ...]:
        """Who is named in words to say, so that "him" after them may be somebody else than who is told."""
        pieces = [Piece(word, start, end) for word, start, end in split_words(text)]
        said = [piece.text for piece in pieces]
        listed = tuple(
            Nominal("name" if reading.word_class == "NAME" else "person", reading.meaning, determined=True)
            for start in range(len(said))
            for _, reading in self.vocabulary.matches(said, start)
            if reading.word_class in ("NAME", "PERSON")
        )
        unlisted = (
            Nominal("name", text[piece.start : piece.end].removesuffix("'s"), determined=True)
            for piece in pieces
            if looks_like_a_name(piece, text, self.vocabulary)
        )
        return (*listed, *unlisted)

    def _answer(self, text: str, outcomes: Sequence[Outcome], manners: tuple[str, ...]) -> Parsed:
        understood = [one for one in outcomes if not isinstance(one, Trouble)]
        if len(understood) == 1:
            spoken = [one.words for one in understood[0] if isinstance(one, SayTask)]
            unsaid = tuple(word for word in manners if not any(word in words.lower() for words in spoken))
            return Parsed(text, commands=understood[0], manners=unsaid)
        if understood:
            told = [", then ".join(map(wording, commands)) for commands in understood]
            if len(set(told)) < len(told):  # the same words, and different things to do
                told = [", then ".join(map(_with_action, commands)) for commands in understood]
            choices = tuple(dict.fromkeys(told))
            several = "this can be read in several ways; which is meant?"
            return Parsed(text, question=Question(several, choices if len(choices) > 1 else ()))
        troubles = [one for one in outcomes if isinstance(one, Trouble)]
        trouble = min(troubles, key=explains_best)
        if trouble.asks:
            return Parsed(text, question=Question(trouble.message, trouble.choices))
        word = None if trouble.word is None else printable(trouble.word)
        return Parsed(text, refusal=Refusal(trouble.message, word, self._explainer.nearest_example(text)))


def _with_action(command: Command) -> str:
    """A command in words that tell it from another with the same."""
    return f"{command.action.replace('_', ' ')} ({wording(command)})"
