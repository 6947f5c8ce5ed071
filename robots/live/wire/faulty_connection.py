"""A connection that treats what crosses it badly: for tests and evaluations, never in service.

A stream socket loses, doubles and reorders nothing by itself; what stands between two processes some day
may. Each fault strikes frames of both directions.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from typing import Generic, Literal, TypeVar, get_args

import numpy as np

from robots.live.wire.connection import Connection
from robots.live.wire.framing import Frame, FrameKind
from robots.live.wire.unix_socket import UnixSocket

ConnectionFault = Literal["delay", "drop", "duplicate", "reorder", "cut"]
CONNECTION_FAULTS: tuple[ConnectionFault, ...] = get_args(ConnectionFault)

STRUCK = 0.2
"""Share of the frames that are dropped, doubled, or let others pass."""
MOST_DELAY_S = 0.7
"""A command that is older than 0.5 s is refused, and a heartbeat of that age is none."""

T = TypeVar("T")


class FaultyLine(Generic[T]):
    """One direction of a connection that goes wrong on purpose."""

    def __init__(self, fault: ConnectionFault, rng: np.random.Generator, now_s: Callable[[], float]) -> None:
        self._fault, self._rng, self._now_s = fault, rng, now_s
        self._waiting: deque[tuple[float, T]] = deque()
        self._passed: T | None = None

    def put(self, item: T) -> list[T]:
        """Send one in; gives what comes out at once."""
        struck = self._rng.random() < STRUCK
        match self._fault:
            case "delay":
                due_s = self._now_s() + self._rng.uniform(0.0, MOST_DELAY_S)
                before_s = self._waiting[-1][0] if self._waiting else due_s
                self._waiting.append((max(due_s, before_s), item))
                return self.due()
            case "drop":
                return [] if struck else [item]
            case "duplicate":
                return [item, item] if struck else [item]
            case "reorder":
                held, self._passed = self._passed, None
                if held is not None:
                    return [item, held]
                if struck:
                    self._passed = item
                    return []
                return [item]
            case "cut":
                return []

    def due(self) -> list[T]:
        """What comes out now of what was delayed."""
        found: list[T] = []
        while self._waiting and self._waiting[0][0] <= self._now_s():
            found.append(self._waiting.popleft()[1])
        return found


class FaultyConnection(Connection):
    """A connection that works like ``Connection`` until ``strike`` lets its fault begin.

    Args:
        connected: The socket.
        fault: What happens.
        rng: Which frames it happens to.
        now_s: Time, for delays.
    """

    def __init__(
        self,
        connected: UnixSocket,
        fault: ConnectionFault,
        rng: np.random.Generator,
        now_s: Callable[[], float],
    ) -> None:
        super().__init__(connected)
        self._fault: ConnectionFault = fault
        self._struck = False
        self._out: FaultyLine[tuple[bytes, FrameKind]] = FaultyLine(fault, rng, now_s)
        self._in: FaultyLine[Frame] = FaultyLine(fault, rng, now_s)

    def strike(self) -> None:
        """Begin."""
        self._struck = True

    def send(self, payload: bytes, kind: FrameKind = FrameKind.MESSAGE) -> None:
        """Send a frame, or what the fault makes of it."""
        if not self._struck:
            super().send(payload, kind)
            return
        for frame in self._out.put((payload, kind)):
            super().send(*frame)

    def flush(self) -> None:
        """Send what can be sent, and what was delayed until now."""
        super().flush()
        for frame in self._out.due():
            super().send(*frame)

    def receive(self, most: int = 64) -> list[Frame]:
        """Frames that have arrived, or what the fault makes of them."""
        if not self._struck:
            return super().receive(most)
        if self._fault == "cut":
            self.close("cut off")
            return []
        self.flush()
        found = self._in.due()
        for frame in super().receive(most):
            found += self._in.put(frame)
        return found

    def wait(self, seconds: float) -> bool:
        """Wait until something arrives, but not so long that what was delayed would wait with it."""
        return super().wait(min(seconds, 0.01) if self._struck else seconds)
