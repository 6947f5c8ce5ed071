"""Planning in live mode: in a worker process, and what is checked is checked by both sides."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import Future
from typing import Any, Protocol

from executive.live.control_client.control_link import ControlLink
from executive.live.control_client.motion_client import MotionClient
from executive.live.control_client.planning_service import Planned
from executive.session.events import PlanningAnswered
from kinematics.motion.verdict import CheckedTrajectory
from kinematics.requests.any_request import PlanRequest
from robots.live.wire.errors import LiveError
from trees.toolbox import Job
from trees.world_model import WorldModel


class Worker(Protocol):
    """What answers planning requests: the planning process, or a double in tests."""

    def ask(self, question: object) -> Future[Any]:
        """Answer one request."""
        ...


class NotAdmittedError(LiveError):
    """The control process would not judge a trajectory."""


class LivePlanning:
    """Plans for a served robot in a process of its own; satisfies ``trees.toolbox.Planning``.

    Attributes:
        wall_s: Wall time that answers took so far, for reports only.
        checked: Trajectories that both checkers let pass so far.
    """

    def __init__(
        self,
        worker: Worker,
        link: ControlLink,
        motion: MotionClient,
        world: WorldModel,
        sink: Callable[[PlanningAnswered], None],
    ) -> None:
        self._worker, self.link, self.motion, self._world = worker, link, motion, world
        self._sink = sink
        self._count = 0
        self.wall_s = 0.0
        self.checked = 0

    def submit(self, request: PlanRequest) -> Job:
        """Begin to answer a request."""
        self._count += 1
        asked_s, version = self.link.now_s, self._world.scene.version
        kind = type(request).__name__
        return LiveJob(self, self._worker.ask(request), self._count, version, asked_s, kind)

    def answered(self, asked_s: float, kind: str, planned: Planned) -> None:
        """Note an answer of the worker."""
        self.wall_s += planned.wall_s
        self._sink(PlanningAnswered(asked_s, self.link.now_s, kind, type(planned.answer).__name__))


class LiveJob:
    """A request under way; satisfies ``trees.toolbox.Job``."""

    def __init__(
        self,
        planning: LivePlanning,
        future: Future[Any],
        number: int,
        world_version: int,
        asked_s: float,
        kind: str,
    ) -> None:
        self._planning, self._future = planning, future
        self._number, self._world_version = number, world_version
        self._asked_s, self._kind = asked_s, kind
        self._planned: Planned | None = None

    @property
    def done(self) -> bool:
        """Whether it is answered, and a checked trajectory was judged by the other side too."""
        if self._planned is None:
            if not self._future.done():
                return False
            if self._future.exception() is not None:
                return True
            self._planned = self._future.result()
            self._planning.answered(self._asked_s, self._kind, self._planned)
            if self._planned.document:
                self._planning.link.admit(self._number, self._world_version, self._planned.document)
        return not self._planned.document or self._number in self._planning.link.verdicts

    def result(self) -> Any:
        """The answer.

        Raises:
            NotAdmittedError: The other side would not judge it.
            Exception: Whatever the planner raised.
        """
        if self._planned is None:
            return self._future.result()
        answer = self._planned.answer
        if not self._planned.document or not isinstance(answer, CheckedTrajectory):
            return answer
        verdict = self._planning.link.verdicts.pop(self._number)
        if verdict is True:
            self._planning.checked += 1
            self._planning.motion.admitted(answer, self._number)
            return answer
        if isinstance(verdict, str):
            raise NotAdmittedError(verdict)
        return verdict

    def cancel(self) -> None:
        """Forget about it."""
        self._future.cancel()
