"""Whether the process that started a control process, and restarts executives, is still there."""

from __future__ import annotations

import os
from collections.abc import Callable


class Supervision:
    """Looks after the supervisor: a process whose child this one is, until it ends.

    Args:
        supervisor: Its process id; None when nobody supervises from the beginning.
        parent: Tells the process id of this process's parent now, which changes when that ends.
    """

    def __init__(self, supervisor: int | None, parent: Callable[[], int] = os.getppid) -> None:
        self._supervisor, self._parent = supervisor, parent
        self._told = False

    @property
    def supervisor(self) -> int | None:
        """The supervisor's process id while it is there, else None."""
        return self._supervisor if self._supervisor == self._parent() else None

    def news(self) -> str | None:
        """For people, once: that the supervisor has gone."""
        if self._told or self._supervisor is None or self.supervisor is not None:
            return None
        self._told = True
        return (
            f"its supervisor, process {self._supervisor}, has gone: an executive that ends or hangs is not "
            "replaced any more; `executive shutdown` ends the robot's control"
        )
