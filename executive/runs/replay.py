"""A recorded run again: the same words, scene, seed and inputs; compared event by event.

The events of a run in lockstep are the same to the last byte on the same machine with the same versions.
Answers, cancels, emergency stops and the words of a person who jogged are given again at the simulated
instants at which they took effect.
"""

from __future__ import annotations

import json
import tempfile
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from executive.config import forget_config, use_config
from executive.dialogue.attendant import RecordedAttendant, Stoppable
from executive.errors import UserError
from executive.front.front_model import FrontModel
from executive.front.recorded import recorded_front
from executive.manual.word_text import read_word
from executive.manual.words import ENDINGS, TAKEN_OVER
from executive.robot_settings import RobotSettings, settings_from_json
from executive.runs.run import perform
from executive.runs.run_log import RecordedRun
from executive.runs.run_request import RunRequest
from executive.screens.display import Display, NoDisplay
from executive.scripts.task_script import script_for
from executive.session.cancellation import Cancellation
from executive.session.events import Event, InputTaken, canonical_line
from executive.trust import Trust
from robots.scenes.planned_fault import PlannedFault, fault_from_json

if TYPE_CHECKING:
    from executive.session.assembly import Assembly

_SHOWN = 400
"""Characters of a differing event that are shown."""


class NotReplayableError(UserError):
    """A recorded run that cannot be run again."""

    def __init__(self, name: str, reason: str) -> None:
        super().__init__(f"run {name} cannot be replayed: {reason}")


@dataclass(frozen=True, slots=True)
class Difference:
    """The first event that is not as it was recorded.

    Attributes:
        number: Of the event, from 1.
        recorded, replayed: The two events' lines; empty when there is none any more.
    """

    number: int
    recorded: str
    replayed: str


@dataclass(frozen=True, slots=True)
class ReplayVerdict:
    """What a replay found.

    Attributes:
        events: How many events were compared.
        difference: The first that differs, or None.
        cut_off: Whether the recording ends without a report: it is compared as far as it goes.
    """

    events: int
    difference: Difference | None
    cut_off: bool = False

    def lines(self) -> Iterator[str]:
        """For people."""
        if self.difference is None:
            end = " as far as the recording goes" if self.cut_off else ""
            yield f"identical: {self.events} events{end}"
            return
        yield f"event {self.difference.number} differs:"
        yield f"  recorded  {self.difference.recorded[:_SHOWN] or '(no more events)'}"
        yield f"  replayed  {self.difference.replayed[:_SHOWN] or '(no more events)'}"


class _Comparison:
    """Compares events with recorded lines, one by one."""

    def __init__(self, recorded: list[str]) -> None:
        self._recorded, self.count = recorded, 0
        self.difference: Difference | None = None

    def take(self, event: Event) -> None:
        """Compare one more."""
        if self.difference is not None:
            return
        line = canonical_line(event)
        expected = self._recorded[self.count] if self.count < len(self._recorded) else ""
        self.count += 1
        if line != expected:
            self.difference = Difference(self.count, expected, line)

    def end(self) -> None:
        """Notice what was recorded and has not come."""
        if self.difference is None and self.count < len(self._recorded):
            self.difference = Difference(self.count + 1, self._recorded[self.count], "")


class _WatchfulAttendant(RecordedAttendant):
    """Gives the recorded inputs, and ends a run that has left the recorded one."""

    def __init__(
        self, inputs: Iterable[InputTaken], cancellation: Cancellation, comparison: _Comparison, whole: bool
    ) -> None:
        super().__init__(inputs, cancellation)
        self._comparison, self._whole = comparison, whole

    def attend(self, session: Stoppable) -> None:
        """Cancel when it was cancelled, and when there is nothing left to compare."""
        super().attend(session)
        comparison = self._comparison
        if comparison.difference is not None:
            over = comparison.difference.recorded == "" and not self._whole
            session.cancel("the recording has ended" if over else "the replay differs")


def replay(
    recorded: RecordedRun,
    tell: Callable[[str], None] = lambda _line: None,
    display: Display | None = None,
    on_assembly: Callable[[Assembly], None] = lambda _assembly: None,
) -> ReplayVerdict:
    """Run a recorded run again, without moving anything but a simulated robot of its own.

    Args:
        recorded: The run.
        tell: Hears what is done.
        display: Shows what goes on; nothing does when left out.
        on_assembly: Called with the robot and its session before the first task.

    Raises:
        NotReplayableError: It was no run in lockstep, or its folder is not whole.
        UserError: The script, the scene or the machine is not good for it.
    """
    lines = _recorded_lines(recorded)
    comparison = _Comparison(lines)
    whole = bool(recorded.report)
    cancellation = Cancellation()
    inputs = list(_inputs(lines))
    _require_words(recorded, inputs)
    attendant = _WatchfulAttendant(inputs, cancellation, comparison, whole)
    tell(f"replaying {recorded.name}: {recorded.header.get('input', '')!r}, {len(lines)} events")
    with tempfile.TemporaryDirectory() as folder:
        request = _request(recorded, lines, Path(folder))
        # a signal to end is no input of the run: it ends the comparison
        perform(
            request,
            display or NoDisplay(),
            attendant,
            comparison.take,
            cancellation,
            heeds_signals=False,
            on_assembly=on_assembly,
        )
    comparison.end()
    difference = comparison.difference
    if not whole and difference is not None and difference.recorded == "":
        return ReplayVerdict(len(lines), None, cut_off=True)
    return ReplayVerdict(comparison.count, difference, cut_off=not whole)


def _require_words(recorded: RecordedRun, inputs: Iterable[InputTaken]) -> None:
    """What a person who jogged has said has to be in the record, and to be words."""
    for item in inputs:
        try:
            if item.what == "take_over" and item.value not in TAKEN_OVER:
                raise ValueError("what was said to the robot then was not recorded")
            if item.what == "hand_back" and item.value not in ENDINGS:
                raise ValueError(f"it was given back by {item.value[:20]!r}")
            if item.what == "jog":
                read_word(item.value)
        except ValueError as wrong:
            reason = f"a person jogged the robot {item.t_s:.2f} s after its beginning: {wrong}"
            raise NotReplayableError(recorded.name, reason) from wrong


def _request(recorded: RecordedRun, lines: list[str], folder: Path) -> RunRequest:
    header = recorded.header
    if header.get("live"):
        raise NotReplayableError(recorded.name, "it was carried out live, in real time")
    text, robot = header.get("text"), header.get("robot")
    if not isinstance(text, str) or not isinstance(robot, str):
        raise NotReplayableError(recorded.name, "its run.json does not say what was asked of which robot")
    trust = Trust(float(header.get("confidence", 0.8)), header.get("policy", "ask"))
    script, scene = recorded.path / "script.toml", recorded.path / "scene.toml"
    words = recorded.path / "config.toml"
    forget_config()
    use_config(words if words.is_file() else None)
    place = str(scene) if scene.is_file() else str(header.get("scene"))
    said = script_for(str(script) if script.is_file() else text, trust, place)
    return RunRequest(
        input=text,
        statements=said.statements,
        robot=robot,
        scene=place,
        seed=int(header.get("seed", 0)),
        record=folder,
        on_question=header.get("on_question", "ask"),
        trust=trust,
        faults=_faults(recorded),
        front=_front(recorded, lines, trust),
        settings=_settings(recorded),
        perception=header.get("perception"),
    )


def _front(recorded: RecordedRun, lines: list[str], trust: Trust) -> FrontModel | None:
    """The model in front, with what it answered then."""
    header = recorded.header.get("model")
    if header is None:
        return None
    try:
        return recorded_front(header, _inputs(lines), trust)
    except (TypeError, ValueError, KeyError, AttributeError) as wrong:
        raise NotReplayableError(recorded.name, f"its model: {wrong}") from wrong


def _settings(recorded: RecordedRun) -> RobotSettings:
    """What the robot said of itself, and when its day began; an older record keeps neither."""
    try:
        return settings_from_json(recorded.header.get("says_of_itself", {}))
    except (TypeError, ValueError, AttributeError) as wrong:
        raise NotReplayableError(recorded.name, f"what it says of itself: {wrong}") from wrong


def _faults(recorded: RecordedRun) -> tuple[PlannedFault, ...]:
    """What went wrong on purpose, to go wrong again at the same instants."""
    try:
        return tuple(fault_from_json(one) for one in recorded.header.get("faults", ()))
    except (TypeError, ValueError) as wrong:
        raise NotReplayableError(recorded.name, f"its faults: {wrong}") from wrong


def _recorded_lines(recorded: RecordedRun) -> list[str]:
    try:
        text = (recorded.path / "events.jsonl").read_text("utf-8", errors="replace")
    except OSError as failed:
        raise NotReplayableError(recorded.name, f"its events: {failed.strerror or failed}") from failed
    whole, _, rest = text.rpartition("\n")  # a run that was killed may end in half a line
    lines = whole.split("\n") if whole else []
    return lines if not rest or not recorded.report else [*lines, rest]


def _inputs(lines: list[str]) -> Iterator[InputTaken]:
    for line in lines:
        event = _object(line)
        if event.get("event") == InputTaken.__name__:
            yield InputTaken(float(event["t_s"]), str(event["what"]), str(event["value"]))


def _object(line: str) -> Mapping[str, Any]:
    try:
        value = json.loads(line)
    except ValueError:
        return {}
    return value if isinstance(value, dict) else {}
