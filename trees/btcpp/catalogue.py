"""All kinds of nodes that trees here are made of."""

from __future__ import annotations

import difflib
from collections.abc import Mapping
from functools import cache
from types import MappingProxyType

from py_trees.behaviour import Behaviour

from trees.btcpp.builtin_kinds import BUILTIN_KINDS, builtin_kind
from trees.btcpp.errors import TreeDocumentError
from trees.btcpp.leaf_kinds import known_leaves, leaf_kind
from trees.btcpp.node_kind import NodeKind
from trees.btcpp.outside_leaves import outside_leaves
from trees.btcpp.own_kinds import OWN_KINDS
from trees.nodes.leaf import Leaf


@cache
def kinds_by_id() -> Mapping[str, NodeKind]:
    """Every kind that a document may use."""
    kinds = [*BUILTIN_KINDS, *OWN_KINDS.values(), *map(leaf_kind, known_leaves().values())]
    return MappingProxyType({kind.id: kind for kind in reversed(kinds)})


def kind_called(name: str, where: str) -> NodeKind:
    """The kind with an ID.

    Raises:
        TreeDocumentError: There is none.
    """
    kind = kinds_by_id().get(name)
    if kind is None:
        close = difflib.get_close_matches(name, kinds_by_id(), n=1)
        hint = f"; did you mean {close[0]!r}?" if close else ""
        lost = "".join(f" ({complaint}: left out)" for complaint in outside_leaves().complaints)
        raise TreeDocumentError(where, f"there is no node {name!r}{hint}{lost}")
    return kind


def kind_of(node: Behaviour) -> NodeKind:
    """The kind of a node.

    Raises:
        TreeDocumentError: There is no kind for such nodes.
    """
    if isinstance(node, Leaf):
        return leaf_kind(type(node))
    kind = OWN_KINDS.get(type(node)) or builtin_kind(node)
    if kind is None:
        raise TreeDocumentError(node.name, f"a {type(node).__name__} has no kind that could be written")
    return kind
