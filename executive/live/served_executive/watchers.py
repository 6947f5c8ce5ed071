"""Who watches the executive: told of each event, of the tree as it changes, and where a run is recorded.

Nothing is made for them while nobody watches.
"""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Mapping
from typing import Any

from executive.live.told_as_json import statuses, tree_json
from executive.reports.feedback import line_for
from executive.session.events import Event, PlanningAnswered, SensorsNoted, event_json
from robots.live.wire.connection import Connection
from robots.live.wire.messages import write_message
from trees.snapshot import TreeSnapshot

TREE_EVERY_S = 0.04
"""Control time between two states of a tree: 25 a second."""
_MOST_BYTES = 60_000
"""Of an event as it is told: a message of the protocol holds 65,536."""


class Watchers:
    """Connections that watch.

    Attributes:
        connections: Them.
    """

    def __init__(self) -> None:
        self.connections: list[Connection] = []
        self._told_s = -math.inf
        self._tree: Mapping[str, Any] = {}
        self._run = ""

    def add(self, connection: Connection) -> None:
        """One more watches; the run under way and the newest state of the tree are told to it at once."""
        if connection not in self.connections:
            self.connections.append(connection)
        if self._run:
            connection.send(write_message("run", path=self._run, under_way=True))
        self._told_s, self._tree = -math.inf, {}

    def run_begins(self, path: str) -> None:
        """Tell that a run begins.

        Args:
            path: The folder where it is recorded.
        """
        self._run = path
        self._tell(write_message("run", path=path, under_way=True))

    def run_ended(self) -> None:
        """Tell that it has ended, where one was under way."""
        if self._run:
            self._tell(write_message("run", path=self._run, under_way=False))
            self._run = ""

    def remove(self, connection: Connection) -> None:
        """It watches no more."""
        if connection in self.connections:
            self.connections.remove(connection)

    def event(self, event: Event) -> None:
        """Tell of an event, with its line for people; one that is too long for a message loses what it says.

        Events that tell nothing to a person or a picture, and are for the digest alone, are left out.
        """
        if not self.connections or isinstance(event, PlanningAnswered | SensorsNoted):
            return
        told, line = event_json(event), line_for(event)
        if len(json.dumps([told, line])) > _MOST_BYTES:
            told, line = {"event": told["event"], "t_s": told.get("t_s", 0.0)}, (line or "")[:1000]
        self._tell(write_message("event", told=told, line=line))

    def tree(
        self, snapshot: Callable[[], TreeSnapshot], t_s: float, last: bool = False, number: int = 0
    ) -> None:
        """Tell of the tree where it has changed, no more often than ``TREE_EVERY_S``.

        Args:
            snapshot: Makes one; called only when it will be looked at.
            t_s: Control time.
            last: Whether the tree has ended: this state is told whenever the one before was.
            number: Of the tree; another one has another number.
        """
        if not self.connections or (not last and 0.0 <= t_s - self._told_s < TREE_EVERY_S):
            return
        root = snapshot().root
        told = {"nodes": tree_json(root), "number": number, "statuses": statuses(root)}
        self._told_s = t_s
        if told != self._tree:
            self._tree = told
            self._tell(write_message("tree", t_s=round(t_s, 3), **told))

    def _tell(self, message: bytes) -> None:
        for one in self.connections:
            one.send(message)
