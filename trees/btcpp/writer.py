"""Write a tree as BehaviorTree.CPP 4 does, with the model of its nodes that Groot2 needs."""

from __future__ import annotations

from xml.etree import ElementTree
from xml.etree.ElementTree import Element, SubElement

from py_trees.behaviour import Behaviour

from trees.btcpp.catalogue import kind_of, kinds_by_id
from trees.btcpp.document import FORMAT
from trees.btcpp.errors import TreeDocumentError
from trees.btcpp.literals import to_text
from trees.btcpp.node_kind import NodeKind


def write_tree(root: Behaviour) -> str:
    """A tree as a document; ``read_tree`` makes the same tree of it.

    Raises:
        TreeDocumentError: Some node has no kind, or a setting that cannot be written.
    """
    name = _tree_id(root.name)
    document = Element("root", BTCPP_format=FORMAT, main_tree_to_execute=name)
    SubElement(document, "BehaviorTree", ID=name).append(_element(root))
    kinds = {kind.id: kind for kind in map(kind_of, root.iterate()) if not kind.builtin}
    document.append(model_of(sorted(kinds.values(), key=lambda kind: (kind.category, kind.id))))
    ElementTree.indent(document)
    return ElementTree.tostring(document, encoding="unicode")


def model_of(kinds: list[NodeKind]) -> Element:
    """What an editor has to know of nodes that BehaviorTree.CPP does not bring along."""
    model = Element("TreeNodesModel")
    for kind in kinds:
        entry = SubElement(model, kind.category, ID=kind.id)
        for port in kind.ports:
            item = SubElement(entry, f"{port.direction}_port", name=port.name, type=port.type)
            if port.default is not None:
                item.set("default", port.default)
            item.text = port.description or None
        if kind.description:
            SubElement(SubElement(entry, "MetadataFields"), "Metadata", description=kind.description)
    return model


def _tree_id(name: str) -> str:
    """An ID without blanks that no node has: "open or close" is OpenOrClose."""
    words = "".join(letter if letter.isalnum() else " " for letter in name).split()
    name = "".join(word[:1].upper() + word[1:] for word in words) or "Tree"
    return f"{name}Tree" if name in kinds_by_id() else name


def _element(node: Behaviour) -> Element:
    kind = kind_of(node)
    made = Element(kind.id, name=node.name)
    values, wiring = kind.settings(node), getattr(node, "wiring", {})
    for port in kind.ports:
        if port.hint is None:
            made.set(port.name, f"{{{wiring.get(port.name, port.name)}}}")
            continue
        if port.name not in values:
            continue
        try:
            text = to_text(values[port.name])
        except ValueError as unwritable:
            raise TreeDocumentError(node.name, f"{port.name}: {unwritable}") from unwritable
        if text != port.default:
            made.set(port.name, text)
    transparent = bool(getattr(node, "transparent", False))
    if transparent != kind.transparent:
        made.set("_transparent", to_text(transparent))
    made.extend([_element(child) for child in node.children])
    return made
