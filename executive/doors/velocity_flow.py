"""Velocities that come many times a second, passed on to a served robot, with what it says to them."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path

from executive.live.caller.caller import Caller
from executive.live.desk_messages import Velocity, write_desk_message
from robots.live.wire.errors import LiveError
from robots.live.wire.runtime_folder import RuntimeFolder

_AGAIN_AFTER_S = 1.0
"""A velocity that was refused is not passed on again for so long; another one is."""


class VelocityFlow:
    """Passes velocities on while they come; the robot walks at the newest, and stands when they fall silent.

    Args:
        folder: Where the robot is served.
        tell: Takes what the robot says of it, a line at a time.
    """

    def __init__(self, folder: Path, tell: Callable[[str], None]) -> None:
        self._where, self._tell = RuntimeFolder(folder), tell
        self._caller: Caller | None = None
        self._refused: str | None = None
        self._refused_s = -math.inf
        self._last = (0.0, 0.0)

    def hear(self, linear_m_s: float, angular_rad_s: float, now_s: float, wrong: str = "") -> None:
        """Take a velocity.

        Args:
            linear_m_s: Forward speed.
            angular_rad_s: Turning speed, to the left.
            now_s: Wall time.
            wrong: Why it is none for this robot, or nothing.
        """
        wanted = (linear_m_s, angular_rad_s)
        if repr(wanted) == self._refused and now_s - self._refused_s < _AGAIN_AFTER_S:
            return
        if wrong:
            self._refuse(wanted, now_s, wrong)
            return
        if not all(map(math.isfinite, wanted)):
            self._refuse(wanted, now_s, f"this robot cannot go {linear_m_s:g} m/s, {angular_rad_s:g} rad/s")
            return
        self._last = wanted
        try:
            if self._caller is None:
                if wanted == (0.0, 0.0):
                    return  # the robot stands
                self._caller = Caller(self._where.executive_socket)
            self._caller.send(write_desk_message(Velocity(*wanted)))
        except LiveError as gone:
            self._caller = None
            self._refuse(wanted, now_s, str(gone))

    def poll(self, now_s: float) -> None:
        """Pass on what the robot has said; once it has ended, the next velocity begins anew."""
        if self._caller is None:
            return
        try:
            messages = self._caller.poll()
        except LiveError as gone:
            self._caller = None
            self._refuse(self._last, now_s, str(gone))
            return
        for message in messages:
            match message["type"]:
                case "line":
                    self._tell(str(message["text"]))
                case "result" | "error" | "refused":
                    done = message.get("outcome") == "done"
                    self._caller.close()
                    self._caller = None
                    if done:
                        self._tell(str(message["text"]))
                        return
                    self._refuse(self._last, now_s, str(message.get("text") or message.get("reason")))
                    return

    def close(self) -> None:
        """Hang up; a walk that is under way ends."""
        if self._caller is not None:
            self._caller.close()
            self._caller = None

    def _refuse(self, wanted: tuple[float, float], now_s: float, why: str) -> None:
        self._refused, self._refused_s = repr(wanted), now_s
        self._tell(why if why.startswith(("refused", "failed", "cancelled")) else f"refused: {why}")
