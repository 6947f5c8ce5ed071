"""The commands of one statement, carried out in order: references, several objects, questions.

An errand goes on tick by tick, and hands an open question to whoever drives it; the answer continues the
same task. What comes after a task that was not done is not begun.
"""

from __future__ import annotations

from collections.abc import Generator, Iterator, Sequence
from dataclasses import replace

from executive.dialogue.clarification import OpenQuestion
from executive.dialogue.settle_words import without_skill
from executive.errands.answered_command import answered_command, of_one
from executive.errands.errand_beliefs import ErrandBeliefs
from executive.errands.impossible import beyond
from executive.errands.nearness import Nearness
from executive.errands.prepared import Known, Prepared
from executive.errands.required import goal, handles, puts_in, puts_on, requires, walk, with_names
from executive.errands.unsaid_steps import (
    looked_for,
    prepared,
    seen_from_where,
)
from executive.meaning import Command
from executive.references import PREVIOUS, references, with_references
from executive.session.events import TaskRefused
from executive.session.session import Session
from executive.session.task_result import TaskResult, TaskTimes
from executive.trust import OnQuestion
from executive.understanding.provenance import Provenance
from trees.beliefs.grounding.destination import START
from trees.beliefs.grounding.grounding import exactly
from trees.build import NoSkillError
from trees.failures import Failure, FailureKind, Reason
from trees.skill import Before
from trees.tasks import Destination, ObjectDescription, ObjectOf

Steps = Generator[OpenQuestion | None, str | None, tuple[TaskResult, ...]]
"""None after each tick, a question where one is open; takes its answer, or None when there is none."""


class Errand:
    """Carries out the commands of one statement in order, a tick at a time.

    Args:
        session: Carries out single tasks.
        commands: What to do, in order.
        timeout_s: Simulated time that each task may take; None is the usual.
        on_question: What becomes of questions.
        provenance: Where each command comes from, when a model asked for it.
        beliefs: What is believed of the world; the session's when left out.
    """

    def __init__(
        self,
        session: Session,
        commands: Sequence[Command],
        *,
        timeout_s: float | None = None,
        on_question: OnQuestion = "ask",
        provenance: Sequence[Provenance | None] = (),
        beliefs: ErrandBeliefs | None = None,
    ) -> None:
        self._session = session
        self._commands = tuple(commands)
        self._timeout_s = timeout_s
        self._on_question = on_question
        self._beliefs = beliefs or ErrandBeliefs(session.toolbox)
        self._provenance = tuple(provenance) or (None,) * len(self._commands)
        self._acted_on: list[tuple[str, ...]] = []
        self._who: dict[str, str] = {}
        self._found: dict[int | None, str] = {}
        self._walked_for: TaskResult | None = None
        self._walked_with: set[bool] = set()  # True: with the thing in a hand, to where it goes

    def steps(self) -> Steps:
        """Carry everything out; returns the results of the tasks that were begun."""
        with self._session.request():
            return (yield from self._steps())

    def _steps(self) -> Steps:
        refused = self._refused()
        if refused is not None:
            return (refused,)
        results: list[TaskResult] = []
        self._beliefs.note_where_asked()
        steps = list(prepared(self._commands, self._walks(), self._beliefs.known()))
        while steps:
            step, begun = steps.pop(0), len(results)
            if self._is_needless(step) or (yield from self._step(step, results)):
                continue
            first = len(results) == begun + 1
            if not first or step.said is None or not self._is_worth_a_walk(step, results[-1]):
                self._tell_of_what_was_said(step, results)
                break
            self._walked_for = results[-1]
            self._walked_with.add(self._carries(step.command))
            steps = list(looked_for(self._commands, step.said, self._beliefs.known(), self._who))
        return tuple(results)

    def _step(
        self, step: Prepared, results: list[TaskResult]
    ) -> Generator[OpenQuestion | None, str | None, bool]:
        """Carry out one step, on several objects one after the other; whether the errand goes on."""
        provenance = None if step.said is None else self._provenance[step.said]
        command = with_names(step.command, self._who)
        about = step.finds_for if step.said is None else step.said
        if about in self._found:
            command = of_one(command, self._found[about])
        names: list[str] = []
        waiting = list(self._filled(command))
        while waiting:
            result = yield from self._task(waiting.pop(0))
            results.append(replace(result, provenance=provenance))
            if result.outcome != "done":
                goes_on = result.outcome == "failed" and step.may_fail
                if goes_on and step.finds_who:
                    self._who[step.finds_who] = START
                return goes_on
            names += [] if result.acted_on is None else [result.acted_on]
            waiting[:0] = [of_one(command, name) for name in result.others]
            if step.finds_for is not None and result.acted_on is not None:
                self._found[step.finds_for] = result.acted_on
            if step.finds_who and (found := result.evidence.get("found")):
                self._who[step.finds_who] = str(found)
        if step.said is not None:
            self._acted_on.append(tuple(names) if step.carries is None else self._names_of(step.carries))
        return True

    def _is_worth_a_walk(self, step: Prepared, result: TaskResult) -> bool:
        """Whether what was not seen, grasped or put down from here is to be walked to.

        Once in an errand to the object, and once to where it goes; not what the robot has walked to already.
        """
        command, failure, known = step.command, result.failure, self._beliefs.known()
        if result.outcome != "failed" or failure is None or known.rooms or not self._walks():
            return False
        unseen = failure.is_unseen and result.attempts <= 1
        if (asked := seen_from_where(command)) is not None:
            return (
                unseen and not self._walked_with and not step.is_reached and _may_be_elsewhere(asked, known)
            )
        if not handles(command) or command.count != 1:
            return False
        carries = self._carries(command)
        if carries in self._walked_with or (step.is_reached and not carries):
            return False
        if failure.is_unseen:
            return unseen and _may_be_elsewhere(command.source, known)
        if failure.root.reason is Reason.PERSON_TOO_FAR:
            return True
        if failure.root.reason is Reason.NO_GRASP and _is_far(command.object, known):
            return True
        if failure.root.kind is not FailureKind.INFEASIBLE or not puts_on(command):
            return False  # and what no hand could take is brought nowhere
        return carries and _is_far(goal(self._beliefs.with_other_furniture_named(command)), known)

    def _carries(self, command: Command) -> bool:
        """Whether something is in a hand by now and only has to go somewhere, or to somebody."""
        if not handles(command) or puts_in(command) or not requires(command, Before.THING_HELD):
            return False
        return self._beliefs.known().in_hand(command)

    def _tell_of_what_was_said(self, step: Prepared, results: list[TaskResult]) -> None:
        """What was not to be seen elsewhere either is told as what was asked for, not as a walk to it."""
        first, last = self._walked_for, results[-1]
        if first is None or first.failure is None or not first.failure.is_unseen or step.said is not None:
            return
        if last.failure is None or not last.failure.is_unseen:
            return
        failure = replace(
            first.failure, message=f"{first.failure.message}, nor elsewhere", cause=last.failure
        )
        results[-1] = replace(last, text=first.text, action=first.action, failure=failure)

    def _is_needless(self, step: Prepared) -> bool:
        """Whether what has been seen and done meanwhile makes a step superfluous."""
        known = self._beliefs.known()
        held = step.unless_held is not None and known.in_hand(step.unless_held)
        near = step.unless_near is not None and known.is_near(step.unless_near)
        return held or near or (step.unless_open and known.is_open)

    def _walks(self) -> bool:
        return self._session.toolbox.can_walk

    # --- one task, with its questions -----------------------------------------------------------

    def _task(self, command: Command | Failure) -> Generator[OpenQuestion | None, str | None, TaskResult]:
        if isinstance(command, Failure):
            return TaskResult(self._commands[-1].text, self._commands[-1].action, "failed", failure=command)
        times, attempts = TaskTimes(), 0
        command = self._beliefs.with_other_furniture_named(command)
        while True:
            result = yield from self._session.task_steps(command, self._timeout_s)
            times, attempts = _sum(times, result.times), attempts + result.attempts
            result = replace(result, times=times, attempts=attempts)
            if result.outcome != "question" or result.failure is None:
                return result
            answered = yield from answered_command(
                self._session, command, result.failure, self._on_question, self._beliefs.around
            )
            if answered is None:
                return result
            if isinstance(answered, Failure):
                return replace(result, outcome="cancelled", failure=answered)
            command = answered
            if (walk := self._walk_there(command, result.failure)) is not None:
                walked = yield from self._session.task_steps(walk, self._timeout_s)
                times = _sum(times, walked.times)
                if walked.outcome != "done":
                    return replace(result, outcome=walked.outcome, failure=walked.failure)

    def _walk_there(self, command: Command, asked: Failure) -> Command | None:
        """The walk to the furniture in a room that something goes onto, if the robot is not before it."""
        on = goal(command)
        if not puts_on(command) or asked.choice_slot != "on" or not self._walks():
            return None
        if not isinstance(on, ObjectDescription):
            return None
        if getattr(command, "to", None) not in self._session.toolbox.places:
            return None
        return None if self._beliefs.known().is_near(Nearness(on)) else walk(f"walk to the {on}", on)

    # --- before anything moves ------------------------------------------------------------------

    def _refused(self) -> TaskResult | None:
        """What is no skill, or cannot be, is found out before the first task begins: nothing is half done."""
        command = without_skill(self._commands)
        if command is not None:
            message = str(NoSkillError(command))
            self._session.tell(TaskRefused(self._session.now_s, command.text, message, None))
            failure = Failure(FailureKind.REFUSED, message)
            return TaskResult(command.text, command.action, "refused", failure=failure)
        why = beyond(self._commands, self._session.toolbox)
        if why is None:
            return None
        self._session.tell(TaskRefused(self._session.now_s, why.command.text, why.message, why.word))
        failure = Failure.infeasible(why.message)
        return TaskResult(why.command.text, why.command.action, "failed", failure=failure)

    # --- references -----------------------------------------------------------------------------

    def _filled(self, command: Command) -> Iterator[Command | Failure]:
        """The command with its references to earlier tasks filled in; once for each of several objects."""
        referred = {index: self._names_of(index) for index in sorted(references(command))}
        if not all(referred.values()):
            yield Failure.infeasible(f"what {command.text!r} refers to is not known")
            return
        own = getattr(command, "object", None)
        several = referred[own.task] if isinstance(own, ObjectOf) else (None,)
        for name in several:
            chosen = {index: names[0] for index, names in referred.items()}
            if isinstance(own, ObjectOf) and name is not None:
                chosen[own.task] = name
            things = {index: exactly(name) for index, name in chosen.items()}
            yield with_references(command, things.__getitem__)

    def _names_of(self, index: int) -> tuple[str, ...]:
        """What a command of this errand was about, or the one before it all."""
        if index == PREVIOUS.task:
            before = self._session.toolbox.world.last_acted_on
            return () if before is None else (before,)
        return self._acted_on[index] if index < len(self._acted_on) else ()


def _may_be_elsewhere(source: Destination | None, known: Known) -> bool:
    """Whether what is not in view may be anywhere but on what the robot stands before."""
    if isinstance(source, str):
        source = ObjectDescription(source)
    return not (isinstance(source, ObjectDescription) and known.is_near(Nearness(source)))


def _is_far(place: Destination | None, known: Known) -> bool:
    """Whether a thing, or furniture, is where no hand gets to without a step."""
    if isinstance(place, str):
        return not known.is_near(Nearness(ObjectDescription(place)))
    if not isinstance(place, ObjectDescription) or place.kind is None:
        return False
    return not known.is_near(Nearness(place))


def _sum(a: TaskTimes, b: TaskTimes) -> TaskTimes:
    return TaskTimes(
        a.planning_wall_s + b.planning_wall_s, a.simulated_s + b.simulated_s, a.wall_s + b.wall_s
    )
