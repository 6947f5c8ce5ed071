"""Hear out an executive that may hang: nobody waits for one that does not command the robot any more."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from executive.live.caller.caller import Caller, SilentError
from robots.live.wire.errors import LiveError
from robots.live.wire.messages import GetStatus, write_control_message
from robots.live.wire.runtime_folder import RuntimeFolder

_LOOK_EVERY_S = 2.0
_IN_VAIN = 2
"""Looks in a row that find somebody else, or nobody, in command: one let go for a moment attaches again."""


class HungError(LiveError):
    """The executive hangs: it is there, but has not commanded the robot for too long."""

    def __init__(self) -> None:
        super().__init__(
            "the executive hangs and commands the robot no more, which brakes and holds; "
            "`executive serve`, if `executive status` tells that it supervises, puts another one in its place"
        )


def hear_out(
    caller: Caller,
    take: Callable[[dict[str, Any]], bool],
    commander: Callable[[], int | None],
    look_every_s: float = _LOOK_EVERY_S,
) -> None:
    """Take an executive's answers until one ends it, however long that takes.

    Args:
        caller: The connection to it.
        take: Called with each answer; true when it was the last one.
        commander: Process that commands the robot now.
        look_every_s: Silence after which that is asked.

    Raises:
        HungError: It is silent, and commands the robot no more.
        NoAnswerError: It has ended the connection.
    """
    in_vain = 0
    while True:
        try:
            caller.listen(take, look_every_s)
            return
        except SilentError:
            in_vain = 0 if commander() == caller.peer_pid else in_vain + 1
            if in_vain >= _IN_VAIN:
                raise HungError from None


def commander_of(where: RuntimeFolder) -> int | None:
    """The process that commands a served robot; None when none does, or nobody answers."""
    try:
        caller = Caller(where.control_socket)
        try:
            pid = caller.ask(write_control_message(GetStatus())).get("commander")
        finally:
            caller.close()
    except LiveError:
        return None
    return pid if isinstance(pid, int) else None


class HangWatch:
    """Notices an executive that hangs: the control process let it go, and it does not come back."""

    def __init__(self, after_s: float) -> None:
        """Watch.

        Args:
            after_s: Without the command for so long it counts as hung; one that wakes up takes it again.
        """
        self._after_s = after_s
        self._commanded_s: float | None = None

    def is_hung(self, commander: int | None, executive: int, now_s: float) -> bool:
        """Look once: who commands, which process it should be, and the time. One that loads is not hung."""
        if commander == executive:
            self._commanded_s = now_s
        return self._commanded_s is not None and now_s - self._commanded_s > self._after_s

    def forget(self) -> None:
        """Another executive takes its place."""
        self._commanded_s = None
