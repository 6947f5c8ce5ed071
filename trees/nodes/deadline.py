"""A time limit on the injected clock."""

from __future__ import annotations

from py_trees.behaviour import Behaviour
from py_trees.common import Status
from py_trees.decorators import Decorator

from robots.clock import Clock
from trees.failures import Failure
from trees.nodes.judgements import failure_of, place_of
from trees.toolbox import Pauses


class Deadline(Decorator):
    """Halts its child and fails with a timeout when the child has not ended in time.

    Time is that of the injected clock; pauses do not count.

    Attributes:
        deadline_s: The limit.
        failure: The timeout, or the child's failure; None otherwise.
        transparent: It structures, and is left out of places in the tree.
    """

    transparent = True

    def __init__(
        self, name: str, child: Behaviour, deadline_s: float, clock: Clock, pauses: Pauses | None = None
    ) -> None:
        super().__init__(name=name, child=child)
        self._pauses = pauses or Pauses()
        self._paused_before_s = 0.0
        self.failure: Failure | None = None
        self.deadline_s = deadline_s
        self._clock = clock
        self._started_s = 0.0

    def initialise(self) -> None:
        """Start the clock."""
        self.failure = None
        self._started_s = self._clock.now_s()
        self._paused_before_s = self._pauses.total_s

    def update(self) -> Status:
        """Pass the child's status on, unless the time is up."""
        paused_s = self._pauses.total_s - self._paused_before_s
        elapsed_s = self._clock.now_s() - self._started_s - paused_s
        if self.decorated.status is Status.RUNNING and elapsed_s > self.deadline_s:
            timeout = Failure.timeout(
                f"{self.decorated.name} took longer than its deadline",
                deadline_s=self.deadline_s,
                elapsed_s=elapsed_s,
            )
            self.failure = timeout.at(place_of(self.decorated))
            self.feedback_message = timeout.message
            return Status.FAILURE
        if self.decorated.status is Status.FAILURE:
            self.failure = failure_of(self.decorated)
        return self.decorated.status
