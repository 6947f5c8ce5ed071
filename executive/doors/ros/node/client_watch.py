"""Whether the client of an action's goal still lives, judged by who listens to the action's feedback.

A goal's request does not say in rclpy who sent it. Whoever listens to the feedback when a goal is accepted
may be its client; who comes later is not. What is known of them: the graph, from which a dead one goes when
its participant's lease has run out (Fast DDS: 20 s), and whether *all* listeners have acknowledged what was
last sent to them, which a dead one does no more. Only while there is a single listener does a missing
acknowledgement tell which one is dead. A client that wants to be judged by itself alone says so by telling
its goal's id now and then.
"""

from __future__ import annotations

from collections.abc import Callable, Set

LEASE_S = 5.0
"""Fast DDS asks for acknowledgements every 3 s, so that a client that lives is always heard within this."""
GRACE_S = 5.0
"""A goal's client may take so long to be found in the graph."""
_ASKS_EVERY_S = 0.5


class ClientWatch:
    """Watches over the client of one goal.

    Args:
        listeners: Who listens to the feedback now: the id of each one's endpoint.
        ask: Sends something that all of them have to acknowledge.
        acknowledged: Whether all of them have acknowledged everything; answers at once.
        silent: Listeners that are known to be dead and still in the graph; shared by all goals of an action.
        now_s: When the goal was accepted, in seconds of any steady clock.
    """

    def __init__(
        self,
        listeners: Callable[[], Set[bytes]],
        ask: Callable[[], None],
        acknowledged: Callable[[], bool],
        silent: set[bytes],
        now_s: float,
    ) -> None:
        self._listeners, self._ask, self._acknowledged = listeners, ask, acknowledged
        self._silent = silent
        self._began_s, self._asked_s = now_s, now_s
        self._forgive()
        self._perhaps = set(listeners()) - silent
        self._told_s: float | None = None
        self._alone: Set[bytes] = frozenset()
        self._asked = False

    def told(self, now_s: float) -> None:
        """The client has told the id of its goal: it lives, and is judged by this from now on."""
        self._told_s = now_s

    def is_gone(self, now_s: float) -> bool:
        """Whether the client has died or left; asked a few times a second."""
        if self._told_s is not None:
            return now_s - self._told_s > LEASE_S
        there = self._listeners()
        self._silent &= there
        self._forgive()
        if not self._perhaps and now_s - self._began_s <= GRACE_S:
            self._perhaps = set(there) - self._silent
        self._perhaps &= there
        if self._is_silent(there, now_s):
            self._silent |= there
            self._perhaps -= there
        return not self._perhaps and now_s - self._began_s > GRACE_S

    def _forgive(self) -> None:
        """Once all have acknowledged everything, nobody in the graph is dead: one was only held up."""
        if self._silent and self._acknowledged():
            self._silent.clear()

    def _is_silent(self, there: Set[bytes], now_s: float) -> bool:
        """Whether the only listener has acknowledged nothing for as long as the lease is."""
        alone = there if len(there) == 1 and there == self._perhaps else frozenset()
        if alone != self._alone:
            self._alone, self._asked = alone, False
        if not alone:
            return False
        if not self._asked or (self._acknowledged() and now_s - self._asked_s >= _ASKS_EVERY_S):
            self._ask()
            self._asked, self._asked_s = True, now_s
            return False
        return now_s - self._asked_s > LEASE_S and not self._acknowledged()
