"""Clauses that give a reason: "because I am freezing", "so that I can get through", "since it rains".

A reason never changes what is asked, so that it is passed over whatever its words are; that it is no more
than a reason is judged first (``reason_guard.py``).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from collections.abc import Set as AbstractSet

from executive.language.motives.reason import Reason, words_of
from executive.language.motives.reason_guard import does_something, holds_something, is_harmless
from executive.language.motives.set_remarks import plainer
from executive.language.words.piece import Piece
from executive.vocabulary import Vocabulary

FREE_REASON = "FREE_REASON"
"""Terminal of the grammar for a conjunction and its clause."""

_CONJUNCTION = "GIVES_REASON"
_SAME = frozenset({_CONJUNCTION, "BECAUSE", "CONDITION", "LINK", "OPENING", "DEGREE", "ONCE"})
"""Word classes of a conjunction that is no part of a longer phrase."""

_AS_IT_IS = "UNTOUCHED"
"""Word class of phrases that may go on: "as it is getting late"."""

_SUBJECTS = frozenset(
    {
        "DET",
        "NAME",
        "OWNER",
        "OWNING",
        "PERSON",
        "PEOPLE",
        "KIND",
        "KINDS",
        "SUBSTANCE",
        "PAIR",
        "ANIMAL",
        "ANIMALS",
    }
    | {"ROOM", "FURNITURE", "CONTAINER", "DOOR", "EVERYBODY"}
)
_NOT_POINTED_AT = frozenset({"DET", "NAME", "OWNER", "OWNING", "EVERYBODY"})
"""Word classes of a subject that "that" does not point at: "now that the rain is over"."""

_SOMEBODY = frozenset({"NAME", "PERSON", "PEOPLE", "ANIMAL", "ANIMALS", "EVERYBODY"})
_WAITS = frozenset({"WAIT"})
_TAKES_BACK = "CORRECTION"
_SENTENCE_ENDS = frozenset({".", "!", "?", ";"})


def free_reasons(
    pieces: Sequence[Piece],
    begins: Sequence[AbstractSet[str]],
    nothing_said: Sequence[bool],
    vocabulary: Vocabulary,
) -> Iterator[tuple[int, int]]:
    """Every reason that may be passed over: where its conjunction begins, and where its clause ends.

    Args:
        pieces: Of the sentence.
        begins: Word classes that begin at each place.
        nothing_said: For each place, whether only courtesies stand before it.
        vocabulary: What is known.
    """
    texts = [piece.text if not piece.quoted else "" for piece in pieces]
    for start in range(len(pieces)):
        if _CONJUNCTION not in begins[start]:
            continue
        found = [one for one in vocabulary.matches(texts, start) if one[1].word_class != _AS_IT_IS]
        length = max(one for one, _ in found)
        readings = [reading for one, reading in found if one == length]
        sorts = [reading.meaning for reading in readings if reading.word_class == _CONJUNCTION]
        if not sorts or any(reading.word_class not in _SAME for reading in readings):
            continue  # "as soon as", "so now"
        end = next(
            (index for index in range(start + length, len(pieces)) if _ends(pieces, index, begins)),
            len(pieces),
        )
        first = nothing_said[start] or pieces[start - 1].text in _SENTENCE_ENDS
        if first and (sorts[0] == "purpose" or end + 1 >= len(pieces) or pieces[end].text != ","):
            continue
        reason = plainer(Reason(pieces, start + length, end, begins, vocabulary))
        if _is_clause(reason, sorts[0]) and is_harmless(reason):
            yield start, end


def _ends(pieces: Sequence[Piece], index: int, begins: Sequence[AbstractSet[str]]) -> bool:
    """Whether a clause ends at a place; at a dash, if it is taken back: "because we are done - no, ..."."""
    return pieces[index].is_mark or (pieces[index].text == "-" and _TAKES_BACK in begins[index + 1])


def _is_clause(reason: Reason, sort: str) -> bool:
    """Whether it says something of somebody or something, in the way that its conjunction asks for."""
    texts = reason.texts
    known = texts[:1] and (
        texts[0] in words_of("subjects") or reason.is_about(reason.start, _SUBJECTS) or _is_doing(texts)
    )
    if len(texts) < 2 or not (known or texts[0] == "you"):
        return False
    if sort == "purpose":
        return _is_purpose(reason)
    if sort == "noun":
        return not reason.has("finite") and not reason.names_somebody
    if sort == "because":
        return True
    if sort == "now" and not (
        texts[0] in words_of("subjects") or reason.is_about(reason.start, _NOT_POINTED_AT)
    ):
        return False  # "now that box has to be opened"
    if sort in ("since", "now"):
        waits = any(reason.is_about(index, _WAITS) for index in reason.elsewhere)
        return reason.has("finite") and not waits
    return _lasts(texts)


def _is_doing(texts: Sequence[str]) -> bool:
    """Whether it is about doing something: "bending is hard for me"."""
    said = words_of("finite") | words_of("verbs")
    return texts[0].endswith("ing") and not said.isdisjoint(texts[1:4])


def _is_purpose(reason: Reason) -> bool:
    """Whether "so that" says what it is good for, and not how a thing is to stand there."""
    texts = reason.texts
    if reason.has("arranged") or (holds_something(reason) and reason.has("watched")):
        return False
    if texts[0] == "you":
        return texts[1] in words_of("you_may_not")
    if texts[0].startswith("we") and does_something(reason):
        return False  # "so we can take the milk out"
    if texts[0] in words_of("people") or _about_somebody(reason):
        return True
    return not words_of("spared").isdisjoint(texts[1:5])


def _about_somebody(reason: Reason) -> bool:
    """Whether its subject is a person or an animal, perhaps with an article."""
    first = reason.start
    if reason.is_about(first, _SOMEBODY):
        return True
    return reason.is_about(first, frozenset({"DET", "OWNER", "OWNING"})) and reason.is_about(
        first + 1, _SOMEBODY
    )


def _lasts(texts: Sequence[str]) -> bool:
    """Whether "as" gives a reason: of what lasts, not of what goes on meanwhile, nor how it is."""
    if texts[0] == "you":
        return False
    said = words_of("lasting") | words_of("happened")
    at = next((index for index, word in enumerate(texts[:4]) if word in said), None)
    if at is None or at + 1 >= len(texts):
        return False
    following = texts[at + 1]
    wishes = texts[at] in ("need", "needs", "want", "wants")
    if wishes and following in ("it", "them", "him", "her"):
        return False  # "as I need it"
    return not following.endswith("ing") or following in words_of("weather")
