"""A served robot's sockets, spoken to from where nothing of the product is installed."""

from __future__ import annotations

import json
import socket
import struct
from pathlib import Path
from typing import Any

CONTROL, EXECUTIVE = "control.sock", "executive.sock"
HEAD = struct.Struct(">2sBBI")
MAGIC, VERSION, MESSAGE = b"HX", 1, 0
ANSWER_WITHIN_S = 5.0
LONGEST_MESSAGE = 65_536


class Link:
    """A connection to one of the robot's sockets: JSON messages in frames of eight bytes and a payload."""

    def __init__(self, path: Path) -> None:
        """Connect; OSError when nobody listens."""
        self._socket = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
        try:
            self._socket.connect(str(path))
        except OSError:
            self._socket.close()
            raise
        self._buffer = b""

    def send(self, kind: str, **values: Any) -> None:
        """Send a message."""
        payload = json.dumps({"type": kind, **values}).encode()
        self._socket.sendall(HEAD.pack(MAGIC, VERSION, MESSAGE, len(payload)) + payload)

    def receive(self, within_s: float) -> dict[str, Any] | None:
        """The next message, or None when none came in time; ConnectionError when the other side has gone."""
        self._socket.settimeout(within_s)
        while True:
            if len(self._buffer) >= HEAD.size:
                _, _, _, length = HEAD.unpack_from(self._buffer)
                if length > LONGEST_MESSAGE:
                    raise ConnectionError("a frame is too long")
                if len(self._buffer) >= HEAD.size + length:
                    payload = self._buffer[HEAD.size : HEAD.size + length]
                    self._buffer = self._buffer[HEAD.size + length :]
                    message: dict[str, Any] = json.loads(payload)
                    return message
            try:
                arrived = self._socket.recv(65_536)
            except TimeoutError:
                return None
            if not arrived:
                raise ConnectionError("the robot's side has ended the connection")
            self._buffer += arrived

    def close(self) -> None:
        """Hang up; a task that was begun here is cancelled by that."""
        self._socket.close()


def ask(path: Path, kind: str, **values: Any) -> dict[str, Any]:
    """Ask one question at a socket; OSError when nobody listens or answers, or the answer is a refusal."""
    link = Link(path)
    try:
        link.send(kind, **values)
        answer = link.receive(ANSWER_WITHIN_S)
    finally:
        link.close()
    if answer is None:
        raise ConnectionError("the robot does not answer")
    if answer["type"] in ("error", "refused"):
        raise ConnectionError(str(answer.get("reason", "the robot refuses")))
    return answer
