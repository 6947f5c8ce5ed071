"""Labellers of other installed packages: detectors that find things by any word in a colour picture.

A package declares what makes one::

    [project.entry-points."humanoid_executive.labellers"]
    owl = "my_package.detector:make"

``make()`` gives an object with a method ``detect(rgb, words)``.
"""

from __future__ import annotations

import importlib.metadata
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array, InFloat64
from robots.perception.labels.labeller import Boxes, Image, Labeller

GROUP = "humanoid_executive.labellers"
_LEAST_COMMON = 0.3
"""Of what a detector found and what stands out in depth, over both together; less is another thing."""


@dataclass(frozen=True, slots=True)
class Found(InFloat64):
    """One thing that a detector found.

    Attributes:
        label: One of the words that it was asked for.
        score: In [0, 1].
        box: First column and row, and those after the last.
        mask: Where it is in the picture, shape (height, width); None where the detector tells boxes alone.
    """

    label: str
    score: float
    box: tuple[float, float, float, float]
    mask: NDArray[np.bool_] | None = None


class WordDetector(Protocol):
    """What a package offers."""

    def detect(self, rgb: Image, words: Sequence[str]) -> Iterable[Found]:
        """Everything in a picture that some words fit; any objects with ``Found``'s attributes will do."""
        ...


class DetectorLabeller:
    """A ``Labeller`` that asks a detector; what it finds is matched to what stands out in depth.

    Args:
        detector: Who is asked.
        words: The words that it can tell; any when left out.
    """

    def __init__(self, detector: WordDetector, words: frozenset[str] | None = None) -> None:
        self._detector, self._words = detector, words

    @property
    def words(self) -> frozenset[str] | None:
        """The words that it can tell; None: any."""
        return self._words

    @property
    def trouble(self) -> str:
        """None: what it raises is raised."""
        return ""

    def scores(self, image: Image, boxes: Boxes, words: Sequence[str]) -> Array:
        """Of each box and word, the best score of what was found there; see ``Labeller``."""
        told = np.zeros((len(boxes), len(words)))
        for found in self._detector.detect(image, words):
            if found.label not in words:
                continue
            common = [_common(found, boxes, k) for k in range(len(boxes))]
            best = int(np.argmax(common)) if common else -1
            if best >= 0 and common[best] >= _LEAST_COMMON:
                column = list(words).index(found.label)
                told[best, column] = max(told[best, column], min(max(float(found.score), 0.0), 1.0))
        return told


def _common(found: Found, boxes: Boxes, k: int) -> float:
    """What a found thing and a box share, over both together."""
    if found.mask is not None:
        own = boxes.pieces == k + 1
        return float((own & found.mask).sum() / max(int((own | found.mask).sum()), 1))
    left, top, right, bottom = boxes.places[k].tolist()
    a, b, c, d = found.box
    wide, tall = min(right, c) - max(left, a), min(bottom, d) - max(top, b)
    shared = max(wide, 0.0) * max(tall, 0.0)
    both = (right - left) * (bottom - top) + (c - a) * (d - b) - shared
    return float(shared / max(both, 1e-9))


def outside_labellers() -> tuple[list[Labeller], list[str]]:
    """Those of other packages, by the names of their entry points, and complaints about those left out."""
    made: list[Labeller] = []
    complaints = []
    for point in sorted(importlib.metadata.entry_points(group=GROUP), key=lambda one: one.name):
        try:
            detector = point.load()()
            known = getattr(detector, "words", None)
            made.append(DetectorLabeller(detector, None if known is None else frozenset(known)))
        except Exception as broken:  # a package that cannot be used may raise anything
            complaints.append(f"labeller {point.name!r}: {type(broken).__name__}: {broken}")
    return made, complaints
