"""What a sentence or a script would do: understand, look, plan and check, without moving the robot."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

from executive.checks.run_apart import carried_out_apart
from executive.config import leave_opengl_to_the_renderer
from executive.dialogue.attendant import Nobody
from executive.dialogue.settle_words import settled, without_skill
from executive.errands.impossible import no_such_hand
from executive.exit_codes import ExitCode
from executive.meaning import StopCommand, wording
from executive.references import references
from executive.reports.check_report import CheckReport, MotionVerdict, Outcome
from executive.runs.run_request import DEFAULT_ROBOT
from executive.scripts.task_script import script_for
from executive.session.task_result import TaskResult, chain
from executive.trust import USUAL_TRUST, OnQuestion, Trust
from executive.understanding.statement import Statement
from kinematics.motion.verdict import CheckedTrajectory, Unsafe
from kinematics.requests.check import CheckRequest
from kinematics.requests.pick import PickPlan
from kinematics.requests.request import Request
from robots.clock import WallClock
from robots.models.description import load_robot_for_tasks
from robots.models.usual_scene import usual_scene
from robots.scenes.scene_description import SceneDescription
from robots.scenes.scene_file import load_scene
from trees.beliefs.grounding.report_words import kinds_in
from trees.build import NoSkillError
from trees.failures import Failure, FailureKind
from trees.policy import Gaze, TreePolicy
from trees.skills.pick.tree import build_dry_run
from trees.tasks import GoHomeTask, PickTask, Task
from trees.toolbox import Job, Planned, Planning, Toolbox

if TYPE_CHECKING:
    from executive.front.front_model import FrontModel
    from trees.task_tree import TaskTree

_LOOK_EVERY_S = 0.02


def rehearse(
    text: str,
    robot: str | None,
    scene: str | None,
    seed: int | None,
    trust: Trust = USUAL_TRUST,
    on_question: OnQuestion = "ask",
    front: FrontModel | None = None,
) -> CheckReport:
    """Say what a sentence or a script would do.

    A pick alone is judged from the home posture with the head already turned to where a run would look, and
    nothing moves; a run would lean over as well. Anything else is carried out in a world of its own, as a run
    with the same seed would be.

    Args:
        text: A sentence, or the path of a task script.
        robot: Name of the robot.
        scene: Name of a scene, or path of a scene file.
        seed: Of everything random. What is left out is the script's, else the usual.
        trust: How far a model's output is trusted.
        on_question: Whether the first choice is taken where a question is open; else it is told.
        front: The language model in front, or None. What it makes of a sentence is told as the question that
            a run would put, and judged where a run would not ask.

    Raises:
        UserError: The script cannot be one.
        RobotsError: There is no such robot or scene.
    """
    script = script_for(text, trust, scene, robot)
    robot = robot or script.robot or DEFAULT_ROBOT
    scene = scene or script.scene or usual_scene(robot)
    seed = next(value for value in (seed, script.seed, 0) if value is not None)
    world = load_scene(scene)
    statements = script.statements if front is None else _proposed(front, script.statements)
    if on_question == "first":
        settled_ones = (settled(one, Nobody(), on_question, lambda _event: None) for one in statements)
        statements = tuple(one for one in settled_ones if isinstance(one, Statement))  # nobody cancels
    for one in statements:
        lacking = without_skill(one.parsed.commands)
        if lacking is not None and one.expect != "refused":
            message = f"refused: {NoSkillError(lacking)}"
            return CheckReport(text, robot, scene, "refused", ExitCode.INVALID, message)
        if one.parsed.outcome not in ("tasks", one.expect):
            outcome, code, message = _not_understood(one)
            return CheckReport(text, robot, scene, outcome, code, message)
    commands = [command for one in statements for command in one.parsed.commands]
    if all(isinstance(command, StopCommand | GoHomeTask) for command in commands):
        still = [
            f"{wording(command)}: at home, with nothing under way, nothing moves" for command in commands
        ]
        return CheckReport(text, robot, scene, "safe", ExitCode.DONE, "safe: no motion is needed", still)
    if len(commands) == 1 and isinstance(commands[0], PickTask) and not references(commands[0]):
        if (without := no_such_hand(commands[0], load_robot_for_tasks(robot).description)) is not None:
            why = Failure.infeasible(without.message)
            line = f"failed: {why.message} [{why.kind.value}]"
            return CheckReport(text, robot, scene, "failed", ExitCode.FAILED, line, failure=why.to_json())
        return _looked_at(text, robot, scene, _Rehearsal(robot, world, seed), commands[0], statements)
    done = carried_out_apart(robot, world, seed, statements, on_question)
    notes = ["carried out in a simulated world of its own", *done.notes()]
    if done.exit_code is ExitCode.DONE:
        message = f"safe: {len(done.motions)} motions planned and checked; {done.line}"
        return CheckReport(text, robot, scene, "safe", ExitCode.DONE, message, notes, done.motions)
    outcome = _outcome(done.last)
    failure = None if done.last.failure is None else done.last.failure.to_json()
    return CheckReport(text, robot, scene, outcome, done.exit_code, done.line, notes, done.motions, failure)


def _proposed(front: FrontModel, statements: Sequence[Statement]) -> tuple[Statement, ...]:
    """What a model makes of those statements that are for it; nobody says yes to what it reads back."""
    from executive.front.front_talk import FrontTalk

    wall = WallClock()

    def waiting() -> bool:
        wall.sleep(_LOOK_EVERY_S)
        return False

    talk = FrontTalk(front, Nobody().answer, lambda _event: None, waiting)
    settled_ones = (talk.settled(one) if talk.takes(one) else one for one in statements)
    return tuple(one for one in settled_ones if isinstance(one, Statement))  # nobody cancels


def _looked_at(
    text: str, robot: str, scene: str, rehearsal: _Rehearsal, pick: PickTask, statements: Sequence[Statement]
) -> CheckReport:
    """A pick alone: nothing has to move for a look, a plan and a check."""
    result = rehearsal.of(pick)
    notes, motions = rehearsal.notes, rehearsal.motions
    if result.outcome in ("done", *(one.expect for one in statements)):
        planned = f"safe: {len(motions)} motions planned and checked"
        return CheckReport(text, robot, scene, "safe", ExitCode.DONE, planned, notes, motions)
    outcome, message = _verdict(result)
    failure = None if result.failure is None else result.failure.to_json()
    return CheckReport(text, robot, scene, outcome, result.exit_code, message, notes, motions, failure)


def _outcome(result: TaskResult) -> Outcome:
    """What a check calls the result of a run."""
    if result.outcome == "refused" or result.outcome == "question":
        return result.outcome
    unsafe = result.failure is not None and chain(result.failure)[-1].kind is FailureKind.UNSAFE
    return "unsafe" if unsafe else "failed"


def _not_understood(one: Statement) -> tuple[Outcome, ExitCode, str]:
    if one.parsed.question is not None:
        return "question", ExitCode.QUESTION, f"question: {one.parsed.question.text}"
    return "refused", ExitCode.INVALID, f"refused: {one.parsed.refusal}"


def _verdict(result: TaskResult) -> tuple[Outcome, str]:
    """The outcome in the words of a check, and the last line."""
    root = chain(result.failure)[-1]
    if result.outcome == "question" and result.failure is not None:
        return "question", f"question: {root.message}: {' or '.join(result.failure.choices)}"
    if root.kind is FailureKind.UNSAFE:
        return "unsafe", root.message
    hint = "; a run would lean over as well" if root.kind is FailureKind.POSTCONDITION else ""
    return "failed", f"failed: {root.message}{hint} [{root.kind.value}]"


@dataclass(slots=True)
class _Listening:
    """Passes requests and checks on to the planning service, and remembers their jobs."""

    planning: Planning
    plans: list[Job[object]] = field(default_factory=list)
    checks: list[tuple[CheckRequest, Job[CheckedTrajectory | Unsafe]]] = field(default_factory=list)

    def submit(self, request: Request[Planned]) -> Job[Planned]:
        job = self.planning.submit(request)
        self.plans.append(job)
        return job

    def check(self, question: CheckRequest) -> Job[CheckedTrajectory | Unsafe]:
        job = self.planning.check(question)
        self.checks.append((question, job))
        return job


class _Motionless:
    """A motion control that tells where the robot stands and starts nothing."""

    def __init__(self, toolbox: Toolbox) -> None:
        self.reference, self.stance = toolbox.motion.reference, toolbox.motion.stance

    def start(self, _motion: Any) -> Any:
        raise RuntimeError("a rehearsal moves nothing")

    def cancel(self, _handle: Any, _reason: str) -> None:
        raise RuntimeError("a rehearsal moves nothing")


class _Rehearsal:
    """One command, tried out in worlds of its own.

    Attributes:
        notes: What was seen and chosen.
        motions: What was planned and judged.
    """

    def __init__(self, robot: str, scene: SceneDescription, seed: int) -> None:
        self._place = robot, scene, seed
        self.notes: list[str] = []
        self.motions: list[MotionVerdict] = []

    def of(self, command: PickTask) -> TaskResult:
        """Rehearse a command, with one gaze after the other until what it is about is seen."""
        leave_opengl_to_the_renderer()
        self.notes.append(wording(command))
        camera = load_robot_for_tasks(self._place[0]).description.camera
        gazes = [gaze for gaze in TreePolicy().search_gazes if gaze.lean_rad == 0.0]
        for gaze in gazes[:1] if camera.fixed else gazes:
            result = self._look(command, gaze, camera.aimed(gaze.pan_rad, gaze.tilt_rad))
            if result.outcome == "done" or chain(result.failure)[-1].kind is not FailureKind.POSTCONDITION:
                break
        return result

    def _look(self, command: PickTask, gaze: Gaze, posture: Mapping[str, float]) -> TaskResult:
        from executive.session.assembly import assemble

        session = assemble(*self._place, build=self._build, posture=posture).session
        result = session.run_task(command)
        seen = kinds_in(self._toolbox.world.scene.objects)
        self.notes.append(f"  looking {gaze.name}, seen: {seen}")
        listening = self._listening
        plans = [job.result() for job in listening.plans if job.done]
        checks = [(question, job.result()) for question, job in listening.checks if job.done]
        for plan in plans:
            if isinstance(plan, PickPlan):
                grasp = plan.grasp
                self.notes.append(
                    f"  first plan: {grasp.hand} hand, {grasp.label}, {plan.considered} grasps considered"
                )
        names = iter(("reach", "approach", "lift"))
        for question, verdict in checks:
            name = f"{wording(command)}: {next(names)}"
            self.motions.append(MotionVerdict(name, question.trajectory, verdict))
        return result

    def _build(self, task: Task, toolbox: Toolbox) -> TaskTree:
        self._listening = _Listening(toolbox.planning)
        self._toolbox = replace(toolbox, planning=self._listening, motion=_Motionless(toolbox))
        return build_dry_run(task, self._toolbox)
