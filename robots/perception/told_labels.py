"""The words that the stub can tell: what the things of its world are called, and what is declared besides."""

from __future__ import annotations

from collections.abc import Iterable

from robots.scenes.articulated import PART_KINDS
from robots.scenes.furniture import FURNITURE_KINDS
from robots.scenes.furniture_names import FIXTURE, own_name
from robots.scenes.moving_parts import moving_parts
from robots.scenes.scene_description import SceneDescription, spoken_words
from robots.scenes.scene_words import ANY_LABEL, OBJECT_KINDS


def front_label(of: str, kind: str) -> str:
    """What the door or drawer of a piece is called that is recognised by its model: "microwave door"."""
    return f"{of} {kind}"


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
    parts += [
        front_label(own_name(piece.name, piece.kind) or piece.kind, opening.kind)
        for piece in scene.furniture
        for opening in piece.openings
    ]
    parts += [control.kind for piece in scene.furniture for control in piece.controls]
    called = [*spoken_words(scene), *people, *filter(None, parts)]
    return told_labels(called, scene.perception.labels)
