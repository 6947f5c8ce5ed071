"""A behavior tree as an SVG picture: a node a row, children below their parent and to its right."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from xml.etree.ElementTree import Element, SubElement, indent, tostring

from trees.snapshot import NodeKind, NodeSnapshot, NodeStatus, TreeSnapshot

_ROW, _COLUMN, _BOX_HEIGHT, _MARGIN = 26.0, 36.0, 20.0, 12.0
_LETTER = 6.6
"""Mean width of a letter of the font, a little generous."""
_SIGNS: dict[NodeKind, str] = {
    "sequence": "→ ",
    "selector": "? ",
    "parallel": "⇉ ",
    "decorator": "◇ ",
    "leaf": "",
}
_COLORS: dict[NodeStatus, str] = {
    "idle": "#f4f4f4",
    "running": "#ffe9a8",
    "success": "#c9ecc9",
    "failure": "#f6c6c6",
}


@dataclass(frozen=True, slots=True)
class _Box:
    node: NodeSnapshot
    x: float
    y: float
    width: float
    children: tuple[_Box, ...]

    def all(self) -> Iterator[_Box]:
        yield self
        for child in self.children:
            yield from child.all()


def as_svg(snapshot: TreeSnapshot) -> str:
    """A picture that needs no other program."""
    root, rows = _laid_out(snapshot.root, 0.0, 0)
    boxes = list(root.all())
    width = max(box.x + box.width for box in boxes) + 2.0 * _MARGIN
    height = rows * _ROW + 2.0 * _MARGIN
    picture = Element(
        "svg",
        {
            "xmlns": "http://www.w3.org/2000/svg",
            "viewBox": f"{-_MARGIN:g} {-_MARGIN:g} {width:g} {height:g}",
            "width": f"{width:g}",
            "height": f"{height:g}",
            "font-family": "sans-serif",
            "font-size": "12",
        },
    )
    SubElement(picture, "title").text = snapshot.root.name
    for box in boxes:
        for child in box.children:
            SubElement(picture, "path", d=_link(box, child), fill="none", stroke="#999")
    for box in boxes:
        _draw(picture, box)
    indent(picture)
    return tostring(picture, encoding="unicode")


def _laid_out(node: NodeSnapshot, x: float, row: int) -> tuple[_Box, int]:
    """The box of a node at its first row, with the boxes below it, and the first row after them."""
    width = _LETTER * len(_label(node)) + 14.0
    children = []
    after = row + 1
    for number, child in enumerate(node.children):
        box, after = _laid_out(child, x + _COLUMN, row + 1 if number == 0 else after)
        children.append(box)
    return _Box(node, x, row * _ROW, width, tuple(children)), after


def _link(parent: _Box, child: _Box) -> str:
    x, y = parent.x + 0.4 * _COLUMN, child.y + 0.5 * _BOX_HEIGHT
    return f"M {x:g} {parent.y + _BOX_HEIGHT:g} V {y:g} H {child.x:g}"


def _draw(picture: Element, box: _Box) -> None:
    leaf = box.node.kind == "leaf"
    shape = {"x": f"{box.x:g}", "y": f"{box.y:g}", "width": f"{box.width:g}", "height": f"{_BOX_HEIGHT:g}"}
    rounded = "10" if leaf else "2"
    SubElement(picture, "rect", {**shape, "rx": rounded, "fill": _COLORS[box.node.status], "stroke": "#555"})
    place = {"x": f"{box.x + 7.0:g}", "y": f"{box.y + 14.0:g}"}
    SubElement(picture, "text", place).text = _label(box.node)


def _label(node: NodeSnapshot) -> str:
    return _SIGNS[node.kind] + node.name
