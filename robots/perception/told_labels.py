"""The words that the stub can tell: what the things of its world are called, and what is declared besides."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator

from robots.scenes.articulated import DOOR, DRAWER, PART_KINDS
from robots.scenes.furniture import FURNITURE_KINDS
from robots.scenes.furniture_names import FIXTURE, own_name
from robots.scenes.moving_parts import moving_parts
from robots.scenes.scene_description import Furniture, SceneDescription, spoken_words
from robots.scenes.scene_words import ANY_LABEL, OBJECT_KINDS


def fronts_of(called: Iterable[str], kinds: Collection[str]) -> Iterator[str]:
    """What the doors and drawers of a piece are called by the piece: "microwave door".

    Args:
        called: What the piece is called.
        kinds: Of its parts; what is neither a door nor a drawer has no such name.
    """
    return (f"{word} {kind}" for word in called for kind in kinds if kind in (DOOR, DRAWER))


def told_fronts(pieces: Iterable[Furniture]) -> frozenset[str]:
    """The doors and drawers of furniture that are told apart by the piece that they are of."""
    told: set[str] = set()
    for piece in pieces:
        called = (own_name(piece.name, piece.kind) or piece.kind, *piece.names)
        told.update(fronts_of(called, {solid.kind for part in moving_parts(piece) for solid in part.solids}))
    return frozenset(word.casefold() for word in told)


def told_labels(called: Iterable[str], declared: Iterable[str]) -> frozenset[str] | None:
    """The words that can be told, in lower case; None when any can.

    Args:
        called: What the things that could be seen are called: kinds, names and sorts.
        declared: What the scene declares besides.
    """
    extra = {word.casefold() for word in declared}
    if ANY_LABEL in extra:
        return None
    known = {*OBJECT_KINDS, *FURNITURE_KINDS, *PART_KINDS, *extra, *called} - {FIXTURE}
    return frozenset(word.casefold() for word in known)


def labels_in(scene: SceneDescription) -> frozenset[str] | None:
    """The words that a robot's perception can tell in a scene, before there is a world; None when any.

    Args:
        scene: What is there, and what it declares.
    """
    people = ["person"] if scene.people else []
    parts: list[str] = [
        solid.kind for piece in scene.furniture for part in moving_parts(piece) for solid in part.solids
    ]
    parts += [control.kind for piece in scene.furniture for control in piece.controls]
    called = [*spoken_words(scene), *people, *filter(None, parts)]
    return told_labels(called, scene.perception.labels)
