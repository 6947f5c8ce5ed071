"""The commands of one statement, carried out in order: references, several objects, questions.

An errand goes on tick by tick, and hands an open question to whoever drives it; the answer continues the
same task. What comes after a task that was not done is not begun.
"""

from __future__ import annotations

from collections.abc import Generator, Iterator, Sequence
from dataclasses import replace

from executive.answered_command import answered_command, of_one
from executive.at_hand import Nearness, is_near
from executive.attendant import Attendant
from executive.clarification import OpenQuestion
from executive.events import TaskRefused
from executive.impossible import impossible
from executive.meaning import Command, StopCommand
from executive.other_furniture import named_other, settled
from executive.preparing import Bringing, Known, Prepared, looked_for, prepared, with_names
from executive.references import PREVIOUS, references, with_references
from executive.session import Session
from executive.task_result import Provenance, TaskResult, TaskTimes
from executive.trust import OnQuestion
from kinematics import poses
from kinematics.poses import Transform
from trees.away_from_start import is_away
from trees.believed_thing import Surroundings, surroundings
from trees.build import NoSkillError, has_skill
from trees.drawer_inside import DrawerInside, inside_of_drawer
from trees.failures import Failure, FailureKind
from trees.fridge_inside import LEAST_OPEN_RAD, door_opening_rad
from trees.grounding import Found, exactly, ground
from trees.held import HeldObject, held_object
from trees.odometry import body_pose
from trees.regions import START
from trees.tasks import (
    Destination,
    ObjectDescription,
    ObjectOf,
    PickTask,
    PlaceTask,
    Task,
    Thing,
    WalkToTask,
)

Steps = Generator[OpenQuestion | None, str | None, tuple[TaskResult, ...]]
"""None after each tick, a question where one is open; takes its answer, or None when there is none."""


class Errand:
    """One statement's commands on their way.

    Args:
        session: Carries out single tasks.
        commands: What to do, in order.
        timeout_s: Simulated time that each task may take; None is the usual.
        on_question: What becomes of questions.
        provenance: Where each command comes from, when a model asked for it.
    """

    def __init__(
        self,
        session: Session,
        commands: Sequence[Command],
        *,
        timeout_s: float | None = None,
        on_question: OnQuestion = "ask",
        provenance: Sequence[Provenance | None] = (),
    ) -> None:
        self._session = session
        self._commands = tuple(commands)
        self._timeout_s = timeout_s
        self._on_question = on_question
        self._provenance = tuple(provenance) or (None,) * len(self._commands)
        self._acted_on: list[tuple[str, ...]] = []
        self._who: dict[str, str] = {}
        self._found: dict[int | None, str] = {}
        self._walked_for: TaskResult | None = None
        self._walked: set[bool] = set()

    def steps(self) -> Steps:
        """Carry everything out; returns the results of the tasks that were begun."""
        refused = self._refused()
        if refused is not None:
            return (refused,)
        results: list[TaskResult] = []
        self._session.toolbox.world.asked_at = self._base()
        steps = list(prepared(self._commands, self._walks(), self._known()))
        while steps:
            step, begun = steps.pop(0), len(results)
            if self._is_needless(step) or (yield from self._step(step, results)):
                continue
            first = len(results) == begun + 1
            if not first or step.said is None or not self._is_worth_a_walk(step, results[-1]):
                self._tell_of_what_was_said(step, results)
                break
            self._walked_for = results[-1]
            self._walked.add(self._carries(step.command))
            steps = list(looked_for(self._commands, step.said, self._known(), self._who))
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
        command = step.command
        if not isinstance(command, Bringing) or command.count != 1 or not self._walks():
            return False
        carries = self._carries(command)
        if carries in self._walked or (step.is_reached and not carries):
            return False
        known = self._known()
        if result.outcome != "failed" or result.failure is None or known.rooms:
            return False
        if result.failure.is_unseen:
            return result.attempts <= 1 and _may_be_elsewhere(command, known)
        if result.failure.is_no_grasp and _is_far(command.object, known):
            return True
        if result.failure.root.kind is not FailureKind.INFEASIBLE or not isinstance(command, PlaceTask):
            return False  # and what no hand could take is brought nowhere
        meant = self._settled(command)
        return carries and isinstance(meant, PlaceTask) and _is_far(meant.on or meant.to, known)

    def _carries(self, command: Command) -> bool:
        """Whether something is in a hand by now and only has to go somewhere."""
        return isinstance(command, PlaceTask) and self._known().in_hand(command)

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
        known = self._known()
        held = step.unless_held is not None and known.in_hand(step.unless_held)
        near = step.unless_near is not None and known.is_near(step.unless_near)
        return held or near or (step.unless_open and known.is_open)

    def _known(self) -> Known:
        toolbox = self._session.toolbox
        opening = door_opening_rad(toolbox.world.scene)
        return Known(
            self._in_view,
            lambda task: isinstance(held_object(toolbox, task.object, task.hand), HeldObject),
            opening is not None and opening >= LEAST_OPEN_RAD,
            self._is_near,
            frozenset(toolbox.places),
            self._stood_on,
            is_away(body_pose(toolbox)),
            isinstance(inside_of_drawer(toolbox.world.scene), DrawerInside),
        )

    def _is_near(self, wanted: Nearness) -> bool:
        toolbox = self._session.toolbox
        wanted = replace(wanted, thing=named_other(wanted.thing, self._around()))
        return is_near(wanted, toolbox.world.scene, self._base(), toolbox.policy.support_gap_m)

    def _stood_on(self, task: PlaceTask) -> str | None:
        """What the object of a task stood on before it came into a hand."""
        held = held_object(self._session.toolbox, task.object, task.hand)
        origins = self._session.toolbox.world.taken_from
        return origins[held.name].support if isinstance(held, HeldObject) and held.name in origins else None

    def _in_view(self, pick: PickTask) -> bool:
        """Whether the object of a pick is believed to be where it is said to be."""
        if isinstance(pick.object, ObjectOf) or isinstance(pick.source, ObjectOf):
            return False
        return isinstance(ground(pick.object, self._around(), pick.source, pick.count), Found)

    def _walks(self) -> bool:
        return self._session.toolbox.can_walk

    # --- one task, with its questions -----------------------------------------------------------

    def _task(self, command: Command | Failure) -> Generator[OpenQuestion | None, str | None, TaskResult]:
        if isinstance(command, Failure):
            return TaskResult(self._commands[-1].text, self._commands[-1].action, "failed", failure=command)
        times, attempts = TaskTimes(), 0
        command = self._settled(command)
        while True:
            result = yield from _silent(self._session.task_steps(command, self._timeout_s))
            times, attempts = _sum(times, result.times), attempts + result.attempts
            result = replace(result, times=times, attempts=attempts)
            if result.outcome != "question" or result.failure is None:
                return result
            answered = yield from answered_command(
                self._session, command, result.failure, self._on_question, self._around
            )
            if answered is None:
                return result
            if isinstance(answered, Failure):
                return replace(result, outcome="cancelled", failure=answered)
            command = answered
            if (walk := self._walk_there(command, result.failure)) is not None:
                walked = yield from _silent(self._session.task_steps(walk, self._timeout_s))
                times = _sum(times, walked.times)
                if walked.outcome != "done":
                    return replace(result, outcome=walked.outcome, failure=walked.failure)

    def _settled(self, command: Command) -> Command:
        leaves = self._stood_on(command) if isinstance(command, PlaceTask) else None
        return settled(command, self._around(), leaves)

    def _walk_there(self, command: Command, asked: Failure) -> WalkToTask | None:
        """The walk to the furniture in a room that something goes onto, if the robot is not before it."""
        if not isinstance(command, PlaceTask) or asked.choice_slot != "on" or not self._walks():
            return None
        if command.to not in self._session.toolbox.places or not isinstance(command.on, ObjectDescription):
            return None
        near = self._known().is_near(Nearness(command.on))
        return None if near else WalkToTask(f"walk to the {command.on}", command.on)

    def _around(self) -> Surroundings:
        toolbox = self._session.toolbox
        world = toolbox.world
        gap_m = toolbox.policy.support_gap_m
        return surroundings(world.scene, self._base(), gap_m, world.last_acted_on, world.asked_at)

    def _base(self) -> Transform:
        q = self._session.toolbox.sensing.state().q
        return poses.transform(poses.rotation_from_quaternion(q[3:7]), q[:3])

    # --- before anything moves ------------------------------------------------------------------

    def _refused(self) -> TaskResult | None:
        """What is no skill, or cannot be, is found out before the first task begins: nothing is half done."""
        command = without_skill(self._commands)
        if command is not None:
            message = str(NoSkillError(command))
            self._session.tell(TaskRefused(self._session.now_s, command.text, message, None))
            failure = Failure(FailureKind.REFUSED, message)
            return TaskResult(command.text, command.action, "refused", failure=failure)
        why = impossible(self._commands, self._session.toolbox.places)
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


def _may_be_elsewhere(command: Bringing, known: Known) -> bool:
    """Whether what is not in view may be anywhere but on what the robot stands before."""
    source = command.source
    return not (isinstance(source, str) and known.is_near(Nearness(ObjectDescription(source))))


def _is_far(place: Destination | Thing | None, known: Known) -> bool:
    """Whether a thing, or furniture, is where no hand gets to without a step."""
    if isinstance(place, str):
        return not known.is_near(Nearness(ObjectDescription(place)))
    if not isinstance(place, ObjectDescription) or place.kind is None:
        return False
    return not known.is_near(Nearness(place))


def without_skill(commands: Sequence[Command]) -> Task | None:
    """The first command that nothing here can carry out, or None."""
    for command in commands:
        if not isinstance(command, StopCommand) and not has_skill(command):
            return command
    return None


def drive(steps: Steps, attendant: Attendant, session: Session) -> tuple[TaskResult, ...]:
    """Let an errand go on to its end, with somebody who answers its questions and may stop it."""
    answer: str | None = None
    while True:
        try:
            question = steps.send(answer)
        except StopIteration as end:
            results: tuple[TaskResult, ...] = end.value
            return results
        answer = None
        if question is None:
            attendant.attend(session)
        else:
            answer = attendant.answer(question)


def _silent(
    steps: Generator[None, None, TaskResult],
) -> Generator[OpenQuestion | None, str | None, TaskResult]:
    """Pass ticks on; what is sent in between is for nobody."""
    while True:
        try:
            next(steps)
        except StopIteration as end:
            result: TaskResult = end.value
            return result
        yield None


def _sum(a: TaskTimes, b: TaskTimes) -> TaskTimes:
    return TaskTimes(
        a.planning_wall_s + b.planning_wall_s, a.simulated_s + b.simulated_s, a.wall_s + b.wall_s
    )
