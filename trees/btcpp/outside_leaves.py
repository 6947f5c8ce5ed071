"""Leaves that other packages bring for trees in documents, found by their entry points.

A package declares them in its ``pyproject.toml``, in the group ``humanoid_executive.leaves``. One that
cannot be loaded is left out, and its error is kept to be told.
"""

from __future__ import annotations

import importlib.metadata
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache
from types import MappingProxyType
from typing import Any

from trees.extensions import LEAVES


@cache
def outside_leaves() -> OutsideLeaves:
    """Leaves that trees in documents may use, of the group ``humanoid_executive.leaves``, loaded once."""
    return load_leaves(importlib.metadata.entry_points(group=LEAVES))


@dataclass(frozen=True, slots=True)
class OutsideLeaves:
    """The classes of leaves that other packages bring, as far as they could be loaded.

    Attributes:
        leaves: Their classes.
        complaints: Why an entry point was not loaded, one line each.
    """

    leaves: tuple[type[Any], ...]
    complaints: tuple[str, ...] = ()


def load_leaves(points: Any) -> OutsideLeaves:
    """Load entry points of leaves, those with the smaller names first."""
    from trees.nodes.leaf import Leaf  # it loads what leaves act on

    def called(found: Any) -> str:
        if not (isinstance(found, type) and issubclass(found, Leaf) and hasattr(found, "CONTRACT")):
            raise ValueError("is no leaf with a contract")
        return found.__name__

    leaves, complaints = load_declared(points, "leaf", called)
    return OutsideLeaves(tuple(leaves.values()), complaints)


def load_declared(
    points: Any, what: str, called: Callable[[Any], str]
) -> tuple[Mapping[str, Any], tuple[str, ...]]:
    """Load entry points, those with the smaller names first; one whose name is taken is left out.

    Args:
        points: Entry points of one group.
        what: What they bring, in a word.
        called: Tells the name of what was loaded; raises ValueError with what is wrong with it.

    Returns:
        What was loaded, by name, and why an entry point was left out, one line each.
    """
    found: dict[str, Any] = {}
    complaints = []
    for point in sorted(points, key=lambda one: str(one.name)):
        try:
            one = point.load()
        except Exception as broken:
            complaints.append(f"{what} {point.name!r}: {type(broken).__name__}: {broken}")
            continue
        try:
            name = called(one)
        except (NameError, ValueError) as wrong:
            complaints.append(f"{what} {point.name!r}: {wrong}")
            continue
        if name in found:
            complaints.append(f"{what} {point.name!r}: there is a {what} {name!r} already")
        else:
            found[name] = one
    return MappingProxyType(found), tuple(complaints)
