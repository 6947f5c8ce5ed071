"""A clause that says why, and the words that tell what such a clause may do."""

from __future__ import annotations

import importlib.resources
import tomllib
from collections.abc import Sequence
from collections.abc import Set as AbstractSet
from dataclasses import dataclass
from functools import cache

from executive.language.words.piece import Piece
from executive.vocabulary import Reading, Vocabulary

THINGS = frozenset(
    {"KIND", "KINDS", "SUBSTANCE", "PAIR", "FURNITURE", "FURNITURES", "CONTAINER", "CONTAINERS"}
    | {"DOOR", "ROOM"}
)
OWNERS = frozenset({"OWNER", "OWNING"})
BEINGS = frozenset({"NAME", "PERSON", "PEOPLE", "ANIMAL", "ANIMALS"})
SOMEBODY = BEINGS | OWNERS
NOUNS = THINGS | SOMEBODY
"""Word classes of what is known to the vocabulary, which something may be said of."""

TELLS_APART = frozenset({"COLOR", "SIZE", "MATERIAL", "ORDINAL", "LEFT_RIGHT", "NEAREST", "COMPARED"})

LIST_FILES = ("free_reasons", "remarks", "small_talk")
"""Files of lists; each list has a name of its own."""


@cache
def _lists() -> dict[str, frozenset[str]]:
    """All lists of the files below, read when a reason is first given."""
    folder = importlib.resources.files("executive.language.motives")
    texts = (folder.joinpath(f"{name}.toml").read_text("utf-8") for name in LIST_FILES)
    return {name: frozenset(words) for text in texts for name, words in tomllib.loads(text).items()}


def words_of(name: str) -> frozenset[str]:
    """One list of words that tell what a clause may do."""
    return _lists()[name]


@dataclass(frozen=True, slots=True)
class Reason:
    """A clause behind "because" or the like, within its sentence.

    Attributes:
        pieces: Of the sentence.
        start: Where the clause begins, behind the conjunction.
        end: Where it ends.
        begins: Word classes that begin at each place.
        vocabulary: What is known.
    """

    pieces: Sequence[Piece]
    start: int
    end: int
    begins: Sequence[AbstractSet[str]]
    vocabulary: Vocabulary

    @property
    def texts(self) -> list[str]:
        """The words of the clause."""
        return [piece.text for piece in self.pieces[self.start : self.end]]

    @property
    def said(self) -> str:
        """The clause, with spaces at both ends."""
        return f" {' '.join(self.texts)} "

    @property
    def places(self) -> range:
        """Where its words stand."""
        return range(self.start, self.end)

    @property
    def elsewhere(self) -> list[int]:
        """Where the other words of the sentence stand."""
        return [index for index in range(len(self.pieces)) if index not in self.places]

    def readings(self, index: int) -> list[tuple[int, Reading]]:
        """What begins at a place of the clause and ends within it."""
        texts = [piece.text for piece in self.pieces[: self.end]]
        return list(self.vocabulary.matches(texts, index))

    def has(self, name: str) -> bool:
        """Whether a word of the clause is in a list."""
        return not words_of(name).isdisjoint(self.texts)

    @property
    def names_somebody(self) -> bool:
        """Whether a person or an animal is named in the clause."""
        return any(self.is_about(index, SOMEBODY) for index in self.places)

    def is_about(self, index: int, classes: AbstractSet[str]) -> bool:
        """Whether a word of some classes begins at a place."""
        return not self.begins[index].isdisjoint(classes)
