"""Which nodes of the tree are shown: branches fold by how they stand, unless a person has said otherwise."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True, slots=True)
class Line:
    """A node of the tree as it is shown.

    Attributes:
        node: With name, status, message and depth.
        path: Its name behind those that it is in, with slashes between.
        branch: Whether there are nodes in it.
        open: Whether these are shown.
    """

    node: Mapping[str, Any]
    path: str
    branch: bool
    open: bool


def lines_of(
    nodes: Sequence[Mapping[str, Any]], chosen: Mapping[str, bool], unfolded: bool = False
) -> list[Line]:
    """The nodes that are shown.

    Branches that have succeeded, or have not begun, are folded.

    Args:
        nodes: From the root down, with their depths.
        chosen: Of branches by their paths, whether a person wants them open.
        unfolded: Whether all that nobody has chosen is open.
    """
    found: list[Line] = []
    names: list[str] = []
    closed_at: int | None = None
    for index, node in enumerate(nodes):
        depth = int(node["depth"])
        names = [*names[:depth], str(node["name"])]
        if closed_at is not None and depth > closed_at:
            continue
        branch = index + 1 < len(nodes) and int(nodes[index + 1]["depth"]) > depth
        usual = unfolded or not depth or node["status"] not in ("idle", "success")
        path = "/".join(names)
        is_open = chosen.get(path, usual)
        closed_at = None if is_open else depth
        found.append(Line(node, path, branch, is_open))
    return found
