"""The words that a scene file may use for objects."""

from __future__ import annotations

import difflib
from collections.abc import Iterable

CYLINDER_KINDS = ("cup", "bottle", "bowl", "can")
HOLLOW_KINDS = ("box", "bowl")
"""Kinds that may be hollow and open at the top."""
OBJECT_KINDS = (*CYLINDER_KINDS, "box", "ball")

ANY_LABEL = "any"
"""The label by which a scene declares that its perception is open: it can be asked for anything."""

LONGEST_LABEL = 60
"""Letters of a kind, a name or a category."""

COLORS: dict[str, tuple[float, float, float]] = {
    "red": (0.85, 0.10, 0.08),
    "green": (0.15, 0.60, 0.20),
    "blue": (0.12, 0.30, 0.80),
    "yellow": (0.95, 0.80, 0.10),
    "orange": (0.95, 0.50, 0.08),
    "purple": (0.50, 0.20, 0.60),
    "pink": (0.95, 0.55, 0.70),
    "brown": (0.45, 0.28, 0.15),
    "black": (0.08, 0.08, 0.08),
    "white": (0.95, 0.95, 0.95),
    "grey": (0.50, 0.50, 0.50),
}
"""Canonical colour words, and how they are drawn (red, green, blue in [0, 1])."""


def nearest_word(word: str, known: Iterable[str]) -> str:
    """The known word that is spelled most alike."""
    words = sorted(known)
    return (difflib.get_close_matches(word, words, n=1, cutoff=0.0) or words)[0]
