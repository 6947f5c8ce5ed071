"""What is kept of one run while it goes on, and what is told of it in the end.

A run at the command line and an order of a served robot give the same account.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from executive.exit_codes import ExitCode
from executive.meaning import shortened
from executive.reports.report import Report, SafetyTally
from executive.runs.run_log import RunLog
from executive.scripts.script_run import Said
from executive.session.events import Event, EventSink


@dataclass(frozen=True, slots=True)
class RunSubject:
    """What is asked of which robot, and where.

    Attributes:
        input: The sentence, or the script's name.
        robot: Name of the robot.
        scene: Name of a scene or path of a scene file.
        seed: Of everything random.
    """

    input: str
    robot: str
    scene: str
    seed: int

    def header(self) -> dict[str, Any]:
        """What every recorded run begins with."""
        return {
            "input": shortened(self.input),
            "text": self.input,
            "robot": self.robot,
            "scene": self.scene,
            "seed": self.seed,
        }


class RunAccount:
    """Writes the log, counts what was refused and stopped, shows what goes on, and makes the report.

    Args:
        subject: What is asked for.
        log: Of the run, open.
        others: Hear of every event as well, after the log: a display.
    """

    def __init__(self, subject: RunSubject, log: RunLog, *others: EventSink) -> None:
        self._subject, self._log = subject, log
        self._tally = SafetyTally()
        self._sinks: tuple[EventSink, ...] = (log.add, self._tally.add, *others)

    def hear(self, event: Event) -> None:
        """Take one event."""
        for sink in self._sinks:
            sink(event)

    def close(self, ending: tuple[str, str, ExitCode], results: Sequence[Said], checked: int) -> Report:
        """Make the report, and store it with the log.

        Args:
            ending: The line for people, the outcome and the exit code.
            results: Every statement that was begun, with its tasks' results.
            checked: Trajectories of the run that the checker let pass.
        """
        line, outcome, code = ending
        report = Report(
            input=self._subject.input,
            seed=self._subject.seed,
            robot=self._subject.robot,
            scene=self._subject.scene,
            outcome=outcome,
            exit_code=code,
            message=line,
            events_sha256=self._log.digest.hexdigest(),
            tasks=[result for _, results_of in results for result in results_of],
            safety=self._tally.counts(checked),
            left_out=tuple(step for statement, _ in results for step in statement.skipped),
            pictures=self._log.pictures,
        )
        self._log.finish(report.to_json())
        return report
