"""``python -m tools.pictures.draw_rooms``: draw floors and rooms as import-linter holds them."""

from __future__ import annotations

import sys
from html import escape

from tools.documents.rooms import FLOORS, ROOT, layers

PICTURE = ROOT / "docs" / "pictures" / "rooms.svg"

_WIDTH, _MARGIN, _LABEL = 800.0, 12.0, 122.0
_BOX, _ROW, _GAP, _BETWEEN = 22.0, 30.0, 6.0, 22.0
_LETTER, _PADDING = 6.3, 9.0
_COLOURS = {
    "tools": "#6d6875",
    "executive": "#1b6ca8",
    "trees": "#588157",
    "robots": "#b5651d",
    "kinematics": "#c8553d",
}
_SAYS = {
    "tools": "judge and measure",
    "executive": "sentences, sessions",
    "trees": "behaviors",
    "robots": "bodies, control",
    "kinematics": "geometry, motion",
}


def picture() -> str:
    """The picture, as SVG: a band for each floor, in it a row for each layer, in that a box for each room."""
    parts, top = [], _MARGIN
    for floor in FLOORS:
        rows = [line for row in layers(floor) for line in _lines(row)]
        height = _ROW * len(rows) + _GAP
        parts += [_band(floor, top, height), *_boxes(floor, rows, top)]
        top += height + _BETWEEN
        if floor != FLOORS[-1]:
            parts.append(_arrow(top - _BETWEEN))
    size = f'width="{_WIDTH:g}" height="{top:g}" viewBox="0 0 {_WIDTH:g} {top:g}"'
    style = 'font-family="DejaVu Sans, Verdana, sans-serif" font-size="11"'
    background = f'<rect width="{_WIDTH:g}" height="{top:g}" fill="white"/>'
    opened = f'<svg xmlns="http://www.w3.org/2000/svg" {size} {style}>'
    return "\n".join([opened, background, *parts, "</svg>", ""])


def _width(name: str) -> float:
    return _LETTER * len(name) + 2 * _PADDING


def _lines(row: list[str]) -> list[list[str]]:
    """A row of rooms, broken where it is too long for the picture."""
    lines: list[list[str]] = [[]]
    room = _WIDTH - 2 * _MARGIN - _LABEL - _GAP
    for name in row:
        if lines[-1] and sum(_width(one) + _GAP for one in (*lines[-1], name)) > room:
            lines.append([])
        lines[-1].append(name)
    return lines


def _band(floor: str, top: float, height: float) -> str:
    colour, middle = _COLOURS[floor], top + height / 2
    return (
        f'<rect x="{_MARGIN:g}" y="{top:g}" width="{_WIDTH - 2 * _MARGIN:g}" height="{height:g}" rx="6" '
        f'fill="{colour}" fill-opacity="0.10" stroke="{colour}"/>'
        f'<text x="{_MARGIN + 10:g}" y="{middle - 2:g}" font-size="14" font-weight="bold" '
        f'fill="{colour}">{floor}</text>'
        f'<text x="{_MARGIN + 10:g}" y="{middle + 13:g}" font-size="9" fill="#444">{_SAYS[floor]}</text>'
    )


def _boxes(floor: str, rows: list[list[str]], top: float) -> list[str]:
    parts = []
    for number, row in enumerate(rows):
        x, y = _MARGIN + _LABEL, top + _GAP + number * _ROW
        for name in row:
            width = _width(name)
            parts.append(
                f'<rect x="{x:g}" y="{y:g}" width="{width:g}" height="{_BOX:g}" rx="3" fill="white" '
                f'stroke="{_COLOURS[floor]}"/>'
                f'<text x="{x + width / 2:g}" y="{y + 15:g}" text-anchor="middle">{escape(name)}</text>'
            )
            x += width + _GAP
    return parts


def _arrow(y: float) -> str:
    x = _WIDTH / 2
    return (
        f'<path d="M{x:g},{y + 3:g} v12 m-5,-6 l5,6 l5,-6" fill="none" stroke="#444" stroke-width="1.5"/>'
        f'<text x="{x + 12:g}" y="{y + 14:g}" font-size="9" fill="#444">imports</text>'
    )


def main() -> int:
    """Write the picture."""
    PICTURE.write_text(picture(), "utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
