"""The page of the kinds of nodes: what a tree document may hold, with ports, promises and deadlines."""

from __future__ import annotations

from collections.abc import Iterable

from tools.documents.markdown import table
from trees.btcpp.builtin_kinds import BUILTIN_KINDS
from trees.btcpp.leaf_kinds import known_leaves, leaf_kind
from trees.btcpp.node_kind import NodeKind, Port
from trees.btcpp.own_kinds import OWN_KINDS
from trees.nodes.leaf import Leaf

_HEAD = """\
# Kinds of nodes

What a [tree document](../guides/trees.md) may hold. A port with a *default* is a setting, written as a
value; every other port is a reference, as `{key}`. Of a leaf is told what it moves and by when it has
ended, on the injected clock; a leaf whose motion takes longer adds the motion's own duration. Leaves of
other packages are not listed here.
"""
_ANY_NUMBER = 100


def node_kinds_page() -> str:
    """The page: built-in nodes, the project's own control nodes, leaves."""
    ours = {name: cls for name, cls in known_leaves().items() if cls.__module__.startswith("trees.")}
    parts = [_HEAD, "## Built in\n\nThey do what BehaviorTree.CPP's nodes of these names do.\n"]
    parts.append(table(("node", "category", "children", "ports"), map(_row, _sorted(BUILTIN_KINDS))))
    parts.append("## Our own control nodes\n")
    for kind in _sorted(OWN_KINDS.values()):
        told = f"{kind.description} {kind.category}; children: {_children(kind)}."
        parts += [f"### {kind.id}\n", f"{told.strip()}\n", _ports(kind.ports)]
    parts.append("## Leaves\n")
    for name, cls in ours.items():
        parts += [f"### {name}\n", _leaf(cls), _ports(leaf_kind(cls).ports)]
    return "\n".join(part for part in parts if part)


def _sorted(kinds: Iterable[NodeKind]) -> list[NodeKind]:
    return sorted(kinds, key=lambda kind: kind.id)


def _row(kind: NodeKind) -> tuple[str, ...]:
    ports = "; ".join(f"`{port.name}` = {port.default}: {port.description}" for port in kind.ports)
    return f"`{kind.id}`", kind.category.lower(), _children(kind), ports


def _children(kind: NodeKind) -> str:
    least, most = kind.children
    if most >= _ANY_NUMBER:
        return f"{least} or more"
    return str(least) if least == most else f"{least} to {most}"


def _leaf(cls: type[Leaf]) -> str:
    contract = cls.CONTRACT
    promises = f"Moves: {contract.moves}. Ends within {contract.deadline_s:g} s."
    return f"{leaf_kind(cls).description} {promises}\n"


def _ports(ports: Iterable[Port]) -> str:
    rows = [(f"`{port.name}`", port.direction, port.type, _default(port), port.description) for port in ports]
    return table(("port", "direction", "holds", "default", ""), rows) if rows else ""


def _default(port: Port) -> str:
    return "" if port.default is None else f"`{port.default}`" if port.default else "(empty)"
