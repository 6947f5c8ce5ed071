"""How else people call what a label names: its colours in any order, its packaging, its last word.

A label is written by whoever made the scene: "white yellow mug", "cookies", "desk caddy". People say "the
yellow and white mug", "the cookie box", "the caddy".
"""

from __future__ import annotations

import itertools
from collections.abc import Collection, Iterator, Sequence

from executive.vocabulary.inflection import plural

PACKAGES = ("box", "carton", "packet", "package", "bottle", "can", "tin", "jar", "tub", "bag")
"""What things to eat and drink come in: the box of a thing is that thing, where nothing else is called so."""
_MOST_COLORS = 3


def label_phrases(label: str, colors: Collection[str]) -> Iterator[str]:
    """Phrases that mean a label, besides its own words; each once.

    Args:
        label: In lower case, a space between words.
        colors: The words for colours.
    """
    words = label.split()
    told = list(_told_by_colors(words, colors))
    if words[-1] not in PACKAGES and not any(word in colors for word in words):
        names = [label, *_singular(label)]
        told += [f"{name} {package}" for name in names for package in PACKAGES]
    yield from (phrase for phrase in dict.fromkeys(told) if phrase != label)


def head_of(label: str) -> str | None:
    """The last word of a label of several, which says what the thing is: "caddy" of a desk caddy."""
    *before, last = label.split()
    return last if before else None


def _told_by_colors(words: Sequence[str], colors: Collection[str]) -> Iterator[str]:
    said = [word for word in words if word in colors]
    rest = " ".join(word for word in words if word not in colors and word != "and")
    if not rest or not 2 <= len(said) <= _MOST_COLORS:
        return
    for order in itertools.permutations(said):
        yield f"{' '.join(order)} {rest}"
        yield f"{' and '.join(order)} {rest}"


def _singular(label: str) -> list[str]:
    """What a label that is a plural is one of: "cookie" of "cookies"."""
    single = label[:-1]
    return [single] if label.endswith("s") and plural(single) == label else []
