"""How long a task's planning took, request by request."""

from __future__ import annotations

from executive.session.events import PlanningAnswered
from executive.session.planning_jobs import PlanningJobs


class PlanningWatch:
    """Put its ``take`` into the session's sink; what is counted is processor time.

    Attributes:
        requests_ms: Of each request since the last ``begin``.
    """

    def __init__(self, planning: PlanningJobs) -> None:
        self._planning = planning
        self._before_s = planning.cpu_s
        self.requests_ms: list[float] = []

    def begin(self) -> None:
        """Count from now on."""
        self.requests_ms.clear()

    def take(self, event: object) -> None:
        """Take one event of any kind: a request is answered before its event is sent."""
        if isinstance(event, PlanningAnswered):
            now_s = self._planning.cpu_s
            self.requests_ms.append(1e3 * (now_s - self._before_s))
            self._before_s = now_s
