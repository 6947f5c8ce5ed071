"""What a person has said, as the vocabulary reads it: which things, colours, names and numbers it names."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from executive.config import config_files
from executive.understanding.command_parser import parser_with
from executive.vocabulary.place_words import place_words
from executive.vocabulary.written import split_words

_NUMBERS = ("AMOUNT", "NUM", "TENS", "HALF", "QUARTER", "QUARTERS", "AND_A_HALF", "COUPLE")
_UNITS = ("LENGTH", "TIME", "ANGLE", "LINEAR_SPEED", "ANGULAR_SPEED")
_NAMING = (
    *("KIND", "KINDS", "SUBSTANCE", "PAIR", "PAIRS", "CONTAINER", "DOOR", "FURNITURE", "PERSON", "ROOM"),
    *("NAME", "OTHER_PLACE", "COLOR", "GARMENT", "TITLE", "KIN_TITLE", "ANIMAL", "TRAIT", "MATERIAL", "SIZE"),
    *("COMPARED", "ORDINAL", "ANOTHER", "NEAREST", "LEFT_RIGHT", "ALL", "BOTH"),
)
"""Word classes of what is named. The words of a longer phrase of another class, "can you", name nothing."""


class SaidWords:
    """The words of a person, with what they mean by the vocabulary.

    Args:
        texts: The sentence, and every answer.
    """

    def __init__(self, texts: Iterable[str]) -> None:
        self._vocabulary = parser_with(config_files(), place_words()).vocabulary
        self._words: set[str] = set()
        self._meanings: set[str] = set()
        self.factors = {1.0}
        self.amounts: set[float] = {1.0}
        for text in texts:
            self._take([word.removesuffix("'s") for word, _, _ in split_words(text.replace("’", "'"))])

    def names(self, value: str) -> bool:
        """Whether a thing, a colour, a name or a place was named, by this word or a synonym.

        Args:
            value: In any case; of several words all must have been said where they are no phrase together.
        """
        words = [word for word, _, _ in split_words(value.replace("_", " "))]
        if not words or " ".join(words) in self._meanings:
            return True
        length, readings = self._vocabulary.match(words)
        if length == len(words) and any(one.meaning in self._meanings for one in readings):
            return True
        if len(words) == 1:
            return words[0] in self._words
        return all(self.names(word) for word in words)

    def says(self, word: str) -> bool:
        """Whether a word was said as it is, or in another form of it."""
        return word in self._words or any(_same_stem(word, one) for one in self._words)

    def measures(self, value: float) -> bool:
        """Whether a number was said, in whatever of the units that were said."""
        return any(
            abs(value - number * factor) <= 1e-3 * abs(value) + 1e-9
            for number in self.amounts
            for factor in self.factors
        )

    def _take(self, words: Sequence[str]) -> None:
        index, before = 0, (-1, 0.0)
        while index < len(words):
            matches = list(self._vocabulary.matches(words, index))
            longest = max((n for n, one in matches if one.word_class not in _NAMING), default=1)
            for length, reading in matches:
                if reading.word_class in _NAMING and length >= longest:
                    self._meanings.add(reading.meaning)
                    self._words.update(words[index : index + length])
                elif reading.word_class in _UNITS:
                    self.factors.add(float(reading.meaning))
            number = self._number(words, index)
            if number is not None:
                self.amounts.add(number)
                if before[0] == index - 1:
                    self.amounts.add(before[1] + number)
                before = (index, number)
            if longest == 1:
                self._words.add(words[index])
            index += longest

    def _number(self, words: Sequence[str], index: int) -> float | None:
        try:
            return float(words[index])
        except ValueError:
            pass
        readings = [one for _, one in self._vocabulary.matches(words, index) if one.word_class in _NUMBERS]
        for reading in readings:
            try:
                return float(reading.meaning)
            except ValueError:
                continue
        return None


def _same_stem(one: str, other: str) -> bool:
    """Whether two words differ in an ending alone: "dinners" and "dinner"."""
    short, long = sorted((one, other), key=len)
    return len(short) >= 4 and long.startswith(short) and len(long) - len(short) <= 2
