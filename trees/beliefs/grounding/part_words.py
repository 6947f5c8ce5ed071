"""Words for the parts of a piece that open: "top", "left", "of the cabinet"."""

from __future__ import annotations

from kinematics.scene.known_part import KnownPart
from trees.beliefs.grounding.furniture_called import is_said_of
from trees.beliefs.grounding.ranking import PLACES
from trees.tasks import ObjectDescription


def places_told(moves: KnownPart | None) -> set[str]:
    """The places that are in a part's name: "top" of "top drawer"."""
    words = () if moves is None else moves.part.split()
    return {PLACES[word] for word in words if word in PLACES}


def is_at(place: str | None, moves: KnownPart | None) -> bool:
    """Whether a part is where it is said to be among those of its piece, as far as a model tells that.

    The top one of three is not the only one that is seen. What the model calls by no place may be any.
    """
    told = places_told(moves)
    return not told or place not in PLACES or PLACES[place or ""] in told


def is_of(whole: str | None, moves: KnownPart | None) -> bool:
    """Whether a part is one of the piece that is named, "cabinet" of a wooden one; without a model any is."""
    return whole is None or moves is None or is_said_of(whole, moves.of)


def whole_in(described: ObjectDescription) -> str | None:
    """What a part is said to be in: "cabinet" of "the top drawer of the cabinet"."""
    relation = described.relation
    return None if relation is None or relation.kind != "in" else str(relation.to)
