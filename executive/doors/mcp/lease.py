"""Tasks end with their client: one that nobody asks about for a while is cancelled, and the robot holds."""

from __future__ import annotations

import threading

from executive.doors.served_robot import Run, ServedRobot
from robots.clock import WallClock
from robots.live.wire.errors import LiveError

LEASE_S = 60.0
"""Wall time for which a task goes on though no client asks about it."""
_LOOK_EVERY_S = 0.5


class Lease:
    """Watches the task under way, in a thread of its own.

    Args:
        robot: The served robot.
        lasts_s: How long a task goes on without being asked about.
    """

    def __init__(self, robot: ServedRobot, lasts_s: float = LEASE_S) -> None:
        self._robot, self._lasts_s, self._wall = robot, lasts_s, WallClock()
        self._lock = threading.Lock()
        self._heard_s: dict[str, float] = {}
        self._runs: dict[str, Run] = {}
        threading.Thread(target=self._watch, name="lease", daemon=True).start()

    def begin(self, run: Run) -> None:
        """Watch a task from now on."""
        with self._lock:
            self._runs[run.name] = run
            self._heard_s[run.name] = self._wall.now_s()

    def heard(self, run: Run) -> None:
        """A client has asked about it."""
        with self._lock:
            if run.name in self._runs:
                self._heard_s[run.name] = self._wall.now_s()

    def _watch(self) -> None:
        while True:
            self._wall.sleep(_LOOK_EVERY_S)
            now_s = self._wall.now_s()
            with self._lock:
                for name in [name for name, run in self._runs.items() if run.ended]:
                    del self._runs[name], self._heard_s[name]
                late = [name for name, at_s in self._heard_s.items() if now_s - at_s > self._lasts_s]
            for name in late:
                self._cancel(name)

    def _cancel(self, name: str) -> None:
        try:
            self._robot.cancel(f"no client has asked about {name} for {self._lasts_s:g} s")
        except LiveError:
            return  # the robot is gone, and the task with it
        with self._lock:
            self._heard_s[name] = self._wall.now_s()
