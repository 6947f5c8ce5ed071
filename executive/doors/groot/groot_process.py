"""The process that Groot2 connects to: started by ``--groot`` beside a served robot, ended with it."""

from __future__ import annotations

import sys
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import zmq

from executive.doors.companion import LeftBehind
from executive.doors.groot.monitored_tree import MonitoredTree
from executive.doors.groot.requests import answer
from executive.ending_signals import taken_by
from executive.errors import UserError
from executive.live.caller.caller import Caller
from executive.live.desk_messages import GetTree, Watch, write_desk_message
from kinematics.whole_file import read_whole
from robots.clock import WallClock, utc_ns
from robots.live.wire.errors import LiveError
from robots.live.wire.runtime_folder import RuntimeFolder

HERE = "127.0.0.1"
_POLL_MS, _AGAIN_S = 10, 0.5


class GrootPortTakenError(UserError):
    """Another program listens where Groot2 would connect to."""

    def __init__(self, port: int) -> None:
        super().__init__(
            f"port {port} or {port + 1} of {HERE} is taken; choose another one with --groot-port"
        )


class Monitor:
    """Answers Groot2 with the tree of a served robot.

    Args:
        folder: Where it is served.
        port: Of 127.0.0.1; the one after it is taken as well, as Groot2 wants it.

    Raises:
        GrootPortTakenError: Another program listens at one of them.
    """

    def __init__(self, folder: Path, port: int) -> None:
        self._where, self._wall = RuntimeFolder(folder), WallClock()
        self._context = zmq.Context()
        self._answers, self._news = self._context.socket(zmq.REP), self._context.socket(zmq.PUB)
        try:
            self._answers.bind(f"tcp://{HERE}:{port}")
            self._news.bind(f"tcp://{HERE}:{port + 1}")
        except zmq.ZMQError:
            self._context.destroy(linger=0)
            raise GrootPortTakenError(port) from None
        self._tree, self._number, self._wanted = MonitoredTree(), -1, -1
        self._statuses = ""
        self._caller: Caller | None = None
        self._tried_s = float("-inf")

    def run(self, ended: Callable[[], bool]) -> None:
        """Answer until something says that it ends."""
        while not ended():
            if self._answers.poll(_POLL_MS):
                self._answers.send_multipart(
                    answer(self._answers.recv_multipart(), self._tree, utc_ns() // 1000)
                )
            self._listen()

    def close(self) -> None:
        """Answer no more."""
        if self._caller is not None:
            self._caller.close()
        for socket in (self._answers, self._news):
            socket.close(0)
        self._context.term()

    def _listen(self) -> None:
        """Hear what the executive tells; one that is not there is tried again now and then."""
        try:
            if self._caller is None:
                if self._wall.now_s() - self._tried_s < _AGAIN_S:
                    return
                self._tried_s = self._wall.now_s()
                caller = Caller(self._where.executive_socket)
                caller.send(write_desk_message(Watch()))
                self._caller = caller
                self._wanted = -1
            for message in self._caller.poll():
                self._take(self._caller, message)
        except LiveError:
            if self._caller is not None:
                self._caller.close()
            self._caller = None

    def _take(self, caller: Caller, message: Mapping[str, Any]) -> None:
        if message["type"] == "tree":
            self._statuses = str(message["statuses"])
            if message["number"] != self._wanted:
                self._wanted = int(message["number"])
                caller.send(write_desk_message(GetTree()))
            if self._wanted == self._number:
                self._tree.take(self._statuses, utc_ns() // 1000)
            self._tree.note(message["nodes"])
        elif message["type"] == "tree_document" and message["path"]:
            document = read_whole(Path(str(message["path"])))
            if document is not None:
                self._number = int(message["number"])
                self._tree = MonitoredTree(document.decode(), self._number)
                self._tree.take(self._statuses, utc_ns() // 1000)


def main(folder: str, port: str) -> int:
    """Show Groot2 the tree of the robot that is served in a folder until a signal ends it."""
    signals: list[int] = []
    try:
        with taken_by(signals.append):
            monitor = Monitor(Path(folder), int(port))
            sys.stderr.write(f"Groot2 monitors the tree at {HERE}, port {port}\n")
            sys.stderr.flush()
            monitor.run(LeftBehind(Path(folder), signals))
            monitor.close()
    except (LiveError, UserError) as wrong:
        sys.stderr.write(f"executive: the tree is not shown to Groot2: {wrong}\n")
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
