"""Why a sentence that nobody could read is refused: the words that caused it, and a wording that works."""

from __future__ import annotations

import difflib
from collections.abc import Callable, Iterator, Mapping

from executive.language.chart import Chart
from executive.language.lattice import Lattice
from executive.meaning import Refusal
from executive.vocabulary import Vocabulary

EXAMPLES = (
    "pick up the red cup",
    "pick up the red cup on the table",
    "pick up the blue box with the left hand",
    "put the red cup on the shelf",
    "put the ball in the box",
    "bring me the bottle",
    "hand the cup to Ana",
    "open the fridge",
    "close the drawer",
    "walk to the kitchen",
    "move forward 1 meter",
    "turn left",
    "wave to Ana",
    "point at the bottle",
    "look at the cup",
    "find the red cup",
    "count the cups on the table",
    "what is on the table",
    "say hello to Ana",
    "wait 5 seconds",
    "go home",
    "stop",
)
"""Valid wordings to offer when nothing nearer is found."""

_VERBS = frozenset({"PICK", "PUT", "OPEN", "WALK", "STOP"})
_NOUNS = frozenset({"KIND", "THING"})
_LINK = "LINK"
_NEVER_USED = frozenset(
    {"NEGATION", "CONTRAST", "CONDITION", "LIMITLESS", "DOUBT", "HESITATION", "SECOND_THOUGHT"}
)
"""Word classes that decide a refusal wherever they stand before the place that broke the parse."""

_DECIDING = frozenset({"HARM", "THROW"})
"""Word classes that explain a refusal better than the place that broke the parse, when nothing else does."""

_BEFORE_A_CLAUSE = frozenset({"and", "then", ",", ".", ";"})

_BEFORE_ADJECTIVES = frozenset({"DET", "COLOR", "SIZE", "ANOTHER"})

_SHOWN = 40
"""Characters of an offending word that are repeated to the user."""

_LONGEST_TYPO = 24
_CORRECTIONS = 8
"""Corrections of an unknown word that are tried."""


def printable(word: str) -> str:
    """A word that may be shown: bounded, with escapes for what a terminal could take for control."""
    short = word if len(word) <= _SHOWN else word[:_SHOWN] + "\u2026"
    return "".join(one if one.isprintable() else f"\\x{ord(one):02x}" for one in short)


class Explainer:
    """Finds the words that caused a refusal."""

    def __init__(self, vocabulary: Vocabulary, is_valid: Callable[[str], bool]) -> None:
        self._vocabulary, self._is_valid = vocabulary, is_valid
        self._left: dict[int, dict[str, list[str]]] = {}

    def explain(self, lattice: Lattice, chart: Chart) -> Refusal:
        """Why there is no parse."""
        plain, position = lattice.plain, chart.furthest
        unknown = lattice.unknown()
        if unknown is not None:
            refusal, corrected = self._unknown(lattice, unknown)
            known = unknown <= position and not _is_conditional(lattice, unknown)
            if corrected or known or self._refused(lattice, chart) is None:
                return refusal
        verbless = lattice.pieces and not chart.has_beginning_of("command")
        no_skill = self._no_skill(lattice, chart)
        if verbless and no_skill is None and self._refused(lattice, chart) is None:
            shown = printable(lattice.pieces[0].text)
            message = f"a command begins with what to do, not with {shown!r}"
            return Refusal(message, shown, self.nearest_example(plain))
        ended = position >= len(lattice.pieces) or lattice.ends[position]
        found = None if ended else self._refused(lattice, chart)
        found = found or self._refused(lattice, chart, only=_DECIDING)
        found = found or no_skill
        if found is None and ended:
            return self._incomplete(lattice, chart)
        if found is not None:
            word, message = found
            return Refusal(message, word, None)
        shown = printable(lattice.pieces[position].text)
        if position == 0 and chart.expected >= _VERBS:
            message = f"a command begins with what to do, not with {shown!r}"
        else:
            before = lattice.pieces[position - 1] if position else None
            place = "here" if before is None or before.is_mark else f"after {printable(before.text)!r}"
            message = f"{shown!r} does not fit {place}"
        return Refusal(message, shown, self.nearest_example(plain))

    def _incomplete(self, lattice: Lattice, chart: Chart) -> Refusal:
        missing = "an object such as a cup or a box" if chart.expected & _NOUNS else "something"
        if chart.expected >= _VERBS:
            missing = "what to do"
        last = next((piece.text for piece in reversed(lattice.pieces) if not piece.is_mark), lattice.plain)
        message = f"after {printable(last)!r} {missing} is missing"
        if chart.unfit and missing != "what to do":
            message = (
                "the words are known, but together they are no task of this robot; say it in shorter steps"
            )
        return Refusal(message, printable(last), self.nearest_example(lattice.plain))

    def _unknown(self, lattice: Lattice, position: int) -> tuple[Refusal, bool]:
        """Refuse an unknown word; tell also whether a known one in its place makes a valid sentence."""
        piece = lattice.pieces[position]
        shown = printable(piece.text)
        message = f"the word {shown!r} is not known"
        for candidate in self._similar(piece.text):
            corrected = lattice.plain[: piece.start] + candidate + lattice.plain[piece.end :]
            if self._is_valid(corrected):
                return Refusal(f"{message}; did you mean {candidate!r}?", shown, corrected), True
        return Refusal(message, shown, self.nearest_example(lattice.plain)), False

    def _refused(
        self, lattice: Lattice, chart: Chart, only: frozenset[str] | None = None
    ) -> tuple[str, str] | None:
        """The first words, up to where the parse broke off, that are known and never acted on.

        With ``only`` they are of one of these classes.
        """
        last = min(chart.furthest, len(lattice.pieces) - 1)
        phrases = [
            word
            for position in range(last + 1)
            for word in sorted(lattice.phrase(position), key=lambda one: -one.end)
        ]
        harmful = [word for word in phrases if word.word_class in (only or ("HARM",))]
        here = [
            word for word in phrases if word.start <= chart.furthest < word.end and word.word_class != _LINK
        ]
        here.sort(
            key=lambda word: (word.start - word.end, word.word_class != _likely_at(lattice, word.start))
        )
        before = [word for word in phrases if word.start < chart.furthest and word.word_class in _NEVER_USED]
        rest = [word for word in phrases if word.start == chart.furthest]
        for word in (*harmful, *here, *before, *rest):
            if only is None or word.word_class in only:
                said = printable(word.said)
                message = self._vocabulary.refusal_of(word.word_class, word.meaning, said)
                if message is not None:
                    return said, message
        return None

    def _no_skill(self, lattice: Lattice, chart: Chart) -> tuple[str, str] | None:
        """What a clause begins with that is no skill and can be read as nothing else: "clean the cup"."""
        for start in range(min(chart.furthest, len(lattice.pieces))):
            begins = start == 0 or lattice.pieces[start - 1].text in _BEFORE_A_CLAUSE
            if not begins or chart.begins_command(lattice.phrase(start)):
                continue
            for word in lattice.phrase(start):
                message = self._vocabulary.refusal_of(word.word_class, word.meaning, printable(word.said))
                if word.word_class == "NO_SKILL" and message is not None:
                    return printable(word.said), message
        return None

    def _deletions(self, length: int) -> Mapping[str, list[str]]:
        """Known words of a length by what is left of them without one letter."""
        left = self._left.get(length)
        if left is None:
            left = self._left[length] = {}
            for word in self._vocabulary.single_words:
                if len(word) == length:
                    for key in _without_one(word):
                        left.setdefault(key, []).append(word)
        return left

    def _similar(self, word: str) -> Iterator[str]:
        """Known words that differ by a letter or two, nearest first."""
        if not 2 < len(word) <= _LONGEST_TYPO or not word.isalpha():
            return
        near = [self._deletions(length) for length in range(len(word) - 1, len(word) + 2)]
        found = {one for key in _without_one(word) for left in near for one in left.get(key, ())}
        letters = sorted(word)
        ranked = sorted(
            found,
            key=lambda one: (
                -difflib.SequenceMatcher(None, word, one).ratio(),
                sorted(one) != letters,  # two letters that changed places
                one,
            ),
        )
        yield from ranked[:_CORRECTIONS]

    def nearest_example(self, text: str) -> str:
        """The valid wording that looks most like the text."""
        words = set(text[:100].lower().split())
        return max(
            EXAMPLES, key=lambda item: len(words & set(item.lower().split())) / (3 + len(item.split()))
        )


def _likely_at(lattice: Lattice, position: int) -> str:
    """The class of a word that may be a verb or an adjective: "empty the can", "the empty can"."""
    before = lattice.phrase(position - 1) if position else ()
    return "QUALITY" if any(word.word_class in _BEFORE_ADJECTIVES for word in before) else "NO_SKILL"


def _is_conditional(lattice: Lattice, position: int) -> bool:
    """Whether a condition stands before a place, which is the better reason to refuse: "when Ana comes"."""
    before = (word for start in range(position) for word in lattice.phrase(start))
    return any(word.word_class == "CONDITION" for word in before)


def _without_one(word: str) -> set[str]:
    return {word, *(word[:index] + word[index + 1 :] for index in range(len(word)))}
