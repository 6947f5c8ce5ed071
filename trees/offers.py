"""How one sees from outside that a robot holds something out to somebody."""

from __future__ import annotations

from typing import Final

from trees.events import NodeChanged

OFFERED: Final = "wait for the pull"
"""Name of the leaf that holds it out."""


def is_offer(event: object) -> bool:
    """Tell whether with this event something begins to be held out."""
    return isinstance(event, NodeChanged) and event.status == "running" and event.where.endswith(OFFERED)
