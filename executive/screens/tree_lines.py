"""A behavior tree as lines of text: short enough for 80 columns, readable without colour."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from types import MappingProxyType

from trees.snapshot import NodeSnapshot, NodeStatus, TreeSnapshot

GLYPHS: dict[NodeStatus, str] = {"idle": "·", "running": "▶", "success": "✓", "failure": "✗"}
ASCII_GLYPHS: dict[NodeStatus, str] = {"idle": ".", "running": ">", "success": "+", "failure": "x"}


@dataclass(frozen=True, slots=True)
class TreeLine:
    """One line and the status that colours it."""

    text: str
    status: NodeStatus


def tree_lines(
    snapshot: TreeSnapshot, width: int = 80, height: int | None = None, unicode: bool = True
) -> list[TreeLine]:
    """Lay a tree out, a node a line.

    Args:
        snapshot: What to show.
        width: Columns; longer lines end in an ellipsis.
        height: Rows; when the tree is taller, branches that have not begun fold to one line, then those
            that are done, the deepest first; what then still does not fit is cut around the running
            leaf. None: no limit.
        unicode: Whether the terminal has more than ASCII.
    """
    lines = list(_walk(snapshot.root, 0))
    if height is not None:
        for done_depth in range(max(depth for depth, _ in lines), -1, -1):
            if len(lines) <= height:
                break
            lines = list(_walk(snapshot.root, 0, {"idle": 0, "success": done_depth}))
        if len(lines) > height:
            lines = _window(lines, height)
    glyphs = GLYPHS if unicode else ASCII_GLYPHS
    return [TreeLine(_text(node, depth, width, glyphs, unicode), node.status) for depth, node in lines]


def _walk(
    node: NodeSnapshot, depth: int, folded: Mapping[str, int] = MappingProxyType({})
) -> Iterator[tuple[int, NodeSnapshot]]:
    """Every node with its depth; a node with a status of ``folded`` shows no children from that depth on."""
    yield depth, node
    if depth >= folded.get(node.status, depth + 1):
        return
    for child in node.children:
        yield from _walk(child, depth + 1, folded)


def _window(lines: list[tuple[int, NodeSnapshot]], height: int) -> list[tuple[int, NodeSnapshot]]:
    running = [index for index, (_, node) in enumerate(lines) if node.status == "running"]
    last = running[-1] if running else 0
    begin = min(max(0, last - height // 2), len(lines) - height)
    return lines[begin : begin + height]


def _text(node: NodeSnapshot, depth: int, width: int, glyphs: dict[NodeStatus, str], unicode: bool) -> str:
    message = f"  {node.message}" if node.message and node.status != "idle" else ""
    line = f"{'  ' * depth}{glyphs[node.status]} {node.name}{message}"
    line = "".join(one if one.isprintable() else " " for one in line)
    if not unicode:
        line = line.encode("ascii", "replace").decode()
    end = "…" if unicode else "~"
    return line if len(line) <= width else line[: width - 1] + end
