"""Make a tree of a document of BehaviorTree.CPP 4: its control flow, our leaves."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass
from itertools import count
from typing import Any
from xml.etree.ElementTree import Element

from py_trees.behaviour import Behaviour

from trees.btcpp.catalogue import kind_called
from trees.btcpp.document import TreeDocument, kind_named, parse_document
from trees.btcpp.errors import TreeDocumentError
from trees.btcpp.literals import from_text
from trees.btcpp.node_kind import NodeKind, Parts
from trees.toolbox import Toolbox

Keys = Callable[[str], str]
"""From a key of a tree to the key of the whole."""

_SCRIPTED = (
    "_skipIf", "_successIf", "_failureIf", "_while", "_onSuccess", "_onFailure", "_onHalted", "_post",
)  # fmt: skip
_REFERENCE = re.compile(r"\{\s*(@?\w+|=)\s*\}")


def read_tree(text: str, toolbox: Toolbox) -> Behaviour:
    """The tree of a document; nothing of it has been ticked.

    A port that is left out refers to the key of its own name. Trees within trees have keys of their own
    but for those that are handed on, as in BehaviorTree.CPP.

    Args:
        text: The document.
        toolbox: What its leaves may call.

    Raises:
        TreeDocumentError: It is no such document, or has nodes, ports or values that are not known here.
    """
    document = parse_document(text)
    return _Reader(document, toolbox).tree(document.main, lambda key: key)


@dataclass(slots=True)
class _Place:
    """Where in the document something is."""

    names: tuple[str, ...]

    def __str__(self) -> str:
        return "/".join(self.names)


class _Reader:
    def __init__(self, document: TreeDocument, toolbox: Toolbox) -> None:
        self._document, self._toolbox = document, toolbox
        self._numbers = count(1)

    def tree(self, name: str, keys: Keys) -> Behaviour:
        return self._node(self._document.trees[name], keys, _Place((name,)))

    def _node(self, element: Element, keys: Keys, place: _Place) -> Behaviour:
        kind_id = kind_named(element)
        name = element.get("name", kind_id)
        here = _Place((*place.names, name))
        for scripted in _SCRIPTED:
            if scripted in element.attrib:
                raise TreeDocumentError(str(here), f"{scripted} needs a script, and scripts are not run")
        if kind_id == "SubTree":
            return self._subtree(element, keys, here)
        kind = kind_called(kind_id, str(here))
        least, most = kind.children
        if not least <= len(element) <= most:
            wanted = str(least) if least == most else f"{least} or more" if most > 3 else f"{least} to {most}"
            raise TreeDocumentError(str(here), f"needs {wanted} nodes below it, not {len(element)}")
        children = [self._node(child, keys, here) for child in element]
        node = kind.make(Parts(name, self._toolbox, children, _settings(element, kind, here)))
        node.name = name
        if wiring := _wiring(element, kind, keys, here):
            node.wiring = wiring  # type: ignore[attr-defined]
        if "_transparent" in element.attrib:
            node.transparent = element.get("_transparent") == "true"  # type: ignore[attr-defined]
        return node

    def _subtree(self, element: Element, keys: Keys, here: _Place) -> Behaviour:
        name = element.get("ID", "")
        if name not in self._document.trees:
            raise TreeDocumentError(str(here), f"there is no tree {name!r}")
        handed = {
            port: _key(text, port, keys, here)
            for port, text in element.attrib.items()
            if port not in ("ID", "name") and not port.startswith("_")
        }
        everything = element.get("_autoremap") in ("true", "1")
        own = f"{name}_{next(self._numbers)}_"

        def inner(key: str) -> str:
            return handed.get(key) or (keys(key) if everything else own + key)

        node = self.tree(name, inner)
        if "name" in element.attrib:
            node.name = element.attrib["name"]
        return node


def _settings(element: Element, kind: NodeKind, here: _Place) -> dict[str, Any]:
    values = {}
    known = {port.name for port in kind.ports}
    for name in element.attrib:
        if name not in (*known, "name", "ID") and not name.startswith("_"):
            ports = ", ".join(sorted(known)) or "none"
            raise TreeDocumentError(str(here), f"{kind.id} has no port {name!r}; it has {ports}")
    for port in kind.ports:
        if port.hint is None:
            continue
        text = element.get(port.name, port.default)
        if text is None:
            raise TreeDocumentError(str(here), f"{kind.id} needs a value at its port {port.name!r}")
        if port.name not in element.attrib and kind.category == "Action":
            continue  # the leaf's own default
        try:
            values[port.name] = from_text(text, port.hint)
        except (TypeError, ValueError, OverflowError) as wrong:
            raise TreeDocumentError(str(here), f"{port.name}: {wrong}") from wrong
    return values


def _wiring(element: Element, kind: NodeKind, keys: Keys, here: _Place) -> dict[str, str]:
    return {
        port.name: _key(element.get(port.name, "{=}"), port.name, keys, here)
        for port in kind.ports
        if port.hint is None
    }


def _key(text: str, port: str, keys: Keys, here: _Place) -> str:
    """What a reference refers to: "{key}", "{=}" for the port's own name, "{@key}" of the main tree."""
    found = _REFERENCE.fullmatch(text.strip())
    if found is None:
        raise TreeDocumentError(str(here), f"{port} must refer to a key, as {{{port}}}, not {text[:40]!r}")
    key = found[1]
    if key.startswith("@"):
        return key[1:]
    return keys(port if key == "=" else key)
