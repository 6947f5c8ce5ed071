"""What an object is called besides its kind, by what a scene says of it."""

from __future__ import annotations

from collections.abc import Iterable

from robots.scenes.furniture_names import own_name
from robots.scenes.scene_description import SceneDescription
from robots.scenes.scene_words import ANY_LABEL, COLORS


def told_names(name: str, kind: str, names: Iterable[str]) -> tuple[str, ...]:
    """The names that a detector which knows the thing tells, the usual one first.

    A scene's own name for a thing counts, if it says more than colour, kind and a number: "tomato soup", and
    not "red can 2".

    Args:
        name: As the scene has it.
        kind: "can".
        names: What the scene says that it is called besides.
    """
    words = [word for word in name.casefold().rstrip("0123456789 ").split() if word not in COLORS]
    own = " ".join(words)
    given = tuple(" ".join(one.split()) for one in names)
    if not own or own == kind.casefold() or own in {one.casefold() for one in given}:
        return given
    return (*given, " ".join(name.rstrip("0123456789 ").split()))


def spoken_words(scene: SceneDescription) -> frozenset[str]:
    """What the things of a scene may be called: kinds, names and sorts, and what is declared besides."""
    words = {word for word in scene.perception.labels if word.casefold() != ANY_LABEL}
    for item in scene.objects:
        words |= {item.kind, *told_names(item.name, item.kind, item.names), *item.categories}
    own = (own_name(piece.name, piece.kind) for piece in scene.furniture)
    return frozenset({*words, *filter(None, own)})
