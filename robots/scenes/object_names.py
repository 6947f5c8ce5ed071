"""What an object is called besides its kind, by what a scene says of it."""

from __future__ import annotations

from collections.abc import Iterable

from robots.scenes.scene_words import COLORS


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
