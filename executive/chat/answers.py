"""What the robot says in a conversation: what became of a task, why, what it knows of, how it stands."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from executive.chat.robot_watch import RobotStanding
from executive.doors.served_robot import TaskStatus
from executive.exit_codes import ExitCode
from executive.reports.explanation import explained
from executive.runs.recorded_failure import failure_from
from executive.screens.rows import Style, running_step
from trees.failures import Failure

HELP = (
    "Say what to do: 'pick up the red cup on the table', 'walk to the kitchen and open the fridge'.",
    "Ask: 'what do you see', 'why', 'status'. `executive list skills` tells all that I can do.",
    "While I work: 'stop' is the emergency stop, which latches; 'cancel' ends the task; 'pause' and 'go on'.",
    "A question is answered by its number, in words, or with 'never mind'. 'quit' ends the chat.",
)
_WHY_TELLS, _HELP_TELLS = "('why' tells more)", "('help' tells what can be said)"
_STAMP = re.compile(r"^\[ *[\d.]+ s\] ")
_TIMES = re.compile(r" \(-?[\d.]+ s simulated, [\d.]+ s wall\)")
_KIND = re.compile(r" \[[A-Z]+\]")
_SPOKEN = (
    ("accepted: ", "I understood: "),
    ("says: ", ""),
    ("says to ", "to "),
    ("holds the ", "I hold the "),
)
"""Lines of feedback that belong into the conversation, by how they begin, and how that is said there."""
_STYLES: Mapping[str, Style] = {"done": "ok", "failed": "bad", "refused": "bad", "cancelled": "ask"}
_CODES = {
    "done": ExitCode.DONE,
    "refused": ExitCode.INVALID,
    "question": ExitCode.QUESTION,
    "cancelled": ExitCode.CANCELLED,
}
_MOST_THINGS = 12


def spoken(line: str) -> str | None:
    """What of a line of feedback the robot says in the conversation; None where it is for the log."""
    told = _STAMP.sub("", line)
    for begin, said in _SPOKEN:
        rest = told.removeprefix(begin)
        if rest != told:
            return f"{said}{rest}" if " " in rest else None  # "describe" tells nothing that was not said
    return None


def is_feedback(line: str) -> bool:
    """Whether a line tells what goes on; questions come in lines as well, but are put in the conversation."""
    return _STAMP.match(line) is not None


def what_became(status: TaskStatus, spoken_last: str = "") -> tuple[str, Style]:
    """One sentence about a task that has ended, and what it is like.

    Args:
        status: How it ended.
        spoken_last: What the robot said last; that is not said again.
    """
    told = _KIND.sub("", _TIMES.sub("", status.message))
    outcome, _, rest = told.partition(": ")
    if status.outcome == "question":
        outcome = "not done, for nobody answered"
    plain = f"{outcome.capitalize()}: {rest}" if rest and rest != spoken_last else outcome.capitalize()
    return f"{plain.rstrip('.')}.{_more(status)}", _STYLES.get(status.outcome, "ask")


def _more(status: TaskStatus) -> str:
    """What can be asked after a task that did not end well."""
    if status.outcome in ("done", "question"):
        return ""
    if failures_of(status):
        return f" {_WHY_TELLS}"
    return f" {_HELP_TELLS}" if status.outcome == "refused" else ""


def code_of(status: TaskStatus) -> ExitCode:
    """The exit code of a task that has ended."""
    code = status.report.get("exit_code")
    return _CODES.get(status.outcome, ExitCode.FAILED) if code is None else ExitCode(int(code))


def failures_of(status: TaskStatus) -> list[tuple[str, Failure]]:
    """Tasks that did not end well, with their failures, as the run's report holds them."""
    tasks = status.report.get("tasks", ())
    return [
        (str(one.get("text", "")), failure_from(one["failure"]))
        for one in tasks
        if one.get("failure") is not None
    ]


def why(status: TaskStatus | None) -> list[str]:
    """Why the last task ended as it did."""
    if status is None:
        return ["Nothing has been tried yet."]
    said = [f"The last task, {status.text!r}:", what_became(status)[0].removesuffix(_WHY_TELLS).rstrip()]
    for text, failure in failures_of(status):
        said += [f"{text!r}:"] if text != status.text else []
        said += [f"  {line}" for line in explained(failure)]
    if len(said) == 2 and status.outcome == "done":
        said.append("Nothing failed.")
    return said


def seen(things: Sequence[Mapping[str, Any]]) -> list[str]:
    """What the robot believes to be around it."""
    held = [str(one["words"]) for one in things if one.get("held")]
    around = [one for one in things if not one.get("held")]
    said = [f"I hold: {', '.join(held)}."] if held else []
    if not around:
        return [*said, "I have seen nothing yet; 'what do you see' lets me look when I am free."]
    said.append("As far as I have seen, around me:")
    said += [f"  {line}" for line in map(_thing, around[:_MOST_THINGS])]
    left_out = len(around) - _MOST_THINGS
    return [*said, f"  and {left_out} more, farther off"] if left_out > 0 else said


def _thing(one: Mapping[str, Any]) -> str:
    on = f" on the {one['on']}" if one.get("on") else ""
    if "place_m" not in one:
        return f"{one['words']}{on}"
    x, y = float(one["place_m"][0]), float(one["place_m"][1])
    side = f"{abs(y):.1f} m to the {'left' if y > 0.0 else 'right'}" if abs(y) >= 0.05 else "straight"
    along = f"{abs(x):.1f} m {'ahead' if x >= 0.0 else 'behind'}"
    return f"{one['words']}{on}: {along}, {side}"


def waiting_words(waiting: Sequence[str]) -> Iterator[str]:
    """What is told of lines that wait for their turn."""
    if waiting:
        yield f"After that: {', then '.join(map(repr, waiting))}."


def progress(text: str, now: RobotStanding) -> Iterator[str]:
    """How far a task is."""
    held = ", held in a pause" if now.paused else ""
    step = running_step(now.tree)
    yield f"I am busy with {text!r}{held}{f': {step}' if step else ''}."
