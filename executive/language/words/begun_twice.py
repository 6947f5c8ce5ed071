"""A command that is begun twice: "go to go to the kitchen", "take take the cup", "wave, wave to Ana"."""

from __future__ import annotations

from collections.abc import Sequence

from executive.language.words.piece import Piece
from executive.vocabulary import Vocabulary

_LONGEST = 3
"""Words that are begun with at most."""

_STOPS = frozenset({"STOP", "REVOKE"})
_GOES_ON = frozenset(
    {"the", "a", "an", "my", "your", "to", "into", "from", "on", "in", "at", "of", "with", "up", "me"}
)
"""Words behind which more has to follow."""

_BEFORE_A_COMMAND = frozenset(
    {",", ".", ";", "!", "and", "then", "please", "robot", "now", "so", "ok", "okay", "um", "uh", "you"}
)

_VERBS = frozenset(
    {"PICK_UP", "PICK", "FETCH", "BRING", "CARRY", "GIVE", "PUT", "MOVE_THING", "OPEN", "CLOSE", "WALK"}
    | {"GREETS", "POINT_AT", "LOOK_AT", "FIND", "COUNT", "DESCRIBE", "APPROACH"}
)
"""Word classes of verbs that command nothing alone."""

_GESTURES = frozenset({"WAVE"})
"""Word classes of verbs that are said again and again where they are meant once, with commas between."""

_OF_A_GESTURE = frozenset({"WAVE_TO", "WITH"})
"""Word classes of what is said of a gesture: for whom it is, and with which hand."""


def without_beginnings(pieces: Sequence[Piece], vocabulary: Vocabulary) -> list[Piece]:
    """The pieces without the first of two equal beginnings of a command."""
    kept = list(pieces)
    start = 0
    while start < len(kept):
        lengths = range(_LONGEST, 0, -1)
        length = next((one for one in lengths if _is_begun_twice(kept, start, one, vocabulary)), 0)
        length = length or _eager(kept, start, vocabulary)
        del kept[start : start + length]
        start += 0 if length else 1
    return kept


def _is_begun_twice(pieces: Sequence[Piece], start: int, length: int, vocabulary: Vocabulary) -> bool:
    """Whether some words are said again at once, begin with a verb, and command nothing alone."""
    end = start + 2 * length
    first, again = pieces[start : start + length], pieces[start + length : end]
    if end >= len(pieces) or pieces[end].is_mark or any(one.quoted or one.is_mark for one in first):
        return False
    if pieces[end].text == first[0].text or [one.text for one in first] != [one.text for one in again]:
        return False
    if start and pieces[start - 1].text not in _BEFORE_A_COMMAND:
        return False  # "say go go go"
    read = list(vocabulary.matches([one.text for one in pieces[start:end]], 0))
    if any(reading.word_class in _STOPS or size > length for size, reading in read):
        return False
    verb = any(size == 1 and reading.word_class in _VERBS for size, reading in read)
    return verb and (length == 1 or first[-1].text in _GOES_ON)


def _eager(pieces: Sequence[Piece], start: int, vocabulary: Vocabulary) -> int:
    """How many pieces stand before a gesture that is said again with whom it is for: "wave, wave to Ana".

    None where it is said again alone: "wave, wave" are two.
    """
    texts = [one.text if not one.quoted else "" for one in pieces]
    if not _reads(texts, start, _GESTURES, vocabulary):
        return 0
    if start and texts[start - 1] not in _BEFORE_A_COMMAND:
        return 0  # "say wave wave"
    again = start + 1
    while texts[again : again + 1] == [texts[start]] or texts[again : again + 2] == [",", texts[start]]:
        again += 1 if texts[again] == texts[start] else 2
    last = again - 1
    return last - start if last > start and _reads(texts, again, _OF_A_GESTURE, vocabulary) else 0


def _reads(texts: Sequence[str], start: int, classes: frozenset[str], vocabulary: Vocabulary) -> bool:
    """Whether a word of some classes begins at a place."""
    return start < len(texts) and any(
        reading.word_class in classes for _, reading in vocabulary.matches(texts, start)
    )
