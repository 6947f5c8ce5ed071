"""A leaf that asks the planner or the checker, and waits for the answer without blocking."""

from __future__ import annotations

from typing import Any

from py_trees.common import Status

from kinematics.requests.any_request import PlanRequest
from trees.failures import Failure
from trees.nodes.leaf import DONE, RUNNING, Leaf
from trees.toolbox import Job


class JobLeaf(Leaf):
    """A leaf that asks a planner or the checker for one answer.

    It submits the request, asks at each tick whether the answer is there, and cancels the job when it is
    halted before.
    """

    _job: Job | None = None
    _refused: Failure | None = None

    def request(self) -> PlanRequest | Failure:
        """What to ask, or why there is nothing to ask."""
        raise NotImplementedError

    def accept(self, answer: Any) -> Failure | None:
        """Write the answer to the output ports, or say why it is no good."""
        raise NotImplementedError

    def begin(self) -> None:
        """Submit the request."""
        self._job = self._refused = None
        request = self.request()
        if isinstance(request, Failure):
            self._refused = request
        else:
            self._job = self.toolbox.planning.submit(request)

    def step(self) -> Status | Failure:
        """Poll the job."""
        if self._refused is not None:
            return self._refused
        if self._job is None:
            raise RuntimeError(f"{self.name} was ticked before it began")
        if not self._job.done:
            return RUNNING
        return self.accept(self._job.result()) or DONE

    def release(self, reason: str) -> None:
        """Forget the job."""
        self.feedback_message = reason
        if self._job is not None:
            self._job.cancel()
