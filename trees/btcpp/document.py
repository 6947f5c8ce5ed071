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
_DEEPEST = 200
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
        _check_depth(item[0], name)
        trees[name] = item[0]
    return TreeDocument(MappingProxyType(trees), _main(root, trees))


def _main(root: Element, trees: Mapping[str, Element]) -> str:
    named = root.get("main_tree_to_execute")
    if named is None and len(trees) == 1:
        return next(iter(trees))
    if named is None or named not in trees:
        known = ", ".join(trees) or "none"
        raise TreeDocumentError("", f"main_tree_to_execute must be one of its trees: {known}")
    return named


def _check_depth(node: Element, name: str) -> None:
    level = [node]
    for _ in range(_DEEPEST):
        level = [child for parent in level for child in parent]
        if not level:
            return
    raise TreeDocumentError(name, f"deeper than {_DEEPEST} nodes")
