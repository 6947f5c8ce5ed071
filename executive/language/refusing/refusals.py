"""Why a sentence that nobody could read is refused: the words that caused it, and a wording that works."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace

from executive.language.chart import Chart
from executive.language.refusing.examples import EXAMPLES, is_verb, nearest_example
from executive.language.refusing.mistyped import Mender
from executive.language.refusing.reasons import reason_at
from executive.language.refusing.typos import Typos, is_slip
from executive.language.words.lattice import Lattice
from executive.language.words.piece import Piece
from executive.language.words.word import Word
from executive.meaning import Refusal
from executive.vocabulary import Vocabulary

__all__ = ["EXAMPLES", "Explainer", "printable"]

_VERBS = frozenset({"PICK", "PUT", "OPEN", "WALK", "STOP"})
_NOUNS = frozenset({"KIND", "THING"})
_LINK = "LINK"
_NEVER_USED = frozenset(
    {
        *(
            "NEGATION",
            "CONTRAST",
            "CONDITION",
            "LOOP",
            "LIMITLESS",
            "LEFT_OUT",
            "DOUBT",
            "HESITATION",
            "SECOND_THOUGHT",
        ),
        *("PRAISE", "ASKS_ROBOT"),
    }
)
"""Word classes that decide a refusal wherever they stand before the place that broke the parse."""

_AT_LAST = frozenset({"NEGATION", "CONTRAST", "CONDITION", "LOOP", "PRAISE", "ASKS_ROBOT", "MANNER", "DOUBT"})
"""Word classes that explain a refusal where a sentence only seems to end too early: "don't move it"."""

_DETERMINES = frozenset(
    {"DET", "OWNER", "OWNING", "AMOUNT", "COLOR", "SIZE", "MATERIAL", "ORDINAL", "QUALITY"}
)
_DONE_TO = frozenset(
    {"DET", "OWNER", "OWNING", "NAME", "PERSON", "HIM", "IT", "THEM", "THIS", "ME", "US", "ALL", "BOTH"}
)
"""Word classes that what something is done to begins with."""

_NO_SKILL, _NO_SKILL_OF_A_NOUN = "NO_SKILL", "NO_SKILL_OR_NOUN"
_SOMEBODY = frozenset({"NAME", "PERSON", "HIM"})
_LEADS_TO_DOING = frozenset({"to", "should", "will", "must", "can", "may", "shall", "would", "has", "have"})

_SHORT = 4
"""Letters of a name in which another letter makes another name."""

_TINY = 2
_SMALL_WORDS = frozenset({"DET", "AND", "TO", "IN", "ON", "AT", "OF", "IT", "ME", "FOR", "FROM"})
"""Letters of a word, and word classes of what it may be meant to be then: "th" is "the"."""

_DECIDING = frozenset({"HARM", "THROW", "HELPS_BODY", "ASKS_WHO", "PART_OF"})
"""Word classes that explain a refusal better than the place that broke the parse, when nothing else does."""

_ONLY_PRAISED = frozenset({"PRAISED"})
"""Word classes of which a sentence is that asks for nothing, when nothing else explains it."""

_BEFORE_A_CLAUSE = frozenset({"and", "then", ",", ".", ";"})

_BEFORE_ADJECTIVES = frozenset({"DET", "COLOR", "SIZE", "ANOTHER"})

_SHOWN = 40
"""Characters of an offending word that are repeated to the user."""


def printable(word: str) -> str:
    """A word that may be shown: bounded, with escapes for what a terminal could take for control."""
    short = word if len(word) <= _SHOWN else word[:_SHOWN] + "\u2026"
    return "".join(one if one.isprintable() else f"\\x{ord(one):02x}" for one in short)


class Explainer:
    """Finds the words that caused a refusal."""

    def __init__(
        self, vocabulary: Vocabulary, is_valid: Callable[[str], bool], is_asked: Callable[[str], bool]
    ) -> None:
        self._vocabulary, self._is_valid = vocabulary, is_valid
        self._typos = Typos(vocabulary)
        self._mender = Mender(self._typos, self._may_be_meant, is_valid, is_asked)

    def explain(self, lattice: Lattice, chart: Chart) -> Refusal:
        """Why there is no parse."""
        plain, position = lattice.plain, chart.furthest
        unknown = lattice.unknown()
        no_skill = self._no_skill(lattice, chart)
        if unknown is not None and (no_skill is None or unknown < no_skill.start):
            refusal, corrected = self._unknown(lattice, unknown)
            known = unknown <= position and not _is_conditional(lattice, unknown)
            if corrected or known or self._refused(lattice, chart) is None:
                return refusal
        verbless = lattice.pieces and not chart.has_beginning_of("command")
        if verbless and no_skill is None and self._refused(lattice, chart) is None:
            denied = self._anywhere(lattice)
            if denied is not None:
                return Refusal(denied[1], denied[0], None)
            shown = printable(lattice.pieces[lattice.first_said].text)
            message = f"a command begins with what to do, not with {shown!r}"
            return Refusal(message, shown, self.nearest_example(plain))
        ended = position >= len(lattice.pieces) or lattice.ends[position]
        found = self._somebody_else(lattice, chart)
        if no_skill is not None and _is_done(lattice, no_skill) and lattice.may_begin(no_skill.start):
            found = found or self._refused(lattice, chart, only=_DECIDING | _NEVER_USED)
            found = found or (printable(no_skill.said), self._said_of(no_skill))
        found = found or (None if ended else self._refused(lattice, chart))
        found = found or self._refused(lattice, chart, only=_DECIDING)
        found = found or (self._refused(lattice, chart, only=_AT_LAST) if ended else None)
        if found is None and no_skill is not None:
            found = printable(no_skill.said), self._said_of(no_skill)
        if found is None or self._is_link(found):
            found = reason_at(lattice, position) or found
        found = found or (self._refused(lattice, chart, only=_ONLY_PRAISED) if ended else None)
        if found is None and ended:
            return self._incomplete(lattice, chart)
        if found is not None:
            word, message = found
            return Refusal(message, word, None)
        denied = self._anywhere(lattice) if position == 0 else None
        if denied is not None:
            return Refusal(denied[1], denied[0], None)
        shown = printable(lattice.pieces[position or lattice.first_said].text)
        if position == 0 and chart.expected >= _VERBS:
            message = f"a command begins with what to do, not with {shown!r}"
        else:
            before = lattice.pieces[position - 1] if position else None
            place = "here" if before is None or before.is_mark else f"after {printable(before.text)!r}"
            message = f"{shown!r} does not fit {place}"
        return Refusal(message, shown, self.nearest_example(plain))

    def _is_link(self, found: tuple[str, str]) -> bool:
        """Whether a refusal says no more than that a small word does not fit."""
        return found[1] == self._vocabulary.refusal_of(_LINK, "link", found[0])

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
        shown = printable(lattice.pieces[position].text)
        message = f"the word {shown!r} is not known"
        mended = self._mender.mended(lattice.plain, lattice.pieces, lattice.unknown_pieces())
        if mended is not None:
            nearest = mended.sentence if mended.is_valid else self.nearest_example(mended.sentence)
            if nearest is not None:
                return Refusal(f"{message}; did you mean {mended.word!r}?", shown, nearest), mended.is_valid
        return Refusal(message, shown, self.nearest_example(lattice.plain)), False

    def is_mistyped(self, plain: str, piece: Piece) -> bool:
        """Whether what looks like a name is rather a known word, of which the text makes a valid sentence.

        A name that is only like a listed one is a name of its own: "Theodora" is not "Theodore".
        """
        word = piece.text.removesuffix("'s")
        found = self._corrections(plain, replace(piece, text=word, end=piece.start + len(word)))
        return any(is_slip(word, one) or not self._is_only_a_name(one) for one, _ in found)

    def _corrections(self, plain: str, piece: Piece) -> Iterator[tuple[str, str]]:
        """Known words that make a valid sentence in the place of an unknown one, with that sentence."""
        for candidate in self._typos.corrections(piece.text):
            corrected = plain[: piece.start] + candidate + plain[piece.end :]
            if self._may_be_meant(piece.text, candidate) and self._is_valid(corrected):
                yield candidate, corrected

    def _may_be_meant(self, text: str, candidate: str) -> bool:
        """Whether a known word may be meant by an unknown one: "omi" is not "oma"."""
        if len(text) <= _TINY:
            return not _SMALL_WORDS.isdisjoint(self._classes(candidate))
        is_name = len(candidate) <= _SHORT and self._is_somebody(candidate)
        return not is_name or is_slip(text, candidate)

    def _is_only_a_name(self, word: str) -> bool:
        return self._classes(word) <= {"NAME", "OWNER"}

    def _is_somebody(self, word: str) -> bool:
        return not _SOMEBODY.isdisjoint(self._classes(word))

    def _classes(self, word: str) -> set[str]:
        return {reading.word_class for _, reading in self._vocabulary.matches([word], 0)}

    def _refused(
        self, lattice: Lattice, chart: Chart, only: frozenset[str] | None = None
    ) -> tuple[str, str] | None:
        """The first words, up to where the parse broke off, that are known and never acted on.

        With ``only`` they are of one of these classes.
        """
        broken = max(chart.furthest, lattice.first_said)
        last = min(broken, len(lattice.pieces) - 1)
        phrases = [
            word
            for position in range(last + 1)
            for word in sorted(lattice.phrase(position), key=lambda one: -one.end)
            if word.word_class != _NO_SKILL_OF_A_NOUN
        ]
        if any(word.word_class == "QUALITY" and word.start == last for word in phrases):
            other = "NO_SKILL" if self._is_adjective(lattice, last) else "QUALITY"
            phrases = [one for one in phrases if (one.word_class, one.start) != (other, last)]
        harmful = [word for word in phrases if word.word_class in (only or ("HARM",))]
        here = [word for word in phrases if word.start <= broken < word.end and word.word_class != _LINK]
        here.sort(
            key=lambda word: (word.start - word.end, word.word_class != _likely_at(lattice, word.start))
        )
        before = [word for word in phrases if word.start < broken and word.word_class in _NEVER_USED]
        rest = [word for word in phrases if word.start == broken]
        own = [word for word in phrases if word.start == 0 and word.word_class == "SAID_OF_ONESELF"]
        for word in (*harmful, *here, *before, *own, *rest):
            if only is None or word.word_class in only:
                said = printable(word.said)
                message = self._vocabulary.refusal_of(word.word_class, word.meaning, said)
                if message is not None:
                    return said, message
        return None

    def _is_adjective(self, lattice: Lattice, position: int) -> bool:
        """Whether a word that may be a verb too stands where it says how a thing is: "the empty can"."""
        if not 0 < position < len(lattice.pieces):
            return True
        here = {word.word_class for word in lattice.phrase(position)}
        before = {word.word_class for word in lattice.phrase(position - 1) if word.end == position}
        may_be_done = "NO_SKILL" in here or self._begins(lattice.phrase(position))
        return bool(before & _DETERMINES) or not may_be_done

    @staticmethod
    def _begins(words: Sequence[Word]) -> bool:
        return any(is_verb(word.word_class) for word in words)

    def _somebody_else(self, lattice: Lattice, chart: Chart) -> tuple[str, str] | None:
        """Who is told to do something that this robot is not: "let Ana open the fridge"."""
        pieces = lattice.pieces
        for start in range(min(chart.furthest + 2, len(pieces))):
            if any(word.word_class in _NEVER_USED for word in lattice.phrase(start)):
                return None  # "when Ana comes, wave"
            for word in lattice.phrase(start):
                does = word.end
                while does < len(pieces) and pieces[does].text in _LEADS_TO_DOING:
                    does += 1
                later = chart.furthest <= does < len(pieces)
                if word.word_class in _SOMEBODY and later and self._begins(lattice.phrase(does)):
                    who = printable(word.said)
                    return who, f"{who!r} is somebody else: only what this robot does itself can be told"
        return None

    def _anywhere(self, lattice: Lattice) -> tuple[str, str] | None:
        """The first words of the sentence that deny, or make it depend: "please don't wake the baby"."""
        for start in range(len(lattice.pieces)):
            for word in sorted(lattice.phrase(start), key=lambda one: -one.end):
                if word.word_class in _AT_LAST:
                    said = printable(word.said)
                    return said, self._vocabulary.refusal_of(word.word_class, word.meaning, said) or ""
        return None

    def lacks_skill(self, lattice: Lattice, chart: Chart) -> bool:
        """Whether a clause begins with what is no skill and can be read as nothing else."""
        return self._no_skill(lattice, chart) is not None

    def _no_skill(self, lattice: Lattice, chart: Chart) -> Word | None:
        """What a clause begins with that is no skill and can be read as nothing else: "clean the cup"."""
        for start in range(min(max(chart.furthest, lattice.first_said) + 1, len(lattice.pieces))):
            begins = lattice.may_begin(start) or lattice.pieces[start - 1].text in _BEFORE_A_CLAUSE
            words = lattice.phrase(start) if begins else ()
            done = next((word for word in words if _is_done(lattice, word)), None)
            if done is None and not chart.begins_command(words):
                done = next((word for word in words if word.word_class == _NO_SKILL), None)
            if done is not None:
                return done
        return None

    def _said_of(self, word: Word) -> str:
        """What a refused word is refused with."""
        return self._vocabulary.refusal_of(word.word_class, word.meaning, printable(word.said)) or ""

    def nearest_example(self, text: str) -> str | None:
        """A valid wording of what a text says to do."""
        return nearest_example(text, self._vocabulary)


def _is_done(lattice: Lattice, word: Word) -> bool:
    """Whether a word is no skill that may be a thing too, or to walk: what it is done to follows then."""
    if word.word_class != _NO_SKILL_OF_A_NOUN:
        return False
    is_more = any(
        one.end >= word.end and one.word_class != word.word_class for one in lattice.phrase(word.start)
    )
    return not is_more or lattice.begins_with(word.end, _DONE_TO)


def _likely_at(lattice: Lattice, position: int) -> str:
    """The class of a word that may be a verb or an adjective: "empty the can", "the empty can"."""
    before = lattice.phrase(position - 1) if position else ()
    return "QUALITY" if any(word.word_class in _BEFORE_ADJECTIVES for word in before) else "NO_SKILL"


def _is_conditional(lattice: Lattice, position: int) -> bool:
    """Whether a condition stands before a place, which is the better reason to refuse: "when Ana comes"."""
    before = (word for start in range(position) for word in lattice.phrase(start))
    return any(word.word_class in ("CONDITION", "LOOP") for word in before)
