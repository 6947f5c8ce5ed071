"""What statements would do, told from doing it: in a simulated world of its own, which nobody else sees."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from executive.dialogue.attendant import Nobody
from executive.exit_codes import ExitCode
from executive.reports.check_report import MotionVerdict
from executive.scripts.script_run import Said, run_statements, verdict
from executive.session.task_result import TaskResult
from executive.trust import OnQuestion
from executive.understanding.statement import Statement
from kinematics.motion.verdict import CheckedTrajectory, Unsafe
from kinematics.requests.check import CheckRequest
from robots.scenes.scene_description import SceneDescription


@dataclass(frozen=True, slots=True)
class CarriedOut:
    """What commands came to when they were carried out in a world of their own.

    Attributes:
        line: The last line, as a run prints it.
        exit_code: What a run ends with.
        results: Of the statements that were begun.
        motions: What was planned, judged safe and made, in order; of what could not go on for the checker's
            refusal, the refused one at last.
    """

    line: str
    exit_code: ExitCode
    results: Sequence[Said]
    motions: Sequence[MotionVerdict]

    @property
    def last(self) -> TaskResult:
        """The result that decides: the first unexpected one, else the last."""
        unexpected = (said[-1] for one, said in self.results if said[-1].outcome != one.expect)
        return next(unexpected, self.results[-1][1][-1])

    def notes(self) -> Iterator[str]:
        """A line for each task that was begun."""
        for _, said in self.results:
            for result in said:
                yield f"{result.text}: {result.outcome} after {result.times.simulated_s:.1f} s"


def carried_out_apart(
    robot: str, scene: SceneDescription, seed: int, statements: Sequence[Statement], on_question: OnQuestion
) -> CarriedOut:
    """Carry statements out as a run with the same seed would, up to the same end.

    Args:
        robot: Name of the robot.
        scene: The world's beginning.
        seed: Of everything random.
        statements: What was said; every one may start.
        on_question: What becomes of questions; nobody answers.
    """
    from executive.session.assembly import assemble

    motions: list[MotionVerdict] = []

    def note(request: CheckRequest, answer: CheckedTrajectory | Unsafe) -> None:
        if motions and isinstance(motions[-1].answer, Unsafe):
            motions.pop()  # it was planned anew
        motions.append(MotionVerdict(f"motion {len(motions) + 1}", request.trajectory, answer))

    session = assemble(robot, scene, seed, on_judged=note).session
    results = run_statements(statements, session, Nobody(), on_question, lambda _event: None)
    line, _, code = verdict(statements, results)
    if code is ExitCode.DONE and motions and isinstance(motions[-1].answer, Unsafe):
        motions.pop()
    return CarriedOut(line, code, results, motions)
