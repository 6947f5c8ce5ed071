"""Which furniture is meant by what somebody calls it, and which of its parts."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping

from kinematics.scene.known_part import KnownPart
from robots.scenes.furniture_names import kind_called
from trees.beliefs.grounding.articles import with_article
from trees.beliefs.grounding.ranking import PLACES
from trees.beliefs.scene.believed_thing import BelievedThing, Surroundings
from trees.beliefs.scene.labels import plain
from trees.beliefs.scene.scene_update import kind_of
from trees.tasks import ObjectDescription

_EVERYDAY = frozenset({"kitchen table", "dining table", "dinner table", "living room table"})
"""What people call a table that nothing else is called by."""


def called_so(said: str, known: Mapping[str, Collection[str]]) -> frozenset[str]:
    """The words, of those that furniture is called by, that somebody means.

    The very words come first, and then what a piece is called besides. "The table" may be the side table; but
    the side table is none of those that are called nothing but table, for it may be one that nobody has seen
    yet, and nobody calls a desk a table.

    Args:
        said: "table", "side table", "desk"; without an article.
        known: What the pieces that were seen are called, without their numbers, and what besides.
    """
    wanted, words = said.lower(), frozenset(known)
    if same := {one for one in words if one.lower() == wanted}:
        return frozenset(same)
    if named := {one for one, besides in known.items() if plain(said) in besides}:
        return frozenset(named)
    if alike := {one for one in words if is_said_of(wanted, one)}:
        return frozenset(alike)
    return words & {kind_called(wanted)} if wanted in _EVERYDAY else frozenset()


def is_said_of(kind: str, words: str) -> bool:
    """Whether people may leave all but the kind out of what furniture is called: "table" of "side table"."""
    return kind in (words, words.rpartition(" ")[2])


def others_like(said: str, known: Iterable[str]) -> str:
    """What a failure adds about furniture of that kind that is called otherwise: "; a table is"."""
    alike = sorted({one for one in known if kind_called(one) == kind_called(said.lower())})
    return f"; {' and '.join(map(with_article, alike))} {'is' if len(alike) == 1 else 'are'}" if alike else ""


def may_be_called(said: str, words: str) -> bool:
    """Whether a piece of furniture that is called so may be what somebody says: "table" of a side table."""
    wanted = said.lower()
    everyday = wanted in _EVERYDAY and kind_called(wanted) == words.lower()
    return wanted in (words.lower(), kind_called(words)) or everyday


def is_called(furniture: str, said: str) -> bool:
    """Whether a piece of furniture, by its name in the scene, may be what somebody calls it."""
    return said.lower() == furniture.lower() or may_be_called(said, kind_of(furniture))


def pieces_called(name: str, around: Surroundings) -> list[BelievedThing]:
    """The piece of that name; without one the first solid of each that is called so: the one that carries."""
    wanted = name.lower()
    fixed = [thing for thing in around.things if not thing.movable]
    named = [thing for thing in fixed if thing.name.lower() == wanted]
    words = called_so(name, around.furniture_words) or {name}
    first = {thing.kind: thing for thing in reversed(fixed) if thing.kind in words}
    return named or [first[kind] for kind in sorted(first)]


def standing_on(said: str, around: Surroundings) -> Callable[[str], bool]:
    """Tells of what a thing stands on, by its name in the scene, whether that is where it is said to be."""
    meant = called_so(said, around.furniture_words)
    return lambda furniture: kind_of(furniture) in meant if meant else is_called(furniture, said)


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
    if whole is None or moves is None:
        return True
    return is_said_of(whole, moves.of) or plain(whole) in map(plain, moves.names)


def whole_in(described: ObjectDescription) -> str | None:
    """What a part is said to be in: "cabinet" of "the top drawer of the cabinet"."""
    relation = described.relation
    return None if relation is None or relation.kind != "in" else str(relation.to)
