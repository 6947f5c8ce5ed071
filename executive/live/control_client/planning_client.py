"""Planning in live mode: in a worker process, and what is checked is checked by both sides."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import Future
from typing import Any, Generic, Protocol, TypeVar

from executive.live.control_client.control_link import ControlLink
from executive.live.control_client.motion_client import MotionClient
from executive.live.control_client.planning_service import Planned
from executive.session.events import PlanningAnswered
from kinematics.motion.verdict import CheckedTrajectory, Unsafe
from kinematics.requests.check import CheckRequest
from kinematics.requests.request import Request
from robots.live.wire.errors import LiveError
from trees.toolbox import Job
from trees.world_model import WorldModel

Answer = TypeVar("Answer")


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

    def submit(self, request: Request[Answer]) -> Job[Answer]:
        """Begin to answer a request."""
        return LiveJob(self, self._asked(request), self.link.now_s, type(request).__name__)

    def check(self, question: CheckRequest) -> Job[CheckedTrajectory | Unsafe]:
        """Begin to have a trajectory judged, here and then by the other side."""
        future = self._asked(question)
        return LiveCheck(self, future, self.link.now_s, self._count, self._world.scene.version)

    def _asked(self, question: object) -> Future[Any]:
        self._count += 1
        return self._worker.ask(question)

    def answered(self, asked_s: float, kind: str, planned: Planned[Any]) -> None:
        """Note an answer of the worker."""
        self.wall_s += planned.wall_s
        self._sink(PlanningAnswered(asked_s, self.link.now_s, kind, type(planned.answer).__name__))


class LiveJob(Generic[Answer]):
    """A request under way; satisfies ``trees.toolbox.Job``."""

    def __init__(
        self, planning: LivePlanning, future: Future[Planned[Answer]], asked_s: float, kind: str
    ) -> None:
        self._planning, self._future = planning, future
        self._asked_s, self._kind = asked_s, kind
        self._planned: Planned[Answer] | None = None

    @property
    def done(self) -> bool:
        """Whether it is answered."""
        if self._planned is None and self._future.done() and self._future.exception() is None:
            self._planned = self._future.result()
            self._planning.answered(self._asked_s, self._kind, self._planned)
            self._arrived(self._planned)
        return self._future.done()

    def _arrived(self, planned: Planned[Answer]) -> None:
        """Do what is to be done with an answer at once."""

    def result(self) -> Answer:
        """The answer.

        Raises:
            Exception: Whatever the planner or the checker raised.
        """
        return self._future.result().answer

    def cancel(self) -> None:
        """Forget about it."""
        self._future.cancel()


class LiveCheck(LiveJob[CheckedTrajectory | Unsafe]):
    """A check under way: what the checker here lets pass is judged by the other side too."""

    def __init__(
        self,
        planning: LivePlanning,
        future: Future[Planned[CheckedTrajectory | Unsafe]],
        asked_s: float,
        number: int,
        world_version: int,
    ) -> None:
        super().__init__(planning, future, asked_s, CheckRequest.__name__)
        self._number, self._world_version = number, world_version

    @property
    def done(self) -> bool:
        """Whether it is judged, and by the other side too where this one let it pass."""
        answered = super().done
        return answered and (not self._admits or self._number in self._planning.link.verdicts)

    @property
    def _admits(self) -> bool:
        return self._planned is not None and bool(self._planned.document)

    def _arrived(self, planned: Planned[CheckedTrajectory | Unsafe]) -> None:
        """Send what passed to the other side."""
        if planned.document:
            self._planning.link.admit(self._number, self._world_version, planned.document)

    def result(self) -> CheckedTrajectory | Unsafe:
        """The verdict of both sides.

        Raises:
            NotAdmittedError: The other side would not judge it.
            Exception: Whatever the checker raised.
        """
        answer = super().result()
        if not self._admits or not isinstance(answer, CheckedTrajectory):
            return answer
        verdict = self._planning.link.verdicts.pop(self._number)
        if isinstance(verdict, str):
            raise NotAdmittedError(verdict)
        if isinstance(verdict, Unsafe):
            return verdict
        self._planning.checked += 1
        self._planning.motion.admitted(answer, self._number)
        return answer
