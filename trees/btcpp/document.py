"""Documents of BehaviorTree.CPP 4: told apart from other text before anything is made of them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from xml.etree import ElementTree
from xml.etree.ElementTree import Element

from trees.btcpp.errors import TreeDocumentError

FORMAT = "4"
_LARGEST = 2_000_000
"""Characters; the trees of all skills together are a fourth of it."""
MOST_NODES = 10_000
"""Nodes of the tree to run, each sub-tree written out wherever it is used."""
NESTED_MOST = 200
"""Nodes from its root down to a leaf; where a sub-tree is used is a node as well."""
CATEGORIES = ("Action", "Condition", "Control", "Decorator")
"""Elements that name their kind in ``ID``."""
_BESIDE_TREES = ("TreeNodesModel", "include")


@dataclass(frozen=True, slots=True)
class TreeDocument:
    """The trees of a document.

    Attributes:
        trees: The root node of each tree, by the tree's ID.
        main: ID of the tree to run.
    """

    trees: Mapping[str, Element]
    main: str


def parse_document(text: str) -> TreeDocument:
    """Read a document.

    Raises:
        TreeDocumentError: It is no such document. Documents that define entities are refused unread, and
            so are those that include others.
    """
    if len(text) > _LARGEST:
        raise TreeDocumentError("", f"longer than {_LARGEST} characters")
    if "<!DOCTYPE" in text or "<!ENTITY" in text:
        raise TreeDocumentError("", "document types and entities are not read")
    try:
        root = ElementTree.fromstring(text)
    except (ElementTree.ParseError, ValueError) as broken:
        raise TreeDocumentError("", f"is no XML: {broken}") from broken
    if root.tag != "root" or root.get("BTCPP_format") != FORMAT:
        raise TreeDocumentError("", f'must be a <root BTCPP_format="{FORMAT}">')
    trees: dict[str, Element] = {}
    for item in root:
        if item.tag == "include":
            raise TreeDocumentError("include", "other files are not read")
        if item.tag in _BESIDE_TREES:
            continue
        if item.tag != "BehaviorTree":
            raise TreeDocumentError(item.tag, "is neither a <BehaviorTree> nor a <TreeNodesModel>")
        name = item.get("ID", "")
        if not name or name in trees:
            raise TreeDocumentError(name, "every <BehaviorTree> needs an ID of its own")
        if len(item) != 1:
            raise TreeDocumentError(name, f"needs one root node, not {len(item)}")
        trees[name] = item[0]
    main = _main(root, trees)
    _check_size(trees, main)
    return TreeDocument(MappingProxyType(trees), main)


def kind_named(element: Element) -> str:
    """The ID of the kind of node that an element is."""
    return element.get("ID", "") if element.tag in CATEGORIES else element.tag


def _main(root: Element, trees: Mapping[str, Element]) -> str:
    named = root.get("main_tree_to_execute")
    if named is None and len(trees) == 1:
        return next(iter(trees))
    if named is None or named not in trees:
        known = ", ".join(trees) or "none"
        raise TreeDocumentError("", f"main_tree_to_execute must be one of its trees: {known}")
    return named


def _check_size(trees: Mapping[str, Element], main: str) -> None:
    """Refuse what is too large or too deep with its sub-trees written out, or holds itself.

    Nothing is made yet, the stack is a list, and the first node beyond the budget is the last one that is
    looked at: a document of a few lines can mean more nodes than any memory holds.
    """
    pending: list[tuple[Element, tuple[str, ...], int]] = [(trees[main], (main,), 1)]
    nodes = 0
    while pending:
        element, above, depth = pending.pop()
        nodes += 1
        if nodes > MOST_NODES:
            raise TreeDocumentError(main, f"has more than {MOST_NODES} nodes, sub-trees written out")
        if depth > NESTED_MOST:
            raise TreeDocumentError(above[-1], f"deeper than {NESTED_MOST} nodes, sub-trees written out")
        name = element.get("ID", "") if kind_named(element) == "SubTree" else None
        if name is not None and name in trees:
            if name in above:
                raise TreeDocumentError("/".join(above), f"the tree {name!r} is within itself")
            pending.append((trees[name], (*above, name), depth + 1))
        pending += [(child, above, depth + 1) for child in element]
