"""What a sentence is about where it breaks off at words that are known: a time, a choice, a question."""

from __future__ import annotations

from executive.language.words.lattice import Lattice

_UNITS = frozenset({"TIME", "LENGTH", "ANGLE"})
_NUMBERS = frozenset({"NUM", "AMOUNT", "TENS", "COUPLE", "HALF", "QUARTER", "ARTICLE"})
_SPEAKS = frozenset({"TELL", "SAY"})
_QUESTION = "QUESTION"

Reason = tuple[str, str]
"""The words that caused it, and a sentence that says why."""


def reason_at(lattice: Lattice, position: int) -> Reason | None:
    """Why a sentence breaks off at a place, or at its end; None where no more is known than that it does.

    Args:
        lattice: The sentence.
        position: The first piece that fits no more.
    """
    size = len(lattice.pieces)
    while (
        position > 0 and (position >= size or lattice.ends[position]) and lattice.pieces[position - 1].is_mark
    ):
        position -= 1
    found = _question(lattice) or _choice(lattice, position)
    return found or _measure(lattice, position) or _told(lattice, position)


def _classes(lattice: Lattice, position: int) -> set[str]:
    return (
        {word.word_class for word in lattice.phrase(position)}
        if 0 <= position < len(lattice.pieces)
        else set()
    )


def _question(lattice: Lattice) -> Reason | None:
    """What is asked of this robot that it does not answer: "what can you do?"."""
    asked = [word for word in lattice.phrase(0) if word.word_class == _QUESTION]
    if not asked:
        return None
    said = max(asked, key=lambda one: one.end).said
    answers = "what is there, where something is and how many there are"
    return said, f"{said!r}: this robot answers only {answers}"


def _measure(lattice: Lattice, position: int) -> Reason | None:
    """How far, how long or when: "pick it up in 5 seconds"."""
    for start in (position - 1, position, position + 1):
        units = (
            [word for word in lattice.phrase(start) if word.word_class in _UNITS]
            if _in(lattice, start)
            else []
        )
        if units and start > 0 and not _NUMBERS.isdisjoint(_classes(lattice, start - 1)):
            unit = max(units, key=lambda one: one.end)
            said = f"{lattice.pieces[start - 1].text} {unit.said}"
            return said, f"how far, how long or when ({said!r}) cannot be chosen here"
    return None


def _choice(lattice: Lattice, position: int) -> Reason | None:
    if "OR" not in _classes(lattice, position):
        return None
    said = lattice.pieces[position].text
    return said, f"{said!r} leaves open what is meant; say one of them"


def _told(lattice: Lattice, position: int) -> Reason | None:
    """Telling somebody to do something: "tell the students to be quiet"."""
    tells = [word.said for start in range(min(2, len(lattice.pieces))) for word in lattice.phrase(start)]
    speaks = any(_SPEAKS & _classes(lattice, start) for start in range(min(2, len(lattice.pieces))))
    if (
        not speaks
        or not tells
        or not _in(lattice, position)
        or lattice.pieces[position].text not in ("to", "not")
    ):
        return None
    verb = tells[0]
    return (
        verb,
        f"{verb!r}: telling somebody to do something is no skill; put words to say in quotation marks",
    )


def _in(lattice: Lattice, position: int) -> bool:
    return 0 <= position < len(lattice.pieces)
