"""Where a running tree is: which leaves have begun, read from its events."""

from __future__ import annotations

from trees.events import NodeChanged


class PhaseWatch:
    """Remembers when each node first ran; put its ``take`` into the session's sink."""

    def __init__(self) -> None:
        self._began_s: dict[str, float] = {}

    def take(self, event: object) -> None:
        """Take one event of any kind."""
        if isinstance(event, NodeChanged) and event.status == "running":
            self._began_s.setdefault(event.where.rsplit("/", 1)[-1], event.t_s)

    def began_s(self, name: str) -> float | None:
        """When a node of that name first ran, or None."""
        return self._began_s.get(name)
