"""From a sentence to commands, a question, or a refusal. Never an exception, never half understood."""

from __future__ import annotations

import difflib
from collections.abc import Iterator
from functools import lru_cache, partial
from typing import Any

from lark import Token, Tree

from executive.grammar import Grammar, NoParse, ParseTree, TooManyParsesError
from executive.meaning import Command, Parsed, Question, Refusal, StopCommand
from executive.tokens import UNKNOWN, MalformedTextError, Word, normalise, words_of
from executive.vocabulary import Vocabulary, load_vocabulary
from kinematics.robot_description import HANDS
from trees.extensions import extensions
from trees.tasks import GoHomeTask, ObjectDescription, PickTask

EXAMPLES = (
    "pick up the red cup",
    "pick up the red cup on the table",
    "pick up the blue box with the left hand",
    "go home",
    "stop",
)
"""Valid wordings to offer when nothing nearer is found."""

_VERBS = frozenset({"PICK", "PICK_UP", "GO_HOME", "STOP"})
_SHOWN = 40
"""Characters of an offending word that are repeated to the user."""


LONGEST_PHRASE = 200
"""Characters of a sentence that is offered to skills of other packages."""


def parse(text: str) -> Parsed:
    """Understand one text. It is untrusted: any string gives an answer."""
    parsed = _parser().parse(text)
    if parsed.refusal is not None and len(text) <= LONGEST_PHRASE:
        outside: Any = extensions().for_phrase(text)
        if outside is not None:
            return Parsed(text, commands=(outside,))
    return parsed


@lru_cache(maxsize=1)
def _parser() -> CommandParser:
    return CommandParser(load_vocabulary())


class _ContradictionError(Exception):
    """The sentence says two different things about one slot."""

    def __init__(self, first: str, second: str) -> None:
        self.first, self.second = first, second
        super().__init__(first, second)


class _UnspecifiedError(Exception):
    """The sentence leaves open what to act on."""


class CommandParser:
    """Vocabulary and grammar, ready to parse."""

    def __init__(self, vocabulary: Vocabulary) -> None:
        self.vocabulary = vocabulary
        self._grammar = Grammar(vocabulary)

    def parse(self, text: str) -> Parsed:
        """Understand one text."""
        try:
            plain = normalise(text)
            words = words_of(plain, self.vocabulary)
        except MalformedTextError as malformed:
            return Parsed(text, refusal=Refusal(malformed.message, malformed.word, EXAMPLES[0]))
        try:
            found = self._grammar.parses(words)
        except TooManyParsesError:
            message = "the sentence can be read in too many ways"
            return Parsed(text, refusal=Refusal(message, None, EXAMPLES[0]))
        if isinstance(found, NoParse):
            return Parsed(text, refusal=self._explain(plain, words, found))
        return self._meaning(text, plain, found)

    def _is_valid(self, plain: str) -> bool:
        """Whether a sentence makes tasks; unlike ``parse`` it explains nothing, so it never recurs."""
        try:
            found = self._grammar.parses(words_of(plain, self.vocabulary))
        except (MalformedTextError, TooManyParsesError):
            return False
        return not isinstance(found, NoParse) and bool(self._meaning(plain, plain, found).commands)

    def _meaning(self, text: str, plain: str, trees: list[ParseTree]) -> Parsed:
        try:
            meanings = {tuple(_commands(tree, plain)) for tree in trees}
        except _ContradictionError as two:
            message = f"{two.first!r} and {two.second!r} contradict each other"
            return Parsed(text, refusal=Refusal(message, two.second, EXAMPLES[0]))
        except _UnspecifiedError:
            return Parsed(text, question=Question("which object shall be picked up?"))
        if len(meanings) > 1:
            return Parsed(text, question=Question("this can be read in several ways; which is meant?"))
        return Parsed(text, commands=meanings.pop())

    def _explain(self, plain: str, words: list[Word], found: NoParse) -> Refusal:
        if found.position >= len(words):
            return self._incomplete(plain, words, found)
        word = words[found.position]
        unknown = next((item for item in words if item.readings[0].word_class == UNKNOWN), None)
        if unknown is not None:
            refusal, corrected = self._unknown(plain, words, unknown, found)
            if corrected or word is unknown or not self._refused(word, found):
                return refusal
        return self._misplaced(word, found)

    def _incomplete(self, plain: str, words: list[Word], found: NoParse) -> Refusal:
        missing = "an object such as a cup or a box" if "KIND" in found.expected else "something"
        if found.expected & _VERBS:
            missing = "what to do"
        last = words[-1].text if words else plain
        message = f"after {printable(last)!r} {missing} is missing"
        return Refusal(message, printable(last), self._nearest_example(plain))

    def _unknown(self, plain: str, words: list[Word], word: Word, found: NoParse) -> tuple[Refusal, bool]:
        """Refuse an unknown word; tell also whether a known one in its place makes a valid sentence."""
        shown = printable(word.text)
        message = f"the word {shown!r} is not known"
        expected = found.expected if words[found.position] is word else frozenset[str]()
        for candidate in self._similar(word.text, expected):
            corrected = plain[: word.start] + candidate + plain[word.end :]
            if self._is_valid(corrected):
                return Refusal(f"{message}; did you mean {candidate!r}?", shown, corrected), True
        return Refusal(message, shown, self._nearest_example(plain)), False

    def _misplaced(self, word: Word, found: NoParse) -> Refusal:
        shown = printable(word.text)
        message = self._refused(word, found)
        if message is not None:
            return Refusal(message, shown, None)
        if found.expected & _VERBS:
            return Refusal(f"a command begins with what to do, not with {shown!r}", shown, EXAMPLES[0])
        return Refusal(f"{shown!r} does not fit here", shown, EXAMPLES[0])

    def _refused(self, word: Word, found: NoParse) -> str | None:
        """Why a known word is not acted on; a verb where verbs are expected, else whatever else it is."""
        verb_expected = bool(found.expected & _VERBS)
        readings = sorted(word.readings, key=lambda item: (item.word_class == "NO_SKILL") != verb_expected)
        for reading in readings:
            if reading.word_class == UNKNOWN:
                continue
            message = self.vocabulary.refusal(reading, printable(word.text))
            if message is not None:
                return message
        return None

    def _similar(self, word: str, expected: frozenset[str]) -> Iterator[str]:
        """Known words that look like this one: first those of the classes that would fit."""
        short = word[:_SHOWN]
        names = sorted(expected & set(self.vocabulary.classes))
        fitting = [phrase for name in names for phrase in self.vocabulary.phrases(name)]
        for candidates in (fitting, sorted(self.vocabulary.single_words)):
            yield from difflib.get_close_matches(short, candidates, n=3, cutoff=0.6)

    def _nearest_example(self, plain: str) -> str:
        return max(EXAMPLES, key=lambda item: difflib.SequenceMatcher(None, item, plain[:100]).ratio())


def printable(word: str) -> str:
    """A word that may be shown: bounded, with escapes for what a terminal could take for control."""
    short = word if len(word) <= _SHOWN else word[:_SHOWN] + "…"
    return "".join(one if one.isprintable() else f"\\x{ord(one):02x}" for one in short)


def _commands(tree: ParseTree, plain: str) -> Iterator[Command]:
    for branch in tree.children:
        if not isinstance(branch, Tree) or branch.data == "opening":
            continue
        text = plain[branch.meta.start_pos : branch.meta.end_pos]
        match branch.data:
            case "pick":
                yield _pick(branch, text)
            case "go_home":
                yield GoHomeTask(text)
            case "stop":
                yield StopCommand(text)


def _pick(branch: ParseTree, text: str) -> PickTask:
    if any(True for _ in branch.find_data("vague")):
        raise _UnspecifiedError
    kinds, colors, sources, sides = (
        [str(token) for token in branch.scan_values(partial(_is, name))]
        for name in ("KIND", "COLOR", "FURNITURE", "SIDE")
    )
    kind, color = _only(kinds), _only(colors)
    if kind is None and color is None:
        raise _UnspecifiedError
    side = _only(sides)
    hand = next((name for name in HANDS if name == side), None)
    return PickTask(text, ObjectDescription(kind, color), _only(sources), hand)


def _is(name: str, token: object) -> bool:
    return isinstance(token, Token) and token.type == name


def _only(values: list[str]) -> str | None:
    for value in values[1:]:
        if value != values[0]:
            raise _ContradictionError(values[0], value)
    return values[0] if values else None
