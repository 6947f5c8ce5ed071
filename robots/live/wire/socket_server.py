"""Listens at a socket, keeps a bounded number of connections, and hands on what they say."""

from __future__ import annotations

import os
import select
from collections.abc import Callable
from pathlib import Path
from typing import Any

from robots.live.wire.connection import Connection
from robots.live.wire.errors import ProtocolError
from robots.live.wire.framing import Frame
from robots.live.wire.messages import write_message
from robots.live.wire.unix_socket import listen_at, peer_of

MAX_CONNECTIONS = 16
KEPT = 2
_ACCEPTED_A_POLL = 8
_FRAMES_A_POLL = 16
"""Of one connection: one that talks much must not keep the others, or the robot, waiting."""


class SocketServer:
    """A listening socket and its connections; nothing here waits.

    Args:
        path: Where to listen.
        on_frame: Takes each frame; a ``ProtocolError`` that it raises ends the connection.
        on_end: Told of each connection that has ended, once.
        rank: Of a connection; when there are too many, one of the lowest rank is ended to make room for a
            new one, because a stop from a new one must get through; those of rank ``KEPT`` never are.
    """

    def __init__(
        self,
        path: Path,
        on_frame: Callable[[Connection, Frame], None],
        on_end: Callable[[Connection], None] = lambda _connection: None,
        rank: Callable[[Connection], int] = lambda _connection: 0,
    ) -> None:
        self._path, self._rank = path, rank
        self._on_frame, self._on_end = on_frame, on_end
        self._listening = listen_at(path)
        self._inode = path.lstat().st_ino
        self.connections: list[Connection] = []

    def poll(self) -> None:
        """Accept, read, hand on, and send what waits."""
        self._forget_closed()
        waiting: list[Any] = [self._listening, *self.connections]
        readable, _, _ = select.select(waiting, [], [], 0.0)
        for connection in list(self.connections):
            if connection in readable or connection.more:
                self._read(connection)
        if self._listening in readable:
            for _ in range(_ACCEPTED_A_POLL):
                if not self._accept():
                    break
        for connection in self.connections:
            connection.flush()
        self._forget_closed()

    def broadcast(self, message: bytes) -> None:
        """Send to everyone who is connected."""
        for connection in self.connections:
            connection.send(message)

    def close(self) -> None:
        """End all connections and stop listening."""
        for connection in self.connections:
            connection.flush()
            connection.close("")
        self._listening.close()
        try:
            if self._path.lstat().st_ino == self._inode:  # another one may listen there by now
                self._path.unlink()
        except FileNotFoundError:
            pass

    def _accept(self) -> bool:
        """Take one more connection; tells whether there was one."""
        try:
            accepted, _ = self._listening.accept()
        except OSError:
            return False
        if peer_of(accepted).uid not in (os.geteuid(), 0):
            accepted.close()
            return True
        if len(self.connections) >= MAX_CONNECTIONS:
            least = min(self.connections, key=self._rank)  # of equals the oldest
            if self._rank(least) >= KEPT:
                accepted.close()
                return True
            least.close("too many connections")
            self._forget_closed()
        self.connections.append(Connection(accepted))
        return True

    def _forget_closed(self) -> None:
        for connection in [item for item in self.connections if item.closed]:
            self.connections.remove(connection)
            self._on_end(connection)

    def _read(self, connection: Connection) -> None:
        try:
            for frame in connection.receive(_FRAMES_A_POLL):
                self._on_frame(connection, frame)
                if connection.closed:
                    return
        except ProtocolError as wrong:
            connection.send(write_message("error", reason=str(wrong)))
            connection.close(str(wrong))
