"""What furniture is called: a side table is a table, and so is a desk.

A piece that carries things may have a name of its own. Perception tells it, as it tells people's names, and
people use it; what can be done there follows from the kind.
"""

from __future__ import annotations

from types import MappingProxyType
from typing import Final

FIXTURE: Final = "fixture"
"""The kind of what is fixed where it stands and is no furniture of a usual kind; it has a name of its own."""
KNOB: Final = "knob"
BUTTON: Final = "button"
"""Kinds of what fingers turn and press on it."""

_KINDS = MappingProxyType({"table": "table", "desk": "table", "counter": "counter", "shelf": "shelf"})
"""Kinds by the last word of a name, which says what the rest only tells apart."""

_OTHER_KINDS = MappingProxyType(
    {
        "wall": "wall",
        "fridge": "fridge",
        "refrigerator": "fridge",
        **dict.fromkeys(("drawers", "chest"), "drawers"),
    }
)
"""Kinds, by the same word, of what has no name of its own."""


def kind_called(words: str) -> str:
    """The kind of what people call so: "side table" is a "table"; what is no such name stays as it is."""
    return _KINDS.get(words.rpartition(" ")[2].lower(), words)


def is_called_a(kind: str, words: str) -> bool:
    """Whether a name says that a piece is a fridge, or a chest of drawers: "white refrigerator"."""
    return _OTHER_KINDS.get(words.rpartition(" ")[2].lower()) == kind


def own_name(name: str, kind: str) -> str | None:
    """What a piece of furniture is called besides its kind; None when its name tells no more than that.

    Args:
        name: As a scene has it: "side table", "table 2".
        kind: "table".
    """
    words = " ".join(name.lower().rstrip("0123456789").split())
    if kind == FIXTURE:
        return words if words != kind else None
    return words if words != kind and kind_called(words) == kind else None


def kind_that_name_contradicts(name: str, kind: str) -> str | None:
    """The kind that a name tells, where the piece is of another one: "fridge" of a table named so; else None.

    Args:
        name: As a scene has it; a name that tells its own kind anywhere contradicts nothing ("wall beside the
            table").
        kind: "table".
    """
    words = name.lower().rstrip("0123456789").split()
    if kind == FIXTURE:
        return None  # it may look like anything
    kinds = {**_KINDS, **_OTHER_KINDS}
    told = kinds.get(words[-1]) if words else None
    return told if told != kind and kind not in (kinds.get(word) for word in words) else None
