"""Stop one run of a course at some instants, each in a branch of its own."""

from __future__ import annotations

import time
import traceback
from dataclasses import dataclass, replace

import numpy as np

from executive.understanding.command_parser import parse
from robots.simulated.frugal_memory import make_room
from tools.evaluate.scenes import episode_rng
from tools.evaluate.stopping.branch import Branches
from tools.evaluate.stopping.courses import (
    COURSES,
    COURSES_BY_NAME,
    CYCLE,
    CYCLES,
    CourseRun,
    next_after,
)
from tools.evaluate.stopping.stop_judge import StopJudge
from tools.evaluate.stopping.stop_record import StopRecord
from tools.evaluate.stopping.timeline import Moment, choose, record

WATCHED_S = 10.0
"""After a stop the robot is watched for this long."""
_TRIED_AFTER_S = 0.5
_REASON = "the evaluation stops it"


@dataclass(frozen=True, slots=True)
class StopOrder:
    """One run and how often it is stopped.

    Attributes:
        seed: Of the run.
        suite: "stop" or "cancel".
        course: Index into ``COURSES``.
        wanted: Phases in which it is stopped.
        robot: Name of the robot.
    """

    seed: int
    suite: str
    course: int
    wanted: tuple[str, ...]
    robot: str = "talos"


def stop_orders(
    suite: str, episodes: int, seed: int, robot: str, course_name: str | None = None, scene: str | None = None
) -> list[StopOrder]:
    """Runs enough for so many instants; of one course alone, if it is named, else of a cycle."""
    orders: list[StopOrder] = []
    cycle = [COURSES.index(course) for course in CYCLES.get(scene or "", CYCLE)]
    left = episodes
    while left > 0:
        course = cycle[len(orders) % len(cycle)] if course_name is None else COURSES_BY_NAME[course_name]
        wanted = COURSES[course].wanted[:left]
        orders.append(StopOrder(seed + len(orders), suite, course, wanted, robot))
        left -= len(wanted)
    return orders


def run_stops(order: StopOrder) -> list[StopRecord]:
    """Run one order; whatever breaks becomes a record."""
    course = COURSES[order.course]
    blank = StopRecord(order.seed, course.name)
    branches: Branches[StopRecord] = Branches()
    try:
        rng = episode_rng(order.seed, 3)
        moments = choose(record(course, order.seed, order.robot), order.wanted, rng)
        make_room()
        _Stopper(order, moments, rng, branches).run()
    except Exception:
        branches.break_off()
        return [replace(blank, error=traceback.format_exc())]
    found = branches.results
    return [
        result if isinstance(result, StopRecord) else replace(blank, error=result or "the branch died")
        for result in found
    ]


def died(order: StopOrder) -> list[StopRecord]:
    """The records of an order whose process died."""
    return [StopRecord(order.seed, COURSES[order.course].name, error="the process died")]


class _Stopper:
    def __init__(
        self,
        order: StopOrder,
        moments: list[Moment],
        rng: np.random.Generator,
        branches: Branches[StopRecord],
    ) -> None:
        self._order, self._branches = order, branches
        self._waiting = [(moment, int(rng.integers(1, 3)), bool(rng.random() < 0.5)) for moment in moments]
        self._run = CourseRun(COURSES[order.course], order.seed, order.robot, self._take)
        self._judge = StopJudge(self._run.assembly)
        self._moment = Moment(0.0, "", 0.0)
        self._category, self._again = 1, False
        self._stopped_s = 0.0
        self._outcome = ""
        self._timing: float | None = None
        self._compute_ms = 0.0

    def run(self) -> None:
        self._run.assembly.session.watch_periods(self._on_period)
        self._run.run()
        if self._branches.in_copy:
            self._branches.deliver(self._cancelled() if self._order.suite == "cancel" else self._latched())

    def _take(self, event: object) -> None:
        outcome = getattr(event, "outcome", None)
        if self._branches.in_copy and outcome is not None and not self._outcome:
            self._outcome = str(outcome)

    def _on_period(self) -> None:
        self._judge.on_period()
        if self._timing is not None:
            self._compute_ms = max(self._compute_ms, 1e3 * (time.process_time() - self._timing))
            self._timing = None
        now_s = self._run.assembly.clock.now_s()
        while self._waiting and not self._branches.in_copy and now_s >= self._waiting[0][0].t_s - 1e-9:
            self._moment, self._category, self._again = self._waiting.pop(0)
            if self._branches.split():
                self._stop(now_s)

    def _stop(self, now_s: float) -> None:
        session = self._run.assembly.session
        self._run.stopped, self._stopped_s = True, now_s
        self._judge.begin()
        if self._order.suite == "cancel":
            session.cancel(_REASON)
        else:
            self._timing = time.process_time()
            session.emergency_stop(_REASON, self._category)

    def _latched(self) -> StopRecord:
        """After an emergency stop: a command is refused, nothing moves, and a person resets."""
        assembly = self._run.assembly
        self._hold_until(self._judge.rest_within_s + _TRIED_AFTER_S)
        (command,) = parse("go home").commands
        refused = assembly.session.run_task(command).outcome == "refused"
        self._hold_until(WATCHED_S)
        reset = assembly.session.reset("the evaluation")
        found = replace(self._measured(), category=self._category, refused=refused, reset=reset)
        return replace(found, reset=reset or self._recovered())

    def _recovered(self) -> str | None:
        assembly = self._run.assembly
        refusal = assembly.supervisor.admit(assembly.session.hold)
        return None if refusal is None else refusal.message

    def _cancelled(self) -> StopRecord:
        """After a cancel: it comes to rest, and the next command is carried out."""
        assembly = self._run.assembly
        self._hold_until(self._judge.rest_within_s + 0.2)
        self._judge.let_move()
        asked = next_after(COURSES[self._order.course], assembly, self._again and not self._judge.held)
        result = assembly.session.run_task(asked.command)
        done: str = result.outcome
        if done == "done" and not asked.truly(assembly):
            done = "claimed, and not so"
        self._hold_until(WATCHED_S)
        reason = result.failure.message if result.failure is not None else ""
        return replace(self._measured(), next_task=asked.command.text, next_outcome=done, next_reason=reason)

    def _hold_until(self, elapsed_s: float) -> None:
        assembly = self._run.assembly
        left_s = self._stopped_s + elapsed_s - assembly.clock.now_s()
        if left_s > 0.0:
            assembly.session.hold(left_s)

    def _measured(self) -> StopRecord:
        judge = self._judge
        return StopRecord(
            seed=self._order.seed,
            course=COURSES[self._order.course].name,
            t_s=self._moment.t_s,
            phase=self._moment.phase,
            arm_rad_s=self._moment.arm_rad_s,
            outcome=self._outcome,
            settle_s=judge.settle_s,
            rest_within_s=judge.rest_within_s,
            late_rad_s=judge.late_rad_s[0],
            late_joint=judge.late_rad_s[1],
            finger_rad_s=judge.finger_rad_s,
            acceleration=judge.acceleration[0],
            acceleration_joint=judge.acceleration[1],
            jerk=judge.jerk[0],
            jerk_joint=judge.jerk[1],
            held=tuple(sorted(judge.held)),
            dropped=tuple(sorted(judge.dropped)),
            fell=judge.fell,
            # a cancelled motion brakes under its own name; after a stop nobody else's name may appear
            foreign=tuple(sorted(judge.foreign)) if self._order.suite == "stop" else (),
            bypassed=judge.bypassed,
            moved=judge.moved,
            compute_ms=self._compute_ms,
        )
