"""What "is" stands for behind a noun: "the cup's on the table"."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from executive.language.text.piece import Piece
from executive.vocabulary import Vocabulary

_NOUNS = frozenset({"KIND", "KINDS", "SUBSTANCE", "PAIR", "FURNITURE", "CONTAINER", "ROOM"})
_PLACES = frozenset({"ON", "IN", "AT", "RELATION", "NEXT_TO"})
_SUBJECTS = frozenset({*_NOUNS, "PERSON", "NAME"})
_PREDICATES = frozenset({*_PLACES, "STATE", "DEGREE"})


def uncontracted(pieces: Sequence[Piece], vocabulary: Vocabulary) -> Iterator[Piece]:
    """The pieces, with "the cup's on the table" as "the cup is on the table"."""
    texts = [piece.text for piece in pieces]
    for index, piece in enumerate(pieces):
        stem = piece.text.removesuffix("'s")
        if stem == piece.text or piece.quoted or index + 1 == len(pieces):
            yield piece
            continue
        begins = {reading.word_class for _, reading in vocabulary.matches(texts, index + 1)}
        nouns = {reading.word_class for _, reading in vocabulary.matches([stem], 0)}
        if begins.isdisjoint(_PREDICATES) or nouns.isdisjoint(_SUBJECTS):
            yield piece
            continue
        middle = piece.end - len("'s")
        yield Piece(stem, piece.start, middle)
        yield Piece("is", middle, piece.end)
