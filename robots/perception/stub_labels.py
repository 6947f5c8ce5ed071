"""What the perception stub can tell: the usual kinds, and what the things of its scene are called."""

from __future__ import annotations

from collections.abc import Iterable

from robots.scenes.articulated import PART_KINDS, moving_solids
from robots.scenes.furniture import FURNITURE_KINDS
from robots.scenes.object_names import spoken_words
from robots.scenes.scene_description import SceneDescription
from robots.scenes.scene_words import ANY_LABEL, OBJECT_KINDS


def told_labels(called: Iterable[str], declared: Iterable[str]) -> frozenset[str] | None:
    """The words that can be told, in lower case; None when any can.

    Args:
        called: What the things that could be seen are called: kinds, names and sorts.
        declared: What the scene declares besides.
    """
    extra = {word.casefold() for word in declared}
    if ANY_LABEL in extra:
        return None
    known = {*OBJECT_KINDS, *FURNITURE_KINDS, *PART_KINDS, *extra, *called}
    return frozenset(word.casefold() for word in known)


def labels_in(scene: SceneDescription) -> frozenset[str] | None:
    """The words that a robot's perception can tell in a scene, before there is a world; None when any.

    Args:
        scene: What is there, and what it declares.
    """
    people = ["person"] if scene.people else []
    parts = [solid.kind for piece in scene.furniture if piece.opens for solid in moving_solids(piece)]
    called = [*spoken_words(scene), *people, *filter(None, parts)]
    return told_labels(called, scene.perception.labels)
