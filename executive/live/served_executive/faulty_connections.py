"""Connections of an executive that an evaluation lets go wrong at an instant of its own."""

from __future__ import annotations

import signal
from types import FrameType

import numpy as np

from robots.clock import WallClock
from robots.live.wire.faulty_connection import CONNECTION_FAULTS, ConnectionFault, FaultyConnection
from robots.live.wire.unix_socket import UnixSocket


class StruckConnections:
    """Makes connections that a fault strikes at SIGUSR1, and at once from then on."""

    def __init__(self, fault: str, seed: int) -> None:
        """Wait for the signal.

        Raises:
            KeyError: There is no such fault.
        """
        known: dict[str, ConnectionFault] = {name: name for name in CONNECTION_FAULTS}
        self._fault = known[fault]
        self._rng, self._wall = np.random.default_rng(seed), WallClock()
        self._struck = False
        self._made: list[FaultyConnection] = []
        signal.signal(signal.SIGUSR1, self._strike)

    def __call__(self, connected: UnixSocket) -> FaultyConnection:
        """One more connection; after a cut, the next one is whole."""
        made = FaultyConnection(connected, self._fault, self._rng, self._wall.now_s)
        self._made = [made]
        if self._struck and self._fault != "cut":
            made.strike()
        return made

    def _strike(self, _number: int, _frame: FrameType | None) -> None:
        self._struck = True
        for made in self._made:
            made.strike()
