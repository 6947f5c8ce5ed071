"""A served robot as a door sees it: tasks that are begun, watched, answered and cancelled, and the stop.

Whatever a door is asked by its own world becomes one of these calls. None of them resets an emergency stop;
that is a person's to do.
"""

from __future__ import annotations

import json
import threading
from collections import deque
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from executive.live.caller.caller import Caller, NoAnswerError, ask_at
from executive.live.caller.hang_watch import HungError, commander_of, hear_out
from executive.live.caller.sendable import (
    NotSendableError,
    printable,
    require_served_as,
    script_lines,
    sendable,
)
from executive.live.desk_messages import (
    Answer,
    Cancel,
    GetScene,
    PauseTask,
    ResumeTask,
    Say,
    ScriptLine,
    write_desk_message,
)
from executive.scripts.task_script import load_script
from robots.live.wire.messages import GetStatus, Stop, write_control_message
from robots.live.wire.runtime_folder import RuntimeFolder

MOST_LINES = 500
"""Lines of feedback that are kept of one task, the newest."""
_MOST_RUNS = 20
"""Tasks that are kept, the newest; one that has not ended is kept as well."""
RESET_IS_A_PERSONS = (
    "an emergency stop is left by a person at the robot alone: `executive reset` in a terminal there"
)


@dataclass(frozen=True, slots=True)
class TaskStatus:
    """How a task stands.

    Attributes:
        run: Its id.
        text: What was asked.
        outcome: "running", "question", or how it ended: "done", "failed", "refused", "cancelled",
            "question" with ``ended``.
        ended: Whether it has ended.
        message: The newest line of feedback; at the end the line with the result.
        question: The open question, with its text, its choices, and what was wrong with the answer before; or
            None.
        lines: Feedback so far, the oldest first.
        report: The run's report, once it has ended and was recorded; see docs/reference/report.md.
        tree: The nodes of the tree under way, each with its depth, name, status and message.
    """

    run: str
    text: str
    outcome: str
    ended: bool
    message: str
    question: Mapping[str, Any] | None = None
    lines: tuple[str, ...] = ()
    report: Mapping[str, Any] = field(default_factory=dict)
    tree: Sequence[Mapping[str, Any]] = ()


class Run:
    """A task that this door has begun; a thread of its own hears what becomes of it."""

    def __init__(self, where: RuntimeFolder, name: str, text: str, order: Sequence[Say | ScriptLine]) -> None:
        """Give a sentence, or the lines of a script, to the robot.

        Raises:
            NotServedError: No robot is served there.
        """
        self.name, self.text = name, text
        self._where = where
        self._lock = threading.Lock()
        self._changed = threading.Condition(self._lock)
        self._lines: deque[str] = deque(maxlen=MOST_LINES)
        self._kept_from = 0
        self._told = 0
        self._question: Mapping[str, Any] | None = None
        self._result: Mapping[str, Any] | None = None
        self._caller = Caller(where.executive_socket)
        for said in order:
            self._caller.send(write_desk_message(said))
        threading.Thread(target=self._hear, name=f"task {name}", daemon=True).start()

    @property
    def ended(self) -> bool:
        """Whether it has ended."""
        return self._result is not None

    def status(self) -> TaskStatus:
        """How it stands, without the tree."""
        with self._lock:
            result, question, lines = self._result, self._question, tuple(self._lines)
        newest = lines[-1] if lines else "accepted"
        if result is None:
            outcome = "running" if question is None else "question"
            return TaskStatus(self.name, self.text, outcome, False, newest, question, lines)
        report = _report_in(str(result.get("run", "")))
        outcome, message = str(result["outcome"]), str(result["text"])
        return TaskStatus(self.name, self.text, outcome, True, message, None, lines, report)

    def news(self, seen: int) -> tuple[tuple[str, ...], int]:
        """Lines of feedback since so many were read, the result's among them, and how many there are now."""
        with self._lock:
            first = self._kept_from
            lines = tuple(self._lines)[max(seen - first, 0) :]
            count = first + len(self._lines)
            if self._result is not None and seen <= count:
                return (*lines, str(self._result["text"])), count + 1
            return lines, max(seen, count)

    def wait(self, seen: int, within_s: float) -> int:
        """Wait until there is more news than were seen before, or some wall time has passed.

        Args:
            seen: What the call before answered; 0 at first.
            within_s: How long.

        Returns:
            How much news there is.
        """
        with self._changed:
            self._changed.wait_for(lambda: self._told > seen, within_s)
            return self._told

    def answered(self, question: Mapping[str, Any] | None) -> None:
        """A question of it was answered; one that has come since stays open."""
        with self._lock:
            if self._question is question:
                self._question = None

    def _hear(self) -> None:
        try:
            hear_out(self._caller, self._take, lambda: commander_of(self._where))
        except HungError as hung:
            self._end(f"failed: {hung}")
        except NoAnswerError:
            self._end("failed: the executive ended before it told the result; what moved is braked")
        finally:
            self._caller.close()

    def _take(self, answer: dict[str, Any]) -> bool:
        if answer["type"] == "error":
            self._end(f"refused: {answer['reason']}", "refused")
            return True
        with self._changed:
            match answer["type"]:
                case "line":
                    self._kept_from += len(self._lines) == MOST_LINES
                    self._lines.append(str(answer["text"]))
                case "question":
                    self._question = {
                        key: answer[key]
                        for key in ("text", "choices", "tried")
                        if answer.get(key) or key == "choices"
                    }
                case "result":
                    self._result, self._question = answer, None
            self._told += 1
            self._changed.notify_all()
            return self._result is not None

    def _end(self, line: str, outcome: str = "failed") -> None:
        with self._changed:
            self._result, self._question = {"text": line, "outcome": outcome}, None
            self._told += 1
            self._changed.notify_all()


class ServedRobot:
    """A served robot, from the side of a door.

    Args:
        folder: Where it is served.
    """

    def __init__(self, folder: Path) -> None:
        self._where = RuntimeFolder(folder)
        self._runs: dict[str, Run] = {}
        self._begun = 0
        self._lock = threading.Lock()

    def begin(self, text: str) -> Run:
        """Begin a task; what becomes of it, be it a refusal, its status tells.

        Raises:
            NotServedError: No robot is served there.
            NotSendableError: The text is empty, or holds what no sentence may hold.
        """
        if not text.strip():
            raise NotSendableError("refused: nothing was said; say a command, such as 'wave'")
        return self._begin(text, [Say(sendable(text))])

    def begin_script(self, path: str) -> Run:
        """Begin a task script, for a door whose callers may name files of this machine.

        Raises:
            NotServedError: No robot is served there.
            UserError: The script is none, or for another robot.
        """
        script = load_script(Path(path))
        lines = script_lines(Path(path), script)
        served = ask_at(self._where.control_socket, write_control_message(GetStatus()))
        require_served_as(Path(path), script, served)
        return self._begin(path, lines)

    def _begin(self, text: str, order: Sequence[Say | ScriptLine]) -> Run:
        with self._lock:
            self._begun += 1
            name = f"run-{self._begun}"
        run = Run(self._where, name, text, order)
        with self._lock:
            kept = [*self._runs.values(), run]
            old, new = kept[:-_MOST_RUNS], kept[-_MOST_RUNS:]
            self._runs = {one.name: one for one in (*(one for one in old if not one.ended), *new)}
        return run

    def run(self, name: str | None = None) -> Run | None:
        """A task of this door: by its id, or the last one; None where there is none."""
        if name is None:
            return next(reversed(self._runs.values()), None)
        return self._runs.get(name)

    def status(self) -> dict[str, Any]:
        """How robot and executive stand.

        Raises:
            LiveError: No robot is served there, or it does not answer.
        """
        control = ask_at(self._where.control_socket, write_control_message(GetStatus()))
        desk = ask_at(self._where.executive_socket, write_desk_message(GetStatus()))
        return {**control, **desk}

    def scene(self) -> list[dict[str, Any]]:
        """What the robot believes to be around it; as ``status``."""
        answer = ask_at(self._where.executive_socket, write_desk_message(GetScene()))
        return list(answer["things"])

    def answer(self, text: str) -> bool:
        """Answer the question that is open; False when none is."""
        message = write_desk_message(Answer(sendable(text)))
        open_ones = [(run, run.status().question) for run in self._runs.values() if not run.ended]
        asked = bool(ask_at(self._where.executive_socket, message)["asked"])
        if asked:
            for run, question in open_ones:
                run.answered(question)
        return asked

    def cancel(self, reason: str) -> bool:
        """Halt what is under way and hold; False when nothing is. No reason is too odd to halt."""
        answer = ask_at(self._where.executive_socket, write_desk_message(Cancel(printable(reason))))
        return bool(answer["under_way"])

    def pause(self, reason: str) -> bool:
        """Hold what is under way where it is, in balance; False when nothing is."""
        answer = ask_at(self._where.executive_socket, write_desk_message(PauseTask(sendable(reason))))
        return bool(answer["under_way"])

    def resume(self) -> bool:
        """Go on with what was paused; False when nothing was."""
        return bool(ask_at(self._where.executive_socket, write_desk_message(ResumeTask()))["paused"])

    def stop(self, reason: str, category: int = 1) -> None:
        """The emergency stop, past the executive; it latches until a person resets it."""
        ask_at(self._where.control_socket, write_control_message(Stop(category, printable(reason))))


def _report_in(folder: str) -> Mapping[str, Any]:
    """The report of a recorded run; empty where there is none."""
    try:
        report: Mapping[str, Any] = json.loads((Path(folder) / "report.json").read_text("utf-8"))
    except (OSError, ValueError):
        return {}
    return report if folder else {}
