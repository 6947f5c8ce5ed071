"""What is told to people: one line for each event worth telling, and the line at the end."""

from __future__ import annotations

from collections.abc import Sequence

from executive.reports.meaning_words import meaning_words
from executive.session.events import (
    Event,
    InputTaken,
    PlanningAnswered,
    QuestionAsked,
    SensorsNoted,
    TaskAccepted,
    TaskEnded,
    TaskRefused,
)
from executive.session.lifecycle import LifecycleChanged
from executive.session.task_result import TaskResult, chain
from robots.control.events import (
    EmergencyReset,
    EmergencyStopped,
    HealthChanged,
    MotionEnded,
    MotionPaused,
    MotionResumed,
    MotionStarted,
    ResetRefused,
    SetpointRefused,
    StopStarted,
)
from trees.events import LeafFailed, Measured, NodeChanged, NotSo, Offered, Said, ThingPictured
from trees.failures import Failure, Number
from trees.registry import skill_called
from trees.skill import as_asked

_UNITS = (
    ("_rad_s", "rad/s"),
    ("_m_s", "m/s"),
    ("_rad", "rad"),
    ("_nm", "Nm"),
    ("_mm", "mm"),
    ("_m", "m"),
    ("_s", "s"),
    ("_kg", "kg"),
    ("_n", "N"),
)


def line_for(event: Event) -> str | None:
    """What an event tells to people, or None when it is only for the log."""
    match event:
        case TaskAccepted():
            return f"accepted: {meaning_words(event.meaning)}"
        case TaskRefused():
            return f"refused: {event.message}"
        case QuestionAsked(choices=choices):
            return f"question: {event.question}" + (f": {_either(choices)}" if choices else "")
        case InputTaken(what="answer", value=answer):
            return f"answer: {answer}" if answer else "nobody answered"
        case InputTaken():
            return None
        case NodeChanged(status="running") if event.where:
            return f"EXECUTING: {event.where}"
        case LeafFailed(failure=failure) if failure.choices:
            return None  # the question is told
        case NotSo(failure=failure):
            return failure.root.message
        case LeafFailed():
            return f"failed: {sentence(event.failure)}"
        case Said():
            return f"says{' to ' + event.to if event.to else ''}: {event.text}"
        case ThingPictured(what=what):
            return f"a picture of what may be the {what} is kept in the run's folder"
        case Offered(what=what, to=person):
            return f"holds the {what} out to {person}"
        case SetpointRefused():
            numbers = f"{event.value:.4g}, limit {event.bound:.4g}"
            return f"refused setpoint of {event.owner}: {event.joint} {event.limit} {numbers}"
        case MotionPaused():
            return f"paused: {event.reason}"
        case MotionResumed():
            return "going on"
        case StopStarted():
            return f"stop category {event.category}: {event.reason}"
        case HealthChanged():
            state = f"{event.value:.3g}, bound {event.bound:.3g}" if event.present else "over"
            return f"health: {event.ailment}: {event.part} ({state})"
        case LifecycleChanged():
            return f"state {event.before} → {event.after}: {event.reason}"
        case EmergencyStopped():
            return f"emergency stop: {event.reason}; a person's reset is needed"
        case EmergencyReset():
            return f"emergency stop left by {event.person}"
        case ResetRefused():
            return f"reset refused: {event.reason}"
        case MotionEnded(status="canceled", reason=reason) if reason:
            return f"motion stopped: {reason}"
        case MotionEnded(reason=reason) if reason:
            return f"motion {event.motion} {event.status}: {reason}"
        case NodeChanged() | Measured() | MotionStarted() | MotionEnded():
            return None
        case TaskEnded() | PlanningAnswered() | SensorsNoted():
            return None


def sentence(failure: Failure) -> str:
    """One link of a failure chain as a sentence with its numbers and place."""
    numbers = ", ".join(quantity(key, value) for key, value in failure.numbers.items())
    place = f" [{failure.kind.value}{' at ' + failure.where if failure.where else ''}]"
    return failure.message + (f" ({numbers})" if numbers else "") + place


def quantity(key: str, value: Number) -> str:
    """A named number as people read it: "gripper opening 61 mm"."""
    for suffix, unit in _UNITS:
        if key.endswith(suffix) and isinstance(value, (int, float)) and not isinstance(value, bool):
            name = key.removesuffix(suffix).replace("_", " ")
            if unit == "m" and abs(value) < 0.1:
                return f"{name} {value * 1000.0:.1f} mm"
            return f"{name} {_plain(value)} {unit}"
    name = key.replace("_", " ")
    return f"{name} {value:.4g}" if isinstance(value, float) else f"{name} {value}"


def _plain(value: float) -> str:
    """Three digits, and nothing is never less than nothing."""
    text = f"{value:.3g}"
    return "0" if text == "-0" else text


def failure_lines(failure: Failure | None) -> list[str]:
    """A failure chain, the top first, each cause indented below what it caused."""
    return [
        f"{'   ' * (depth - 1) + '└─ ' if depth else ''}{sentence(link)}"
        for depth, link in enumerate(chain(failure))
    ]


def result_line_of_all(results: Sequence[TaskResult]) -> str:
    """The last line of several tasks, one after the other: all claims, or how the last one failed.

    What failed first and was done in the end after all is told as what it became.
    """
    if results[-1].outcome != "done":
        return result_line(results[-1])
    done = [result for result in results if result.outcome == "done"]
    return f"done: {'; then '.join(map(_claim, done))}{_times(results)}"


def _times(results: Sequence[TaskResult]) -> str:
    simulated_s = sum(result.times.simulated_s for result in results)
    wall_s = sum(result.times.wall_s for result in results)
    return f" ({simulated_s:.1f} s simulated, {wall_s:.1f} s wall)"


def result_line(result: TaskResult) -> str:
    """The last line: what happened, from the robot's own sensors."""
    times = _times([result])
    if result.outcome == "done":
        return f"done: {_claim(result)}{times}"
    links = chain(result.failure)
    if not links:
        return f"{result.outcome}: {result.text}{times}"
    if result.outcome == "question" and result.failure is not None:
        return f"question: {links[-1].message}: {_either(result.failure.choices)}{times}"
    reason = links[0].message
    if links[-1] is not links[0] and links[-1].message not in reason:
        reason += f", because {links[-1].message}"
    return f"{result.outcome}: {reason} [{links[-1].kind.value}]{times}"


def _either(choices: Sequence[str]) -> str:
    """Join words with commas and a last "or"."""
    return f"{', '.join(choices[:-1])} or {choices[-1]}" if len(choices) > 1 else "".join(choices)


def _claim(result: TaskResult) -> str:
    if result.action == "stop":
        return "nothing was under way; holding"
    skill = skill_called(result.action)
    claim = as_asked if skill is None else skill.claim
    return claim(result.text, result.subject, result.evidence)
