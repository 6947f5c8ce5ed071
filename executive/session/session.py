"""One robot in one world, carrying out tasks in lockstep: simulated time passes only when asked."""

from __future__ import annotations

from collections.abc import Callable, Generator, Iterator
from contextlib import contextmanager
from typing import Protocol

from executive.manual.handed_back import PERSON
from executive.meaning import Command, StopCommand, command_json
from executive.session.by_hand import ByHand
from executive.session.cancellation import Cancellation
from executive.session.driver import driven
from executive.session.events import Event, EventHub, EventSink, TaskAccepted, TaskEnded
from executive.session.lockstep import Lockstep, Periods
from executive.session.pause import Pausable, Pause
from executive.session.supervisor import Supervisor
from executive.session.task_result import Outcome, TaskResult, TaskTimes, subject_of
from robots.clock import Clock, WallClock
from trees.build import TaskTree, build_tree
from trees.failures import Failure, FailureKind, Number
from trees.nodes.leaf import from_exception
from trees.registry import skill_of
from trees.tasks import Task
from trees.toolbox import Toolbox

HALT_TICKS = 100
"""Ticks that the loop goes on after a cancel: more than the longest braking takes."""

TASK_TIMEOUT_S = 480.0
"""Simulated time after which a task is given up: more than any tree gives itself, to end tidily before."""


TreeBuilder = Callable[[Task, Toolbox], TaskTree]


def _usual_limit_s(command: Command) -> float:
    """Simulated time that a task may take when nobody says how long; a wait lasts as long as said."""
    skill = skill_of(command)
    return TASK_TIMEOUT_S + (0.0 if skill is None else skill.lasts_s(command))


class PlanningTimes(Protocol):
    """What is asked of the planning service for the report."""

    wall_s: float


class Session:
    """Runs commands one after another.

    Args:
        toolbox: What the trees' leaves may call.
        loop: Steps the robot.
        planning: The planning service of ``toolbox``, for its times.
        sink: Takes every event.
        tick_sensors: Called each control period: simulated sensors that run beside the loop.
        on_period: Called after each control period: an evaluation's monitor, a camera.
        on_tick: Called before the first tick and after each with the tree: a display.
        build: Makes a task's tree; `build_tree` when left out.
        supervisor: Says whether commands may be carried out; without one, all may.
        pausing: Holds the robot during a pause; without one, what it is doing goes on to its end.

    Attributes:
        hands: Lets a person take a task over, and give it back.
    """

    def __init__(
        self,
        toolbox: Toolbox,
        loop: Periods,
        planning: PlanningTimes,
        sink: EventSink,
        *,
        tick_sensors: Callable[[], None] | None = None,
        on_period: Callable[[], None] | None = None,
        on_tick: Callable[[TaskTree], None] | None = None,
        build: TreeBuilder | None = None,
        supervisor: Supervisor | None = None,
        pausing: Pausable | None = None,
    ) -> None:
        self._supervisor = supervisor
        self._toolbox, self._planning = toolbox, planning
        self._sink = sink if isinstance(sink, EventHub) else EventHub(sink)
        beside = [call for call in (tick_sensors, on_period) if call is not None]
        self._lockstep = Lockstep(loop, toolbox.clock, self._sink, beside, supervisor)
        self._on_tick = on_tick
        self._build = build
        self._clock: Clock = toolbox.clock
        self._pause = Pause(pausing, self._sink, self._clock.now_s)
        self._request: Cancellation | None = None
        self.hands = ByHand(toolbox, self._lockstep, self._sink, self._stopped_or_cancelled)
        self._wakers: list[Callable[[], None]] = []

    @property
    def now_s(self) -> float:
        """Simulated time."""
        return self._clock.now_s()

    @property
    def toolbox(self) -> Toolbox:
        """What the trees' leaves may call; holds what the robot believes."""
        return self._toolbox

    def tell(self, event: Event) -> None:
        """Put an event among the session's own."""
        self._sink(event)

    @property
    def events(self) -> EventHub:
        """Where every layer's events go; others may listen for a time."""
        return self._sink

    @contextmanager
    def request(self, cancellation: Cancellation | None = None) -> Iterator[Cancellation]:
        """Let what is carried out meanwhile be one request, which a cancel or a pause is for.

        Within another one it is a part of that. An errand, and a task on its own, are one without being told.

        Args:
            cancellation: Its cancel, where somebody asked for it, or may ask for it, past this session.

        Yields:
            The request's cancel.
        """
        if self._request is not None:
            yield self._request
            return
        self._request = cancellation or Cancellation()
        try:
            yield self._request
        finally:
            self._request = None
            self._pause.withdraw()

    def cancel(self, reason: str) -> None:
        """Ask for the request under way to be halted; safe to call from a signal handler.

        It ends where it is: in the middle of a task, at a question, between two tasks. While none is under
        way there is nothing to halt.
        """
        if (request := self._request) is not None:
            request.ask(reason)
            self.wake()

    @property
    def interrupted(self) -> bool:
        """Whether the request under way was cancelled, or the emergency stop is engaged or asked for."""
        if self._request is not None and self._request.asked:
            return True
        return self._supervisor is not None and (
            self._supervisor.stop_asked or self._supervisor.stopped() is not None
        )

    def interruption(self) -> Failure | None:
        """What ends a request that has waited for a person, or None when it may go on.

        A stop that was asked for in the meantime, and that no control period has taken up, is engaged first.
        """
        if self._supervisor is not None:
            if self._supervisor.stop_asked:
                self._lockstep.tick()
            if (stopped := self._supervisor.stopped()) is not None:
                return Failure(FailureKind.CANCELED, stopped)
        return self._cancelled()

    def _stopped_or_cancelled(self) -> Failure | None:
        """What ends a person's jogging beside the person."""
        if self._supervisor is not None:
            if (stopped := self._supervisor.stopped()) is not None:
                return Failure(FailureKind.CANCELED, stopped)
            if (unwell := self._supervisor.unwell()) is not None:
                self._supervisor.note_defect(unwell.message)
                return Failure(FailureKind.CANCELED, unwell.message)
        return self._cancelled()

    def _cancelled(self) -> Failure | None:
        return None if self._request is None else self._request.taken(self.now_s, self._sink)

    @contextmanager
    def woken_by(self, wake: Callable[[], None]) -> Iterator[None]:
        """Have something called, from any thread, when a request that waits for a person may go on or end."""
        self._wakers.append(wake)
        try:
            yield
        finally:
            self._wakers.remove(wake)

    def wake(self) -> None:
        """Tell whoever sleeps until a request may go on to look again; safe to call from any thread."""
        for wake in tuple(self._wakers):
            wake()

    def pause(self, reason: str) -> None:
        """Ask for the request under way to be held where it is; safe to call from a signal handler.

        It goes on with ``resume``; a cancel or a stop ends the pause as well. While none is under way there
        is nothing to hold; at a question, the task that the answer makes is held at its beginning. Time in a
        pause counts towards no deadline.
        """
        if self._request is not None:
            self._pause.ask(reason)

    def resume(self) -> None:
        """Ask for a paused task to go on; safe to call from a signal handler."""
        self._pause.withdraw()

    @property
    def paused(self) -> bool:
        """Whether a task is held by a pause now."""
        return self._pause.held

    def emergency_stop(self, reason: str, category: int = 1) -> None:
        """Engage the emergency stop before the next control period; safe to call from a signal handler.

        Raises:
            RuntimeError: Nothing supervises this session.
        """
        self._supervised().emergency_stop(reason, category)
        self._lockstep.note_stop(f"{category} {reason}")
        self.wake()

    def reset(self, person: str) -> str | None:
        """Leave the emergency stop on a person's explicit request; returns what stands against it.

        Raises:
            RuntimeError: Nothing supervises this session.
        """
        return self._supervised().reset(person)

    def watch_periods(self, call: Callable[[], None]) -> None:
        """Have something called after each control period."""
        self._lockstep.watch(call)

    def hold(self, seconds: float) -> None:
        """Let simulated time pass while the robot holds what it does."""
        self._lockstep.let_pass(seconds)

    def run_task(self, command: Command, timeout_s: float | None = None) -> TaskResult:
        """Carry out one command to its end.

        Whatever happens, the robot is left standing, and holding still or at rest.
        """
        return driven(self.task_steps(command, timeout_s))

    def task_steps(
        self, command: Command, timeout_s: float | None = None, by_hand: bool = False
    ) -> Generator[None, object, TaskResult]:
        """The same as ``run_task``, a tick at a time, for a driver that does other things in between.

        With ``by_hand`` it begins in a person's hands.
        """
        with self.request():
            return (yield from self._task_steps(command, timeout_s, by_hand))

    def _task_steps(
        self, command: Command, timeout_s: float | None, by_hand: bool
    ) -> Generator[None, object, TaskResult]:
        wall = WallClock()
        self._lockstep.settle()
        began_s, planned_s = self.now_s, self._planning.wall_s
        self._sink(TaskAccepted(began_s, command.text, command_json(command)))
        tree: TaskTree | None = None
        person: dict[str, Number] = {}
        acted_on: str | None = None
        refusal = None if self._supervisor is None else self._supervisor.admit(self._lockstep.let_pass)
        outcome: tuple[Outcome, Failure | None]
        if isinstance(command, StopCommand):
            outcome = self._halted_nothing()
        elif refusal is not None:
            outcome = "refused", refusal
        else:
            limit_s = _usual_limit_s(command) if timeout_s is None else timeout_s
            if by_hand:
                self.hands.take_over("from the beginning")
                outcome = "cancelled", None
            else:
                tree = (self._build or build_tree)(command, self._toolbox)
                outcome = yield from self._run_guarded(tree, began_s + limit_s)
            while self.hands.wants(*outcome):
                given = yield from self.hands.steps(command)
                person, acted_on = {"by": PERSON, **given.evidence}, given.acted_on
                if given.outcome is not None:
                    outcome = given.outcome, given.failure
                    break
                tree = (self._build or build_tree)(command, self._toolbox)
                outcome = yield from self._run_guarded(tree, self.now_s + limit_s)
            self._stand()
        status, failure = outcome
        evidence = {**(tree.evidence if tree is not None else {}), **person}
        attempts = tree.attempts if tree is not None else 0
        self._sink(TaskEnded(self.now_s, command.text, status, attempts, failure, evidence))
        times = TaskTimes(self._planning.wall_s - planned_s, self.now_s - began_s, wall.now_s())
        acted_on = acted_on or (None if tree is None else tree.acted_on)
        return TaskResult(
            command.text,
            command.action,
            status,
            attempts,
            failure,
            evidence,
            times,
            subject_of(command, acted_on),
            acted_on=acted_on,
            others=() if tree is None else tree.others,
        )

    def _run_guarded(
        self, tree: TaskTree, deadline_s: float
    ) -> Generator[None, object, tuple[Outcome, Failure | None]]:
        """Run, and draw the conclusions: a defect anywhere below fails the task and leads to ERROR."""
        try:
            outcome, failure = yield from self._run(tree, deadline_s)
        except Exception as defect:
            if self._supervisor is None:
                raise
            outcome, failure = "failed", from_exception(defect).at("control")
            tree.halt(failure.message)
            self._lockstep.tick(HALT_TICKS)
        root = failure
        while root is not None and root.cause is not None:
            root = root.cause
        if self._supervisor is not None and root is not None and root.kind is FailureKind.ERROR:
            self._supervisor.note_defect(root.message)
        return outcome, failure

    def _run(
        self, tree: TaskTree, deadline_s: float
    ) -> Generator[None, object, tuple[Outcome, Failure | None]]:
        self._show(tree)
        try:
            return (yield from self._ticked(tree, deadline_s))
        finally:
            self._pause.end()

    def _ticked(
        self, tree: TaskTree, deadline_s: float
    ) -> Generator[None, object, tuple[Outcome, Failure | None]]:
        while True:
            yield
            if self._supervisor is not None and (stopped := self._supervisor.stopped()) is not None:
                return "cancelled", self._halt(tree, FailureKind.CANCELED, stopped)
            if self._supervisor is not None and (unwell := self._supervisor.unwell()) is not None:
                self._supervisor.note_defect(unwell.message)
                failure = self._halt(tree, FailureKind.EXECUTION, unwell.message)
                return "failed", failure
            if (cancelled := self._cancelled()) is not None:
                return "cancelled", self._halt(tree, FailureKind.CANCELED, cancelled.message)
            if self.hands.asked:
                self.hands.note_asked("in its middle")
                return "cancelled", self._halt(tree, FailureKind.CANCELED, "a person takes over")
            if self._pause.follow():
                before_s = self.now_s
                self._lockstep.tick()
                self._toolbox.pauses.total_s += self.now_s - before_s
                deadline_s += self.now_s - before_s
                continue
            if self.now_s >= deadline_s:
                return "failed", self._halt(tree, FailureKind.TIMEOUT, "the task took longer than allowed")
            tree.tick()
            self._show(tree)
            if tree.status != "running":
                break
            self._lockstep.tick()
        if tree.status == "success":
            return "done", None
        asks = tree.failure is not None and tree.failure.choices
        return ("question" if asks else "failed"), tree.failure

    def _stand(self) -> None:
        """Let a walk that was stopped make its last steps."""
        walking = self._toolbox.walking
        while walking is not None and walking.active:
            self._lockstep.tick()

    def _halt(self, tree: TaskTree, kind: FailureKind, reason: str) -> Failure:
        tree.halt(reason)
        self._lockstep.tick(HALT_TICKS)
        self._show(tree)
        halted = tree.failure  # says the same from below, with its place and what had gone wrong before
        if halted is None:
            return Failure(kind, reason)
        return Failure(kind, reason, where=halted.where, cause=halted.cause)

    def _supervised(self) -> Supervisor:
        if self._supervisor is None:
            raise RuntimeError("nothing supervises this session")
        return self._supervisor

    def _show(self, tree: TaskTree) -> None:
        if self._on_tick is not None:
            self._on_tick(tree)

    def _halted_nothing(self) -> tuple[Outcome, Failure | None]:
        """A spoken stop with nothing under way: the robot stands and holds already."""
        self._lockstep.tick()
        return "done", None
