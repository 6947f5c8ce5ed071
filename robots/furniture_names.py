"""What furniture is called: a side table is a table, and so is a desk.

A piece that carries things may have a name of its own. Perception tells it, as it tells people's names, and
people use it; what can be done there follows from the kind.
"""

from __future__ import annotations

from types import MappingProxyType

_KINDS = MappingProxyType({"table": "table", "desk": "table", "counter": "counter", "shelf": "shelf"})
"""Kinds by the last word of a name, which says what the rest only tells apart."""


def kind_called(words: str) -> str:
    """The kind of what people call so: "side table" is a "table"; what is no such name stays as it is."""
    return _KINDS.get(words.rpartition(" ")[2].lower(), words)


def own_name(name: str, kind: str) -> str | None:
    """What a piece of furniture is called besides its kind; None when its name tells no more than that.

    Args:
        name: As a scene has it: "side table", "table 2".
        kind: "table".
    """
    words = " ".join(name.lower().rstrip("0123456789").split())
    return words if words != kind and kind_called(words) == kind else None
