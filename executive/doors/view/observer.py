"""Watches a served robot for the page: events, tree, status and what is believed, each as it comes.

It is one more process beside the robot: nothing waits for it, and what it cannot reach it asks for again.
"""

from __future__ import annotations

import threading
from collections import deque
from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

from executive.doors.view.seen import LogLine, Seen, log_line, result_line
from executive.live.caller.caller import Caller, SilentError, ask_at
from executive.live.desk_messages import GetWorld, Listen, Watch, write_desk_message
from robots.clock import WallClock
from robots.live.wire.errors import LiveError
from robots.live.wire.messages import GetStatus, write_control_message
from robots.live.wire.runtime_folder import RuntimeFolder

_KEPT_LINES = 300
_STATUS_EVERY_S, _WORLD_EVERY_S = 0.25, 0.5
_AGAIN_S = 0.5
_WITHIN_S = 1.0
"""An executive that does not answer for so long is said to be silent."""


class Observer:
    """Watches until it is closed.

    Args:
        folder: Where the robot is served.
        about: What the control process has told of itself: robot and scene.
    """

    def __init__(self, folder: Path, about: Mapping[str, Any]) -> None:
        self._where, self._wall = RuntimeFolder(folder), WallClock()
        self._lock = threading.Lock()
        self._seen = Seen(robot=str(about.get("robot", "")), scene=str(about.get("scene", "")))
        self._log: deque[LogLine] = deque(maxlen=_KEPT_LINES)
        self._world: Mapping[str, Any] = {"version": -1, "things": []}
        self._ended = threading.Event()
        self._threads = [
            threading.Thread(target=self._repeat, args=(work, every_s), name=work.__name__, daemon=True)
            for work, every_s in (
                (self._watch, _AGAIN_S),
                (self._ask_control, _STATUS_EVERY_S),
                (self._ask_executive, _STATUS_EVERY_S),
                (self._ask_world, _WORLD_EVERY_S),
            )
        ]
        for thread in self._threads:
            thread.start()

    def seen(self) -> Seen:
        """What there is to tell in words."""
        with self._lock:
            return replace(self._seen, log=tuple(self._log))

    def world(self) -> Mapping[str, Any]:
        """What is believed, as the executive told it last."""
        with self._lock:
            return self._world

    def note(self, line: LogLine) -> None:
        """Put a line of the page's own in the log."""
        with self._lock:
            self._log.append(line)

    def close(self) -> None:
        """Watch no more."""
        self._ended.set()
        for thread in self._threads:
            thread.join()

    def _repeat(self, work: Callable[[], None], every_s: float) -> None:
        while not self._ended.wait(every_s):
            try:
                work()
            except LiveError as gone:
                if work == self._ask_executive:
                    self._change(complaint=f"the executive does not answer: {gone}", question=None)

    def _change(self, **values: Any) -> None:
        with self._lock:
            self._seen = replace(self._seen, **values)

    def _ask_control(self) -> None:
        told = ask_at(self._where.control_socket, write_control_message(GetStatus()))
        emergency = told.get("emergency")
        engaged = emergency if isinstance(emergency, str) else (emergency or {}).get("engaged")
        self._change(emergency=str(engaged or ""))

    def _ask_executive(self) -> None:
        told = ask_at(self._where.executive_socket, write_control_message(GetStatus()), _WITHIN_S)
        self._change(
            t_s=float(told["t_s"]),
            state=str(told["state"]),
            task=told["task"],
            paused=bool(told["paused"]),
            question=told["question"],
            complaint="",
        )

    def _ask_world(self) -> None:
        told = ask_at(self._where.executive_socket, write_desk_message(GetWorld()), _WITHIN_S)
        with self._lock:
            self._world = told

    def _watch(self) -> None:
        """Hear of events and trees until the executive ends or this does."""
        caller = Caller(self._where.executive_socket)
        try:
            caller.send(write_desk_message(Watch()))
            caller.send(write_desk_message(Listen()))
            while not self._ended.is_set():
                try:
                    caller.listen(self._take, _WITHIN_S)
                except SilentError:
                    continue
        finally:
            caller.close()

    def _take(self, message: dict[str, Any]) -> bool:
        if message["type"] == "tree":
            self._change(nodes=message["nodes"], t_s=float(message["t_s"]))
        elif message["type"] == "event":
            self._hear(message["told"], message["line"])
        elif message["type"] == "heard" and (ended := result_line(message["text"], self._seen.t_s)):
            self.note(ended)
        return self._ended.is_set()

    def _hear(self, told: Mapping[str, Any], line: str | None) -> None:
        kept = log_line(told, line)
        if kept is not None:
            self.note(kept)
        kind = told.get("event")
        if kind == "TaskAccepted":
            self._change(failure=None, evidence=None)
        elif kind == "LeafFailed":
            self._change(failure=told.get("failure"))
        elif kind == "TaskEnded":
            self._change(failure=told.get("failure"), evidence=told.get("evidence"))
