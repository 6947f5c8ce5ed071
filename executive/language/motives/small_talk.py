"""Fragments without a verb before a command, as people talk: "Quiet night." before "Walk to the door.".

Of a fragment that is passed over every word is known to tell nothing of a task; any other word is allowed
only behind "what a" and before a mere "again", where no order can stand. "Left hand.", "The red one." and
"Danger!" say something of what follows, and are refused as before.
"""

from __future__ import annotations

from executive.language.motives.reason import SOMEBODY, THINGS, Reason, words_of

_BARRED = (
    "manners",
    "forbidding",
    "claims",
    "revoking",
    "conditions",
    "denying",
    "one",
    "parts",
    "elsewhere",
)
"""Lists of words that say how, where or which, that warn, or that take something back."""

_TELLS = (THINGS | SOMEBODY | {"AMOUNT", "NEGATION", "CONDITION", "COLOR"}) - {"PEOPLE"}
"""Word classes of what may tell something of a task; "friends" and "listeners" are greeted."""

_LONGEST_END = 4
"""Words of the longest phrase that may stand behind."""


def is_small_talk(fragment: Reason) -> bool:
    """Whether a sentence without a verb says nothing of what is to be done."""
    texts = fragment.texts
    if any(fragment.pieces[index].quoted or _is_a_noun(fragment, index) for index in fragment.places):
        return False
    if " ".join(texts) in words_of("exclaimed"):
        return True
    said = _without_ends(texts)
    if len(said) == 1 == len(texts) - 1 and texts[-1] in words_of("talk_again"):
        return _is_open(fragment, 0) and _is_plural(said[0])
    length = _begins_with(said, "exclaiming")
    if length:
        return len(said) > length and all(
            _is_talk(one) or _is_open(fragment, index)
            for index, one in enumerate(said[length:], start=length)
        )
    said = said[_begins_with(said, "exclaiming_plain") :]
    told = said[_begins_with(said, "talk_articles") :]
    return _tells_of(told) or (0 < len(said) < len(texts) and _is_just_so(said))


def _without_ends(texts: list[str]) -> list[str]:
    """What stands before "today", "again" or the like."""
    for length in range(min(_LONGEST_END, len(texts)), 0, -1):
        if " ".join(texts[-length:]) in words_of("talk_ends"):
            return _without_ends(texts[:-length])
    return texts


def _begins_with(texts: list[str], name: str) -> int:
    """How many words of a list stand in front."""
    lengths = (length for length in (3, 2, 1) if " ".join(texts[:length]) in words_of(name))
    return next((length for length in lengths if length <= len(texts)), 0)


def _tells_of(told: list[str]) -> bool:
    """Whether it is what may be talked about, and how that is: "very quiet night"."""
    *before, last = told or [""]
    described = [one for one in before if one not in words_of("talk_degrees")]
    if not described:
        return False
    if last in words_of("talked_well_of"):
        return _praising().issuperset(described)
    return last in words_of("talked_of") and (words_of("talked_as") | _praising()).issuperset(described)


def _praising() -> frozenset[str]:
    return words_of("talked_alone") | words_of("talked_well_as")


def _is_just_so(said: list[str]) -> bool:
    """Whether it says how it is, of nothing that could be named: "very busy" of "very busy today"."""
    return said[-1] in words_of("talked_alone") and words_of("talk_degrees").issuperset(said[:-1])


def _is_talk(word: str) -> bool:
    names = ("talked_of", "talked_well_of", "talked_as", "talked_alone", "talked_well_as", "talk_degrees")
    return any(word in words_of(name) for name in names)


def _is_a_noun(fragment: Reason, index: int) -> bool:
    """Whether a thing, place or person is named there, whatever else the word may mean."""
    return fragment.is_about(index, _TELLS)


def _is_open(fragment: Reason, index: int) -> bool:
    """Whether a word is none that is known, so that it can tell nothing of the task."""
    word = fragment.texts[index]
    if not word.isalpha() or any(word in words_of(name) for name in _BARRED):
        return False
    return not fragment.readings(fragment.start + index)


def _is_plural(word: str) -> bool:
    return word.endswith("s") and not word.endswith(tuple(words_of("not_plural")))
