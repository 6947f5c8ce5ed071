"""Planning in lockstep: answered at once, but charged a declared simulated time.

The world moves on while the robot thinks, so that stale plans do occur; and the same run plans the
same, whatever the machine's speed.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from concurrent.futures import Executor, Future
from typing import Any, Generic, Protocol, TypeVar

from executive.session.events import PlanningAnswered
from kinematics.motion.trajectory import Trajectory
from kinematics.motion.verdict import CheckedTrajectory, Unsafe
from kinematics.requests.check import CheckRequest
from kinematics.requests.request import Request
from kinematics.scene.concessions import Concession
from kinematics.scene.planning_scene import PlanningScene
from robots.clock import Clock, ProcessorClock, WallClock
from trees.toolbox import Job

CHARGED_S = 0.1
"""Simulated time that a job is charged; above the planner's usual wall time."""


Asked = TypeVar("Asked")
Answer = TypeVar("Answer")


class Planner(Protocol):
    """What answers requests: the motion planner, or a double."""

    def answer(self, request: Request[Answer]) -> Answer:
        """Answer one request."""
        ...


class Checker(Protocol):
    """What judges trajectories: the trajectory checker, or a double."""

    def check(
        self, trajectory: Trajectory, scene: PlanningScene, concessions: Sequence[Concession] = ()
    ) -> CheckedTrajectory | Unsafe:
        """Judge one motion in one scene."""
        ...


class InlineExecutor(Executor):
    """Runs what is submitted at once, in the caller's thread."""

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        """Call ``fn`` and return the finished future."""
        future: Future[Any] = Future()
        try:
            future.set_result(fn(*args, **kwargs))
        except Exception as raised:
            future.set_exception(raised)
        return future


class PlanningJob(Generic[Answer]):
    """A request or a check under way; satisfies ``trees.toolbox.Job``."""

    def __init__(
        self, future: Future[Answer], clock: Clock, ready_s: float, tell: Callable[[Future[Any]], None]
    ) -> None:
        """Take a request that was submitted.

        Args:
            future: Of its answer.
            clock: Simulated time.
            ready_s: When its charged time has passed.
            tell: Called with the future in the thread that ticks, once it is known there to be answered.
        """
        self._future, self._clock, self._ready_s = future, clock, ready_s
        self._tell, self._told = tell, False
        self._is_answered()

    @property
    def done(self) -> bool:
        """Whether it is answered and its charged time has passed."""
        return self._is_answered() and self._clock.now_s() >= self._ready_s

    def _is_answered(self) -> bool:
        if not self._future.done():
            return False
        if not self._told and not self._future.cancelled():
            self._told = True
            self._tell(self._future)
        return True

    def result(self) -> Answer:
        """The answer.

        Raises:
            Exception: Whatever the planner or the checker raised.
        """
        return self._future.result()

    def cancel(self) -> None:
        """Forget about it."""
        self._future.cancel()


class PlanningJobs:
    """Submits requests and checks to an executor; satisfies ``trees.toolbox.Planning``.

    ``on_judged`` hears of every trajectory that was judged, with the verdict: a recorder.

    Attributes:
        wall_s: Wall time that answers took so far, for reports only.
        cpu_s: Processor time that they took, when they are answered in this process.
        checked: Trajectories that passed the checker so far.
    """

    def __init__(
        self,
        planner: Planner,
        checker: Checker,
        clock: Clock,
        sink: Callable[[PlanningAnswered], None],
        executor: Executor | None = None,
        charged_s: float = CHARGED_S,
        on_judged: Callable[[CheckRequest, CheckedTrajectory | Unsafe], None] = lambda _request, _answer: (
            None
        ),
    ) -> None:
        self._planner, self._checker = planner, checker
        self._clock, self._sink = clock, sink
        self._executor = executor or InlineExecutor()
        self._charged_s = charged_s
        self._on_judged = on_judged
        self._wall, self._cpu = WallClock(), ProcessorClock()
        self.wall_s = 0.0
        self.cpu_s = 0.0
        self.checked = 0

    def submit(self, request: Request[Answer]) -> Job[Answer]:
        """Begin to answer a request; returns at once where the executor does."""
        return self._begun(request, self._planner.answer)

    def check(self, question: CheckRequest) -> Job[CheckedTrajectory | Unsafe]:
        """Begin to judge a trajectory; returns at once where the executor does."""
        return self._begun(question, self._verdict)

    def _begun(self, asked: Asked, answer: Callable[[Asked], Answer]) -> Job[Answer]:
        ready_s = self._clock.now_s() + self._charged_s
        kind = type(asked).__name__

        def tell(answered: Future[Any]) -> None:
            raised = answered.exception()
            told = type(answered.result() if raised is None else raised).__name__
            self._sink(PlanningAnswered(self._clock.now_s(), ready_s, kind, told))

        future: Future[Answer] = self._executor.submit(self._timed, asked, answer)
        return PlanningJob(future, self._clock, ready_s, tell)

    def _timed(self, asked: Asked, answer: Callable[[Asked], Answer]) -> Answer:
        began_s, cpu_s = self._wall.now_s(), self._cpu.now_s()
        try:
            return answer(asked)
        finally:
            self.wall_s += self._wall.now_s() - began_s
            self.cpu_s += self._cpu.now_s() - cpu_s

    def _verdict(self, question: CheckRequest) -> CheckedTrajectory | Unsafe:
        verdict = self._checker.check(question.trajectory, question.scene, question.concessions)
        self.checked += isinstance(verdict, CheckedTrajectory)
        self._on_judged(question, verdict)
        return verdict
