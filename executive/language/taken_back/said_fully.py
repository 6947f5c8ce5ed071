"""A correction that only says the noun of "one": "the other one, I mean the other shoe"."""

from __future__ import annotations

from executive.language.taken_back.beginnings import ONE, SORTS
from executive.language.taken_back.taking_back import REPLACES, Marker
from executive.language.words.lattice import Lattice


def said_fully(lattice: Lattice, marker: Marker) -> str | None:
    """The sentence with the noun in place of "one"; None where more than that is said anew.

    Args:
        lattice: The sentence.
        marker: Its correction; behind it nothing but the same words with a noun may follow.
    """
    texts = [piece.text for piece in lattice.pieces]
    one, first = marker.span.start - 1, marker.span.end
    end = len(texts)
    while end > first and lattice.pieces[end - 1].is_mark:
        end -= 1
    if marker.meaning != REPLACES or not any(word.word_class in ONE for word in lattice.phrase(one)):
        return None
    nouns = [
        start
        for start in range(first, end)
        if any(word.word_class in SORTS and word.end == end for word in lattice.phrase(start))
    ]
    if not nouns:
        return None
    shared = nouns[0] - first
    if not 0 < shared <= one or texts[one - shared : one] != texts[first : nouns[0]]:
        return None
    begins, noun = lattice.pieces[one].start, lattice.pieces[nouns[0]].start
    return lattice.plain[:begins] + lattice.plain[noun:]
