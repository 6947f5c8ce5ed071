"""What is wished for in the past tense: "I'd be grateful if you opened the fridge" orders to open it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from collections.abc import Set as AbstractSet
from dataclasses import replace

from executive.language.words.piece import Piece
from executive.vocabulary import Vocabulary
from executive.vocabulary.inflection import plain_forms

WISH = "WISH"
"""Word class of the courtesies behind which a verb may be past and mean what is to be done."""

_PAST_TENSE = "PAST_TENSE"
_GOES_ON = frozenset({"SEP", "AND"})
_SPEAKS = frozenset({"SAY", "TELL"})
_PASSED = frozenset({"FILLER", "AT_FIRST"})
_REFUSED = frozenset({"NO_SKILL", "HARM", "THROW", "ASK"})
"""Word classes of verbs that are refused, which elsewhere may tell how a thing is: "baked beans"."""

_DONE = ":ed"
"""How the meanings of past participles end, which of most verbs are the past tense too."""

Classes = Sequence[AbstractSet[str]]


def in_base_form(
    pieces: Sequence[Piece], begins: Classes, ends: Classes, vocabulary: Vocabulary
) -> tuple[list[Piece], bool]:
    """The pieces with "hand" for "handed" behind a wish, and behind what joins more to it.

    What follows words to say stays as it is, for it may be one of them: "if you told Ben that Ana has come
    and opened the door". Whether there is such a verb is told too.

    Args:
        pieces: Of the sentence.
        begins: Word classes that begin at each place.
        ends: Word classes that end at each place.
        vocabulary: What is known.
    """
    changed = list(pieces)
    speaks = open_words = False
    for start in _verbs(pieces, begins, ends):
        others = _REFUSED if WISH in ends[start] else frozenset[str]()
        plain = _base_of(pieces[start].text, vocabulary, others)
        if plain is None:
            continue
        if speaks:
            open_words = True
        else:
            changed[start] = replace(pieces[start], text=plain)
            speaks = _says_words(start, pieces, begins)
    return changed, open_words


def _verbs(pieces: Sequence[Piece], begins: Classes, ends: Classes) -> Iterator[int]:
    """Where a verb may stand that a wish goes on to: behind it, behind commas and "and", in one sentence."""
    wished = awaits = False
    for start, piece in enumerate(pieces):
        if WISH in ends[start]:
            wished = awaits = True
        if piece.is_mark:
            wished = wished and piece.text == ","
            awaits = wished
            continue
        if not _GOES_ON.isdisjoint(begins[start]):
            awaits = wished
            continue
        if wished and awaits and not piece.quoted:
            yield start
            awaits = not _PASSED.isdisjoint(begins[start])


def _says_words(start: int, pieces: Sequence[Piece], begins: Classes) -> bool:
    """Whether a verb asks to say something that no quotation marks enclose."""
    speaks = not _SPEAKS.isdisjoint(begins[start]) and "ME" not in begins[start + 1]
    return speaks and not any(piece.quoted for piece in pieces[start:])


def _base_of(word: str, vocabulary: Vocabulary, others: AbstractSet[str]) -> str | None:
    """The plain form of a verb in the past tense; None where the word is none that commands anything.

    Args:
        word: The verb.
        vocabulary: What is known.
        others: Word classes of which it may be besides those that command something.
    """
    read = [reading for length, reading in vocabulary.matches([word], 0) if length == 1]
    listed = next((one.meaning for one in read if one.word_class == _PAST_TENSE), None)
    if listed is not None:
        return listed
    done = others | {one.word_class for one in read if one.meaning.endswith(_DONE)}
    for plain in plain_forms(word):
        if any(one.word_class in done for _, one in vocabulary.matches([plain], 0)):
            return plain
    return None
