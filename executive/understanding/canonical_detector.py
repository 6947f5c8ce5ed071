"""A detector's words as sentences have them: what one calls a mug and the other a cup is the same thing."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import lru_cache

from executive.understanding.canonical_words import canonical_kind
from robots.perception.detector import Detection, Detector, PerceptionFrame
from robots.perception.fusion.cameras import PlacedCamera


class CanonicalDetector:
    """Tells what another detector sees, in canonical words; satisfies ``Detector``.

    A kind becomes its canonical word. What a detector called it stays, as one of its names or categories.
    What sentences call the same as one of its names, "milk" for a milk carton, is a name of it as well.
    """

    def __init__(self, detector: Detector, canonical: Callable[[str], str]) -> None:
        """Translate.

        Args:
            detector: Who sees.
            canonical: The word of sentences that means the same; a word that is unknown comes back as it is.
        """
        self._detector = detector
        self._canonical = lru_cache(maxsize=4096)(canonical)
        self._told: tuple[PerceptionFrame, PerceptionFrame] | None = None

    @property
    def labels(self) -> frozenset[str] | None:
        """The words that it can tell, and the canonical ones that mean the same; None: any."""
        labels = self._detector.labels
        return None if labels is None else labels | {self._canonical(word) for word in labels}

    @property
    def fronts(self) -> frozenset[str]:
        """The doors and drawers that it tells apart by the piece that they are of."""
        return self._detector.fronts

    def latest(self) -> PerceptionFrame | None:
        """The newest frame that has been delivered, or None before the first."""
        frame = self._detector.latest()
        if frame is None:
            return None
        if self._told is None or self._told[0] is not frame:
            self._told = frame, self._translated(frame)
        return self._told[1]

    def _translated(self, frame: PerceptionFrame) -> PerceptionFrame:
        seen = tuple(map(self._in_canonical_words, frame.detections))
        same = all(one is other for one, other in zip(seen, frame.detections, strict=True))
        return frame if same else replace(frame, detections=seen)

    def _in_canonical_words(self, seen: Detection) -> Detection:
        if seen.category != "object":
            return seen
        kind, categories = self._canonical(seen.kind), tuple(map(self._canonical, seen.categories))
        also = [word for name in seen.names if (word := self._canonical(name)) not in (name, kind)]
        names = tuple(dict.fromkeys((*seen.names, *also)))
        if kind != seen.kind:
            names = (*names, seen.kind)
        both = tuple(dict.fromkeys((*seen.categories, *categories)))
        if kind == seen.kind and both == seen.categories and names == seen.names:
            return seen
        return replace(seen, kind=kind, names=names, categories=both)


def in_canonical_words(camera: PlacedCamera) -> PlacedCamera:
    """A camera that stands in the room, telling in the words of sentences."""
    return replace(camera, detector=CanonicalDetector(camera.detector, canonical_kind))
