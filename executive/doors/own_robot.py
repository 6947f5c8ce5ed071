"""A robot of a command's own: served for as long as the command lasts, in a folder that nobody else knows."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import tempfile
import threading
from collections.abc import Callable, Sequence
from pathlib import Path
from types import TracebackType

from executive.doors.served_robot import ServedRobot
from executive.errors import UserError
from robots.clock import WallClock
from robots.live.wire.errors import LiveError

_READY_WITHIN_S = 180.0
_LOOK_EVERY_S = 0.1
_ENDS_WITHIN_S = 30.0


class OwnRobotError(UserError):
    """The robot cannot be served; the message is what ``executive serve`` says of it."""


class OwnRobot:
    """``executive serve`` in a process of its own; as a context it ends with the command, at rest.

    Args:
        options: Of ``executive serve``: robot, scene, seed and the like.
        say: Takes what it tells.
    """

    def __init__(self, options: Sequence[str], say: Callable[[str], None]) -> None:
        self._place = tempfile.TemporaryDirectory(prefix="executive-own-", ignore_cleanup_errors=True)
        self.folder = Path(self._place.name) / "live"
        self._say, self._wall = say, WallClock()
        self._told: list[str] = []
        command = [sys.executable, "-m", "executive", "serve", "--folder", os.fspath(self.folder), *options]
        self._process = subprocess.Popen(
            command,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            encoding="utf-8",
            errors="replace",
            start_new_session=True,  # a Ctrl-C here is for whoever started it
        )
        threading.Thread(target=self._listen, name="own robot", daemon=True).start()

    def __enter__(self) -> OwnRobot:
        """It is served, or will be soon."""
        return self

    def __exit__(
        self, kind: type[BaseException] | None, raised: BaseException | None, trace: TracebackType | None
    ) -> None:
        """Let the robot brake, hold and end."""
        if self._process.poll() is None:
            self._process.send_signal(signal.SIGINT)
            try:
                self._process.wait(_ENDS_WITHIN_S)
            except subprocess.TimeoutExpired:
                self._process.terminate()
                self._process.wait()
        self._place.cleanup()

    def wait(self, given_up: Callable[[], bool], listeners: int = 0) -> ServedRobot:
        """Wait until it takes tasks.

        Args:
            given_up: Whether nobody waits any more.
            listeners: So many have to listen to what it tells by then.

        Raises:
            OwnRobotError: It ended before, or does not begin.
        """
        robot = ServedRobot(self.folder)
        until_s = self._wall.now_s() + _READY_WITHIN_S
        while self._wall.now_s() < until_s and not given_up():
            if self._process.poll() is not None:
                raise OwnRobotError(self._told[-1] if self._told else "`executive serve` ended at once")
            try:
                if robot.status()["listeners"] >= listeners:
                    return robot
            except LiveError:
                pass
            self._wall.sleep(_LOOK_EVERY_S)
        raise OwnRobotError(
            "nobody waits for the robot any more"
            if given_up()
            else f"the robot takes no tasks after {_READY_WITHIN_S:.0f} s"
        )

    def _listen(self) -> None:
        for line in self._process.stdout or ():
            told = line.strip().removeprefix("executive: ")
            self._told.append(told)
            self._say(told)
