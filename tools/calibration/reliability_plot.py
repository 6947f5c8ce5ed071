"""A picture of stated confidences and of how often they were right."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from xml.etree.ElementTree import Element, SubElement, indent, tostring

from tools.calibration.answers import Answer
from tools.calibration.reliability import Bin, expected_error, reliability

_SIDE, _LEFT, _TOP, _BELOW = 420.0, 60.0, 30.0, 70.0
_COLORS = ("#1f6f8b", "#c8553d", "#555555")


def as_svg(found: Mapping[str, Sequence[Answer]]) -> str:
    """One series for each camera, with Wilson's 95 % intervals; the diagonal is perfect."""
    width, height = _LEFT + _SIDE + 30.0, _TOP + _SIDE + _BELOW
    picture = Element(
        "svg",
        {
            "xmlns": "http://www.w3.org/2000/svg",
            "viewBox": f"0 0 {width:g} {height:g}",
            "width": f"{width:g}",
            "height": f"{height:g}",
            "font-family": "sans-serif",
            "font-size": "13",
        },
    )
    SubElement(picture, "title").text = "Stated confidence of count and describe, and how often it is right"
    SubElement(picture, "rect", width=f"{width:g}", height=f"{height:g}", fill="white")
    for share in (0.0, 0.2, 0.4, 0.6, 0.8, 1.0):
        _line(picture, (share, 0.0), (share, 1.0), "#e4e4e4")
        _line(picture, (0.0, share), (1.0, share), "#e4e4e4")
        _text(picture, _x(share), _y(0.0) + 18.0, f"{share:g}", "middle")
        _text(picture, _x(0.0) - 8.0, _y(share) + 4.0, f"{share:g}", "end")
    _line(picture, (0.0, 0.0), (1.0, 1.0), "#999", "6 4")
    _text(picture, _x(0.5), _y(0.0) + 38.0, "stated confidence", "middle")
    label = _text(picture, 16.0, _y(0.5), "share that is right", "middle")
    label.set("transform", f"rotate(-90 16 {_y(0.5):g})")
    for number, (name, answers) in enumerate(found.items()):
        color = _COLORS[number % len(_COLORS)]
        for item in reliability(answers):
            _point(picture, item, color)
        words = f"{name} camera: {len(answers)} answers, error {expected_error(answers):.3f}"
        _text(picture, _x(0.03), _y(0.12) + 18.0 * number, words, "start").set("fill", color)
    indent(picture)
    return tostring(picture, encoding="unicode") + "\n"


def _x(share: float) -> float:
    return _LEFT + share * _SIDE


def _y(share: float) -> float:
    return _TOP + (1.0 - share) * _SIDE


def _line(
    picture: Element, start: tuple[float, float], end: tuple[float, float], color: str, dashes: str = ""
) -> None:
    places = {"x1": _x(start[0]), "y1": _y(start[1]), "x2": _x(end[0]), "y2": _y(end[1])}
    line = SubElement(picture, "line", {name: f"{value:.1f}" for name, value in places.items()}, stroke=color)
    if dashes:
        line.set("stroke-dasharray", dashes)


def _point(picture: Element, item: Bin, color: str) -> None:
    _line(picture, (item.stated, item.low), (item.stated, item.high), color)
    size = 3.0 + 0.25 * item.count**0.5
    centre = {"cx": f"{_x(item.stated):.1f}", "cy": f"{_y(item.right):.1f}", "r": f"{size:.1f}"}
    SubElement(picture, "circle", centre, fill=color)


def _text(picture: Element, x: float, y: float, words: str, anchor: str) -> Element:
    item = SubElement(picture, "text", {"x": f"{x:.1f}", "y": f"{y:.1f}", "text-anchor": anchor})
    item.text = words
    return item
