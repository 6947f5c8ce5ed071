"""Draws how times grow: two diagrams side by side, all axes logarithmic, as SVG."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Protocol
from xml.sax.saxutils import escape

_WIDTH, _HEIGHT = 470, 380
_LEFT, _TOP, _RIGHT, _BOTTOM = 56, 34, 12, 116
# Told apart without colours too: by their order in the legend and their dashes.
_STROKES = (("#1b6ca8", ""), ("#c04f15", "7 3"), ("#3a7d44", "2 3"), ("#7a3b8f", "9 3 2 3"))


class Line(Protocol):
    """What is drawn; see ``Course``."""

    @property
    def name(self) -> str:
        """What is done."""

    @property
    def against(self) -> str:
        """What grows."""

    @property
    def counts(self) -> tuple[int, ...]:
        """How many of them."""

    @property
    def median_ms(self) -> tuple[float, ...]:
        """Time by count."""

    @property
    def exponent(self) -> float:
        """Slope in logarithms."""


def picture(lines: Sequence[Line]) -> str:
    """One SVG document, a diagram for each thing that grows."""
    subjects = list(dict.fromkeys(line.against for line in lines))
    drawn = [
        _diagram([line for line in lines if line.against == subject], subject, k * _WIDTH)
        for k, subject in enumerate(subjects)
    ]
    width = _WIDTH * len(subjects)
    head = (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{_HEIGHT}" '
        f'viewBox="0 0 {width} {_HEIGHT}" font-family="sans-serif" font-size="11">'
    )
    return "\n".join([head, f'<rect width="{width}" height="{_HEIGHT}" fill="white"/>', *drawn, "</svg>\n"])


def _diagram(lines: Sequence[Line], subject: str, offset: int) -> str:
    counts = [count for line in lines for count in line.counts]
    times = [time for line in lines for time in line.median_ms]
    right, floor = math.log10(max(counts)), math.floor(math.log10(min(times)))
    left, ceiling = math.log10(min(counts)), math.ceil(math.log10(max(times)))
    wide, high = _WIDTH - _LEFT - _RIGHT, _HEIGHT - _TOP - _BOTTOM

    def x(count: float) -> float:
        return offset + _LEFT + wide * (math.log10(count) - left) / (right - left)

    def y(time: float) -> float:
        return _TOP + high * (ceiling - math.log10(time)) / (ceiling - floor)

    parts = [_text(offset + _LEFT, _TOP - 14, f"processor time, ms, against the number of {subject}")]
    for power in range(floor, ceiling + 1):
        level = y(10.0**power)
        parts.append(
            _stroke([(offset + _LEFT, level), (offset + _WIDTH - _RIGHT, level)], "#dddddd", "", 1.0)
        )
        parts.append(_text(offset + _LEFT - 6, level + 4, f"{10.0**power:g}", "end"))
    parts += [_text(x(count), _TOP + high + 16, str(count), "middle") for count in lines[0].counts]
    for k, line in enumerate(lines):
        color, dashes = _STROKES[k % len(_STROKES)]
        points = [(x(count), y(time)) for count, time in zip(line.counts, line.median_ms, strict=True)]
        parts.append(_stroke(points, color, dashes, 2.0))
        parts += [f'<circle cx="{a:.1f}" cy="{b:.1f}" r="2.5" fill="{color}"/>' for a, b in points]
        row = _TOP + high + 38 + 17 * k
        parts.append(_stroke([(offset + _LEFT, row - 4), (offset + _LEFT + 30, row - 4)], color, dashes, 2.0))
        parts.append(_text(offset + _LEFT + 36, row, f"{line.name}: exponent {line.exponent:.2f}"))
    return "\n".join(parts)


def _stroke(points: Sequence[tuple[float, float]], color: str, dashes: str, width: float) -> str:
    path = " ".join(f"{a:.1f},{b:.1f}" for a, b in points)
    dash = f' stroke-dasharray="{dashes}"' if dashes else ""
    return f'<polyline points="{path}" fill="none" stroke="{color}" stroke-width="{width}"{dash}/>'


def _text(x: float, y: float, words: str, anchor: str = "start") -> str:
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}">{escape(words)}</text>'
