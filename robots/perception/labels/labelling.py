"""Who is asked what things are called, as a value that crosses to the process that looks at pictures."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from robots.perception.labels.asking import AskAboutPictures
from robots.perception.labels.labeller import Labeller
from robots.perception.labels.naming import Labellers
from robots.perception.labels.outside import outside_labellers


@dataclass(frozen=True, slots=True)
class Labelling:
    """Which labellers there are, beside shape and colour.

    Attributes:
        shown: Folder of things that were shown; None for none.
        packages: Whether detectors of other installed packages are asked.
        model: Asks a model; None for none.
        words: What those are asked for that can tell any word.
    """

    shown: Path | None = None
    packages: bool = False
    model: AskAboutPictures | None = None
    words: tuple[str, ...] = ()

    def labeller(self) -> Labellers | None:
        """All of them as one, what was shown first; None when there is none."""
        # looking at pictures needs OpenCV, which not everybody has who builds one of these
        from robots.perception.labels.shown import ShownLabeller
        from robots.perception.labels.views import kept_views
        from robots.perception.labels.vision_model import VisionLabeller

        members: list[Labeller] = []
        if self.shown is not None and (views := kept_views(self.shown)):
            members.append(ShownLabeller(views))
        if self.packages:
            members += outside_labellers()[0]
        if self.model is not None:
            members.append(VisionLabeller(self.model))
        return Labellers(members) if members else None

    def asked(self, labellers: Labellers) -> tuple[str, ...]:
        """What labellers are asked for: what they can tell, and the words that are to be told."""
        return tuple(sorted({*labellers.known, *self.words}))


BY_SHAPE = Labelling()
"""Nobody else is asked."""
