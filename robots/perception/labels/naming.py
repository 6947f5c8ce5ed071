"""From scores of labellers to what things are called, and to what they may be called."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from kinematics.arrays import Array
from robots.perception.labels.labeller import Boxes, Image, Labeller

TOLD = 0.75
"""A word that fits at least so surely is told."""
ASKED = 0.2
"""One that fits less surely than the above, and at least so, is what a thing may be: a person is asked."""
_MARGIN = 0.2
"""Two words nearer to each other than this both may be right, unless they say the same."""


@dataclass(frozen=True, slots=True)
class Naming:
    """What one thing is called.

    Attributes:
        names: Words that surely fit, the surest first.
        maybe: Words that may fit.
        score: Of the first of both.
    """

    names: tuple[str, ...] = ()
    maybe: tuple[str, ...] = ()
    score: float = 0.0


class Labellers:
    """Several labellers as one: each is asked for the words that it can tell.

    Args:
        members: Who is asked, the first one first.
    """

    def __init__(self, members: Sequence[Labeller]) -> None:
        self._members = tuple(members)

    @property
    def known(self) -> frozenset[str]:
        """What those can tell that know their words."""
        return frozenset(word for member in self._members for word in member.words or ())

    @property
    def words(self) -> frozenset[str] | None:
        """What one of them can tell; None: any word."""
        every = [member.words for member in self._members]
        if any(words is None for words in every):
            return None
        return frozenset(word for words in every if words is not None for word in words)

    @property
    def trouble(self) -> str:
        """What those told who could tell nothing when they were asked last."""
        return "; ".join(filter(None, (member.trouble for member in self._members)))

    def scores(self, image: Image, boxes: Boxes, words: Sequence[str]) -> Array:
        """Of each word the score of the first labeller that knows it; see ``Labeller``."""
        found = np.zeros((len(boxes), len(words)))
        left = list(range(len(words)))
        for member in self._members:
            own = [i for i in left if member.words is None or words[i] in member.words]
            if own and len(boxes):
                found[:, own] = member.scores(image, boxes, [words[i] for i in own])
            left = [i for i in left if i not in own]
        return found


def namings(labeller: Labeller, image: Image, boxes: Boxes, words: Sequence[str]) -> list[Naming]:
    """What each thing is called.

    Args:
        labeller: Who tells.
        image: In the colours of daylight.
        boxes: Where the things are.
        words: What they may be called.
    """
    if not words or not len(boxes):
        return [Naming()] * len(boxes)
    return [_naming(row, words) for row in labeller.scores(image, boxes, words)]


def _naming(scores: Array, words: Sequence[str]) -> Naming:
    order = np.argsort(-scores, kind="stable")
    best = float(scores[order[0]])
    near = [words[i] for i in order if scores[i] >= ASKED and scores[i] > best - _MARGIN]
    if not near:
        return Naming()
    if best >= TOLD and len(near) == 1:
        return Naming(names=(near[0],), score=best)
    return Naming(maybe=tuple(near), score=best)
