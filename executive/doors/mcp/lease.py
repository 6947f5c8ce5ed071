"""A task belongs to the client that began it, and ends with it: one that it forgets is cancelled."""

from __future__ import annotations

import threading
from dataclasses import dataclass

from executive.doors.mcp.clients import McpClient
from executive.doors.served_robot import Run, ServedRobot
from robots.clock import WallClock
from robots.live.wire.errors import LiveError

LEASE_S = 60.0
"""Wall time for which a task goes on though its client does not ask about it."""
_LOOK_EVERY_S = 0.5


@dataclass(slots=True)
class _Leased:
    """A task with the client that began it, and when that was heard last."""

    run: Run
    client: McpClient
    heard_s: float


class Lease:
    """Watches the task under way, in a thread of its own.

    While a question is open nothing moves, and the robot itself closes it after a while: that time does not
    count.

    Args:
        robot: The served robot.
        lasts_s: How long a task goes on without being asked about by its client.
    """

    def __init__(self, robot: ServedRobot, lasts_s: float = LEASE_S) -> None:
        self._robot, self._lasts_s, self._wall = robot, lasts_s, WallClock()
        self._lock = threading.Lock()
        self._leased: dict[str, _Leased] = {}
        threading.Thread(target=self._watch, name="lease", daemon=True).start()

    def begin(self, run: Run, client: McpClient) -> None:
        """Watch a task from now on."""
        with self._lock:
            self._leased[run.name] = _Leased(run, client, self._wall.now_s())

    def heard(self, run: Run, client: McpClient) -> None:
        """A client has asked about a task; it counts when that is the one that began it."""
        with self._lock:
            leased = self._leased.get(run.name)
            if leased is not None and leased.client == client:
                leased.heard_s = self._wall.now_s()

    def is_commanded_by(self, run: Run, client: McpClient) -> bool:
        """Whether a client began a task that is under way."""
        with self._lock:
            leased = self._leased.get(run.name)
        return leased is not None and leased.client == client and not run.ended

    def other_commander(self, client: McpClient) -> str:
        """What to tell a client while another one commands; empty while none does."""
        with self._lock:
            others = [one for one in self._leased.values() if not one.run.ended and one.client != client]
        if not others:
            return ""
        run = others[0].run
        return (
            f"{others[0].client.name!r} commands: {run.name} ({run.text!r}) is under way; task_status tells "
            "when it has ended, cancel ends it"
        )

    def _watch(self) -> None:
        while True:
            self._wall.sleep(_LOOK_EVERY_S)
            for leased in self._late(self._wall.now_s()):
                self._cancel(leased)

    def _late(self, now_s: float) -> list[_Leased]:
        with self._lock:
            self._leased = {name: one for name, one in self._leased.items() if not one.run.ended}
            for one in self._leased.values():
                if one.run.status().question is not None:
                    one.heard_s = now_s
            return [one for one in self._leased.values() if now_s - one.heard_s > self._lasts_s]

    def _cancel(self, leased: _Leased) -> None:
        try:
            self._robot.cancel(f"its client has not asked about {leased.run.name} for {self._lasts_s:g} s")
        except LiveError:
            return  # the robot is gone, and the task with it; or it hangs, and is asked again
        leased.heard_s = self._wall.now_s()
