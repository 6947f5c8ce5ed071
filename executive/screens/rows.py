"""Rows of a screen as pieces of plain text in a style, fitted to a width; nothing is told by colour alone."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

from executive.screens.tree_lines import tree_lines
from trees.snapshot import NodeSnapshot, TreeSnapshot

Style = Literal["", "bold", "dim", "ok", "running", "bad", "ask", "alarm", "cursor"]

_TREE_STYLES: dict[str, Style] = {"idle": "dim", "running": "running", "success": "ok", "failure": "bad"}


@dataclass(frozen=True, slots=True)
class Cell:
    """A piece of a row in one style."""

    text: str
    style: Style = ""


Row = tuple[Cell, ...]


def text_of(rows: Sequence[Row]) -> str:
    """The rows without their styles."""
    return "\n".join("".join(cell.text for cell in row).rstrip() for row in rows)


def line_row(text: str, style: Style, width: int, unicode: bool) -> Row:
    """A line as a row of one style."""
    return (Cell(fitted(printable(text), width, unicode), style),)


def rule_row(width: int, unicode: bool) -> Row:
    """A line across."""
    return (Cell(fitted(("─" if unicode else "-") * width, width, unicode), "dim"),)


def tree_rows(tree: TreeSnapshot | None, width: int, height: int, unicode: bool) -> list[Row]:
    """A tree in so many rows, folded where it is taller."""
    if tree is None:
        return [(Cell(fitted("nothing is under way", width, unicode), "dim"),)]
    lines = tree_lines(tree, width, height, unicode)
    return [(Cell(line.text, _TREE_STYLES[line.status]),) for line in lines]


def beside(left: Sequence[Row], left_width: int, right: Sequence[Row], unicode: bool) -> list[Row]:
    """Rows at the left and at the right of a bar."""
    rows: list[Row] = []
    for index in range(max(len(left), len(right))):
        begin = left[index] if index < len(left) else ()
        used = sum(len(cell.text) for cell in begin)
        end = right[index] if index < len(right) else ()
        gap = Cell(" " * max(left_width - used, 0))
        rows.append((*begin, gap, Cell(" │ " if unicode else " | ", "dim"), *end))
    return rows


def running_step(tree: TreeSnapshot | None) -> str:
    """The running leaf with its place and its message."""
    if tree is None or tree.root.status != "running":
        return ""
    names: list[str] = []
    node: NodeSnapshot | None = tree.root
    message = ""
    while node is not None:
        names.append(node.name)
        message = node.message
        node = next((child for child in node.children if child.status == "running"), None)
    return "/".join([names[0], *names[-2:]] if len(names) > 3 else names) + (
        f": {message}" if message else ""
    )


def printable(text: str) -> str:
    """The text without what would move a terminal's cursor."""
    return "".join(one if one.isprintable() else " " for one in text)


def fitted(text: str, width: int, unicode: bool) -> str:
    """The text in at most so many columns."""
    if not unicode:
        text = text.encode("ascii", "replace").decode()
    end = "…" if unicode else "~"
    return text if len(text) <= width else text[: max(width - 1, 0)] + end[: max(width, 0)]
