"""A behavior tree as text, Graphviz, a picture, or JSON."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from itertools import count

from executive.screens.tree_drawing import as_svg
from executive.screens.tree_lines import tree_lines
from executive.session.events import plain
from trees.snapshot import NodeKind, NodeSnapshot, TreeSnapshot

_SHAPES: dict[NodeKind, str] = {
    "sequence": "box",
    "selector": "octagon",
    "parallel": "parallelogram",
    "decorator": "ellipse",
    "leaf": "ellipse",
}


def as_text(snapshot: TreeSnapshot) -> str:
    """One line a node."""
    return "\n".join(line.text for line in tree_lines(snapshot, width=200))


def as_json(snapshot: TreeSnapshot) -> str:
    """Nodes with their names, kinds and children."""
    return json.dumps(plain(snapshot.root), indent=2)


def as_dot(snapshot: TreeSnapshot) -> str:
    """A Graphviz digraph."""
    numbers = count()

    def rows(node: NodeSnapshot, parent: int | None) -> Iterator[str]:
        number = next(numbers)
        yield f"  n{number} [label={json.dumps(node.name)}, shape={_SHAPES[node.kind]}];"
        if parent is not None:
            yield f"  n{parent} -> n{number};"
        for child in node.children:
            yield from rows(child, number)

    return "\n".join(["digraph tree {", *rows(snapshot.root, None), "}"])


FORMATS: dict[str, Callable[[TreeSnapshot], str]] = {
    "text": as_text,
    "json": as_json,
    "dot": as_dot,
    "svg": as_svg,
}
