"""A process beside a served robot: what it needs is there, it is watched, and it ends with the robot."""

from __future__ import annotations

import os
import subprocess
import threading
from collections.abc import Callable, Sequence
from importlib.util import find_spec
from pathlib import Path
from types import TracebackType

from executive.errors import UserError
from executive.live.caller.caller import Caller
from robots.clock import WallClock
from robots.live.wire.errors import LiveError
from robots.live.wire.runtime_folder import RuntimeFolder

PRODUCT = "humanoid-executive"
_LOOK_EVERY_S = 0.5
_MOST = 3
_WITHIN_S = 60.0
_ENDS_WITHIN_S = 5.0


class Companion:
    """One process beside the robot; as a context it ends with it.

    Args:
        name: What it is called to people: "the ROS bridge".
        command: How it is started.
        say: Takes a line for people when it ends and is started again, or is not.
    """

    def __init__(self, name: str, command: Sequence[str], say: Callable[[str], None]) -> None:
        self._name, self._command, self._say = name, list(command), say
        self._wall, self._ending = WallClock(), threading.Event()
        self._process = self._start()
        self._watcher = threading.Thread(target=self._watch, name=name, daemon=True)
        self._watcher.start()

    def __enter__(self) -> Companion:
        """It runs."""
        return self

    def __exit__(
        self, kind: type[BaseException] | None, raised: BaseException | None, trace: TracebackType | None
    ) -> None:
        """End it; one that does not is killed."""
        self._ending.set()
        self._watcher.join()
        if self._process.poll() is None:
            self._process.terminate()
            try:
                self._process.wait(_ENDS_WITHIN_S)
            except subprocess.TimeoutExpired:
                self._process.kill()
                self._process.wait()

    def _start(self) -> subprocess.Popen[bytes]:
        return subprocess.Popen(self._command, stdin=subprocess.DEVNULL, start_new_session=True)

    def _watch(self) -> None:
        begun_s: list[float] = []
        while not self._ending.wait(_LOOK_EVERY_S):
            if self._process.poll() is None:
                continue
            now_s = self._wall.now_s()
            begun_s = [at_s for at_s in begun_s if now_s - at_s < _WITHIN_S]
            ended = f"{self._name} ended ({self._process.returncode})"
            if len(begun_s) >= _MOST:
                self._say(f"{ended}, as did {_MOST} before it: no other one is started; the robot goes on")
                return
            self._say(f"{ended}; a new one takes its place")
            begun_s.append(now_s)
            self._process = self._start()


class LeftBehind:
    """Tells such a process whether it is to end: a signal came, or nobody is left whom it stands beside.

    What serves a robot ends its companions, unless it is killed itself. The robot's control outlives that,
    and is watched on until it ends too.

    Args:
        folder: Where the robot is served.
        signals: Those that have come.
        parent: Tells the process id of this process's parent now, which changes when that ends.
        wall: Of looks for the robot.
    """

    def __init__(
        self,
        folder: Path,
        signals: Sequence[int],
        parent: Callable[[], int] = os.getppid,
        wall: WallClock | None = None,
    ) -> None:
        self._control, self._signals = RuntimeFolder(folder).control_socket, signals
        self._parent, self._begun_by = parent, parent()
        self._wall, self._looked_s, self._is_alone = wall or WallClock(), float("-inf"), False

    def __call__(self) -> bool:
        """Whether it is to end."""
        if self._signals:
            return True
        if self._parent() != self._begun_by and self._wall.now_s() - self._looked_s > _LOOK_EVERY_S:
            self._looked_s = self._wall.now_s()
            try:
                Caller(self._control).close()
            except LiveError:
                self._is_alone = True
        return self._is_alone


OF_THE_VIEW = ("viser", "trimesh", "fast_simplification")
"""Modules that the extra ``view`` brings."""


class MissingExtraError(UserError):
    """A feature needs packages that are not installed."""


def require_extra(extra: str, *modules: str) -> None:
    """Make sure that the packages of an extra are there.

    Args:
        extra: Its name, as in ``pip install "humanoid-executive[mcp]"``.
        modules: Names of modules that it brings.

    Raises:
        MissingExtraError: One is missing.
    """
    for module in modules:
        if find_spec(module) is None:
            raise MissingExtraError(
                f'the package {module!r} is not installed: pip install "{PRODUCT}[{extra}]"'
            )
