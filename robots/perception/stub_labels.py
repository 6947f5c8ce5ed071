"""What the perception stub can tell: the usual kinds, and what the things of its scene are called."""

from __future__ import annotations

from collections.abc import Iterable

from robots.perception.truth_view import TrueObject
from robots.scenes.articulated import PART_KINDS
from robots.scenes.furniture import FURNITURE_KINDS
from robots.scenes.scene_words import ANY_LABEL, OBJECT_KINDS


def told_labels(solids: Iterable[TrueObject], declared: Iterable[str]) -> frozenset[str] | None:
    """The words that can be told, in lower case; None when any can.

    Args:
        solids: Everything that could be seen.
        declared: What the scene declares besides.
    """
    extra = {word.casefold() for word in declared}
    if ANY_LABEL in extra:
        return None
    known = {*OBJECT_KINDS, *FURNITURE_KINDS, *PART_KINDS, *extra}
    for solid in solids:
        known |= {solid.kind, *solid.names, *solid.categories}
        if solid.category == "furniture" and solid.told_name is not None:
            known.add(solid.told_name)
    return frozenset(word.casefold() for word in known)
