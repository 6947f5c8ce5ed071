"""Whether the client of an action's goal still lives, judged by who listens to the action's feedback.

A goal's request does not say in rclpy who sent it. Whoever listens to the feedback when a goal is accepted
may be its client; who comes later is not. Where the service's introspection tells the sender, that one is.
What is known of them: the graph, from which a dead one goes when its participant's lease has run out (Fast
DDS: 20 s), and whether *all* listeners have acknowledged what was last sent to them, which a dead one does no
more. A missing acknowledgement tells which one is dead while there is a single listener, and where a
listener's process is known to have ended. A client that wants to be judged by itself alone says so by telling
its goal's id now and then.
"""

from __future__ import annotations

from collections.abc import Callable, Set

LEASE_S = 4.0
"""A client that lives is heard many times within this, where it is asked for acknowledgements often."""
RARELY_ASKED_LEASE_S = 5.0
"""By default Fast DDS asks every 3 s, so that a client that lives is always heard within this."""
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
        has_ended: Whether the process of a listener is known to have ended.
        lease_s: For how long an acknowledgement may be missing.
    """

    def __init__(
        self,
        listeners: Callable[[], Set[bytes]],
        ask: Callable[[], None],
        acknowledged: Callable[[], bool],
        silent: set[bytes],
        now_s: float,
        has_ended: Callable[[bytes], bool],
        lease_s: float = LEASE_S,
    ) -> None:
        self._has_ended, self._lease_s = has_ended, lease_s
        self._listeners, self._ask, self._acknowledged = listeners, ask, acknowledged
        self._silent = silent
        self._began_s, self._asked_s = now_s, now_s
        self._forgive()
        self._perhaps = set(listeners()) - silent
        self._told_s: float | None = None
        self._sender: bytes | None = None
        self._seen: Set[bytes] = frozenset()
        self._asked = False

    def sent_by(self, participant: bytes) -> None:
        """The goal was sent by this participant: the first bytes of its listener's id."""
        self._sender = participant

    def told(self, now_s: float) -> None:
        """The client has told the id of its goal: it lives, and is judged by this from now on."""
        self._told_s = now_s

    def is_gone(self, now_s: float) -> bool:
        """Whether the client has died or left; asked a few times a second."""
        if self._told_s is not None:
            return now_s - self._told_s > self._lease_s
        there = self._listeners()
        self._silent &= there
        self._forgive()
        if now_s - self._began_s <= GRACE_S and not any(map(self._may_be, self._perhaps)):
            self._perhaps = set(there) - self._silent
        self._perhaps = {one for one in self._perhaps & there if self._may_be(one)}
        dead = self._dead(there, now_s)
        self._silent |= dead
        self._perhaps -= dead
        return not self._perhaps and now_s - self._began_s > GRACE_S

    def _may_be(self, listener: bytes) -> bool:
        return self._sender is None or listener.startswith(self._sender)

    def _forgive(self) -> None:
        """Once all have acknowledged everything, nobody in the graph is dead: one was only held up."""
        if self._silent and self._acknowledged():
            self._silent.clear()

    def _dead(self, there: Set[bytes], now_s: float) -> Set[bytes]:
        """Which of those that may be the client are known to be dead.

        Of a single listener it is enough that it acknowledges nothing for as long as the lease is.
        """
        if there != self._seen:
            self._seen, self._asked = there, False
        if not self._perhaps:
            return frozenset()
        if not self._asked or (self._acknowledged() and now_s - self._asked_s >= _ASKS_EVERY_S):
            self._ask()
            self._asked, self._asked_s = True, now_s
            return frozenset()
        if now_s - self._asked_s <= self._lease_s or self._acknowledged():
            return frozenset()
        if len(there) == 1 and there == self._perhaps:
            return there
        return {one for one in self._perhaps if self._has_ended(one)}
