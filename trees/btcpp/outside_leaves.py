"""Leaves that other packages bring for trees in documents, found by their entry points.

A package declares them in its ``pyproject.toml``, in the group ``humanoid_executive.leaves``. One that
cannot be loaded is left out, and its error is kept to be told.
"""

from __future__ import annotations

import importlib.metadata
from dataclasses import dataclass
from functools import cache
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

    leaves: dict[str, type[Any]] = {}
    complaints = []
    for point in sorted(points, key=lambda one: str(one.name)):
        try:
            found = point.load()
        except Exception as broken:
            complaints.append(f"leaf {point.name!r}: {type(broken).__name__}: {broken}")
            continue
        if not (isinstance(found, type) and issubclass(found, Leaf) and hasattr(found, "CONTRACT")):
            complaints.append(f"leaf {point.name!r} is no leaf with a contract")
        elif found.__name__ in leaves:
            complaints.append(f"leaf {point.name!r}: there is a leaf {found.__name__} already")
        else:
            leaves[found.__name__] = found
    return OutsideLeaves(tuple(leaves.values()), tuple(complaints))
