"""The detector of a robot whose body brings no eyes."""

from __future__ import annotations

from robots.perception.detector import PerceptionFrame


class NoEyes:
    """Sees nothing, and says so of every word; satisfies ``Detector``."""

    @property
    def labels(self) -> frozenset[str]:
        """None is ever told."""
        return frozenset()

    @property
    def fronts(self) -> frozenset[str]:
        """None either."""
        return frozenset()

    def latest(self) -> PerceptionFrame | None:
        """There is none."""
        return None
