"""The page of how processor time grows."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from tools.documents.markdown import table

_HEAD = """\
# How times grow

![processor time against the number of obstacles and of waypoints](pictures/scaling.svg)

Made by `make report` (`python -m tools.benchmark.scaling --repeats {repeats}`); do not edit. Median
processor time of {repeats} scenes or paths of each count, in milliseconds. *exponent* is the slope of a
straight line through the upper half of the points, both axes logarithmic; read the slopes and not the
single points. A planned path has no exponent that means much: with 1,000 boxes about the arm a search may
end at once, because a goal is shut in. Boxes of 4 cm stand in a shell about the arm's reach, for the
checker ahead of the humanoid.
"""


@dataclass(frozen=True, slots=True)
class Course:
    """One quantity as it grows.

    Attributes:
        name: What is done.
        against: What grows.
        counts: How many of them.
        median_ms: Processor time, by count.
        p95_ms: The same, 95th percentile.
        exponent: Slope in logarithms over the upper half of the counts.
    """

    name: str
    against: str
    counts: tuple[int, ...]
    median_ms: tuple[float, ...]
    p95_ms: tuple[float, ...]
    exponent: float


def scaling_page(courses: Sequence[Course], repeats: int) -> str:
    """The page, a table for each quantity that grows.

    Args:
        courses: What was measured.
        repeats: Scenes or paths of each count.
    """
    parts = [_HEAD.format(repeats=repeats)]
    for against in dict.fromkeys(item.against for item in courses):
        rows = [item for item in courses if item.against == against]
        head = (f"against {against}", *map(str, rows[0].counts), "exponent")
        body = ((item.name, *(f"{ms:.3g}" for ms in item.median_ms), f"{item.exponent:.2f}") for item in rows)
        parts.append(table(head, body))
    return "\n".join(parts)
