"""What is said twice at once, with or without a hesitation between: "the the cup", "the, uh, the cup"."""

from __future__ import annotations

import re
from collections.abc import Sequence

from executive.language.words.piece import Piece

_SMALL = frozenset(
    {"the", "a", "an", "my", "your", "to", "into", "from", "and", "on", "in", "at", "of", "with"}
)
"""Words that mean the same when they are said twice."""

_BEGINS = frozenset({"the", "that", "my", "your"})
"""Words that "one" has before it where it names a thing."""

_SOUND = re.compile(
    r"\b(?:u+h+|u+m+|uhm|er+|erm|ehm?|h+m+|let's see|let me see|let me think|you know)\b|\.\.\."
)
_PAUSE = re.compile(rf"(?:(?:{_SOUND.pattern}|[,.]) )+")
_LONGEST_PAUSE = 5
"""Pieces between two wordings of the same."""

_LONGEST = 4
"""Words that are said again as they were."""


def without_stutter(pieces: list[Piece]) -> list[Piece]:
    """The pieces without what is said again in the same words.

    Small words are said again right away, others after a hesitation; "the blue one" may be said again
    with its noun: "the blue one the blue cup".
    """
    texts = [piece.text for piece in pieces]
    hesitates = _SOUND.search(" ".join(texts).replace(". . .", "...")) is not None
    kept: list[Piece] = []
    for piece in pieces:
        kept.append(piece)
        while (said := _said_before(kept, _LONGEST_PAUSE if hesitates else 0)) is not None:
            del kept[said[0] : said[1]]
    return _with_noun(kept) if "one" in texts else kept


def _said_before(kept: Sequence[Piece], longest_pause: int) -> tuple[int, int] | None:
    """Where the last words were said right before, up to where they are said again."""
    for length in range(min(_LONGEST, len(kept) // 2), 0, -1):
        second = len(kept) - length
        for gap in range(min(longest_pause, second - length) + 1):
            first = second - gap - length
            if kept[first].text != kept[second].text or not _same(kept, first, second, length):
                continue
            small = all(one.text in _SMALL for one in kept[second:])
            if gap == 0 and not (small and length < _LONGEST):
                continue
            if gap and not (_is_pause(kept[second - gap : second]) and not kept[second].is_mark):
                continue
            return first, second
    return None


def _same(pieces: Sequence[Piece], first: int, second: int, length: int) -> bool:
    return not any(
        pieces[first + index].text != pieces[second + index].text
        or pieces[first + index].quoted
        or pieces[second + index].quoted
        for index in range(length)
    )


def _is_pause(pieces: Sequence[Piece]) -> bool:
    """Whether some pieces are hesitation and marks; a mere comma is none."""
    text = " ".join(one.text for one in pieces).replace(". . .", "...") + " "
    hesitates = _SOUND.search(text) is not None and not any(one.quoted for one in pieces)
    return hesitates and _PAUSE.fullmatch(text) is not None


def _with_noun(pieces: list[Piece]) -> list[Piece]:
    """The pieces without "the blue one" right before "the blue cup"."""
    for index, piece in enumerate(pieces):
        for length in (4, 3, 2):
            first = index - length
            if piece.text != "one" or first < 0 or pieces[first].text not in _BEGINS:
                continue
            for second in range(index + 1, min(index + 1 + _LONGEST_PAUSE, len(pieces) - length)):
                pause = pieces[index + 1 : second]
                if (not pause or _is_pause(pause)) and _same(pieces, first, second, length):
                    return [*pieces[:first], *pieces[second:]]
    return pieces
