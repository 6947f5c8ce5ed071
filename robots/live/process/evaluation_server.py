"""A channel of its own for evaluations: the simulator's truth, and the pace of its time.

It is there only when the control process was started with ``--evaluation``; nothing of it reaches the robot
or the executive.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from pathlib import Path
from typing import Any

from robots.live.process.pacer import Pacer
from robots.live.wire.connection import Connection
from robots.live.wire.framing import Frame
from robots.live.wire.messages import read_object, strictly, write_message
from robots.live.wire.socket_server import SocketServer


@dataclasses.dataclass(frozen=True, slots=True)
class GetTruth:
    """Asks for the simulator's truth, for an evaluation."""


@dataclasses.dataclass(frozen=True, slots=True)
class SetPace:
    """Let control time pass at another pace; 0 is as fast as it goes."""

    pace: float


_MESSAGES = {"truth": GetTruth, "pace": SetPace}


class EvaluationServer:
    """Answers what evaluations ask the control process: the truth, and another pace."""

    def __init__(self, path: Path, truth: Callable[[], dict[str, Any]], pacer: Pacer) -> None:
        """Listen; ``truth`` gives the answer to each question for it."""
        self._truth, self._pacer = truth, pacer
        self._server = SocketServer(path, self._take)

    def poll(self) -> None:
        """Read and answer."""
        self._server.poll()

    def close(self) -> None:
        """Stop listening."""
        self._server.close()

    def _take(self, connection: Connection, frame: Frame) -> None:
        message = strictly(_MESSAGES, read_object(frame.payload))
        if isinstance(message, SetPace):
            self._pacer.set_pace(max(0.0, message.pace))
            connection.send(write_message("done"))
        else:
            connection.send(write_message("truth", **self._truth()))
