"""A behavior tree as text, Graphviz, XML in the manner of BehaviorTree.CPP, or JSON."""

from __future__ import annotations

import json
import xml.etree.ElementTree as ElementTree
from collections.abc import Callable, Iterator
from itertools import count

from executive.events import plain
from executive.outputs.tree_lines import tree_lines
from trees.snapshot import NodeKind, NodeSnapshot, TreeSnapshot

_SHAPES: dict[NodeKind, str] = {
    "sequence": "box",
    "selector": "octagon",
    "parallel": "parallelogram",
    "decorator": "ellipse",
    "leaf": "ellipse",
}
_TAGS: dict[NodeKind, str] = {
    "sequence": "Sequence",
    "selector": "Fallback",
    "parallel": "Parallel",
    "decorator": "Decorator",
    "leaf": "Action",
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


def as_xml(snapshot: TreeSnapshot) -> str:
    """XML in the manner of BehaviorTree.CPP 4, for its viewers."""

    def element(node: NodeSnapshot) -> ElementTree.Element:
        made = ElementTree.Element(_TAGS[node.kind], name=node.name)
        made.extend(map(element, node.children))
        return made

    root = ElementTree.Element("root", BTCPP_format="4", main_tree_to_execute=snapshot.root.name)
    tree = ElementTree.SubElement(root, "BehaviorTree", ID=snapshot.root.name)
    tree.append(element(snapshot.root))
    ElementTree.indent(root)
    return ElementTree.tostring(root, encoding="unicode")


FORMATS: dict[str, Callable[[TreeSnapshot], str]] = {
    "text": as_text,
    "json": as_json,
    "dot": as_dot,
    "xml": as_xml,
}
