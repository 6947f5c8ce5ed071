"""Find out of a tree's nodes why they failed, and where in the tree they are."""

from __future__ import annotations

from py_trees.behaviour import Behaviour
from py_trees.common import Status

from trees.failures import Failure


def failure_of(node: Behaviour) -> Failure | None:
    """Why a node failed: its own failure, or that of the child that failed it."""
    own = getattr(node, "failure", None)
    if isinstance(own, Failure):
        return own
    failed = [child for child in node.children if child.status is Status.FAILURE]
    return failure_of(failed[-1]) if failed else None


def place_of(node: Behaviour) -> str:
    """Names from the root down to a node, joined by "/"; nodes that only structure are left out."""
    names = [node.name]
    above = node.parent
    while above is not None:
        if above.parent is None or not getattr(above, "transparent", False):
            names.append(above.name)
        above = above.parent
    return "/".join(reversed(names))


def followed_by(failure: Failure, earlier: Failure | None) -> Failure:
    """Append an earlier failure at the end of a failure's chain of causes."""
    if earlier is None:
        return failure
    if failure.cause is None:
        return failure.caused_by(earlier)
    return failure.caused_by(followed_by(failure.cause, earlier))
