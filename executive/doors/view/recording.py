"""A recorded run as something to scrub through: what was so at each moment, and what happened between them.

A run's record holds events, and no motion: the same run gives the same bytes, so that it is run again here,
and looked at thirty times a second of its own time.
"""

from __future__ import annotations

import bisect
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from itertools import zip_longest
from typing import TYPE_CHECKING, Any

from executive.doors.recorder.feed import report_of
from executive.doors.view.seen import LogLine, log_line
from executive.live.told_as_json import tree_json
from executive.live.world_as_json import believed_json
from executive.reports.feedback import line_for
from executive.runs.replay import ReplayVerdict, replay
from executive.runs.run_log import RecordedRun
from executive.session.events import Event, event_json
from robots.live.documents.robot_report import RobotReport

if TYPE_CHECKING:
    from executive.session.assembly import Assembly
    from trees.build import TaskTree

MOMENT_EVERY_S = 1.0 / 30.0
_GLANCE = 160
_FOR_THE_DIGEST = frozenset({"PlanningAnswered", "SensorsNoted"})
_FAILURES = frozenset({"LeafFailed", "SetpointRefused", "EmergencyStopped", "TaskRefused"})


@dataclass(frozen=True, slots=True)
class Moment:
    """What was so at one instant.

    Attributes:
        t_s: Simulated time.
        report: What the robot knew of itself.
        world: What it believed, as ``world`` of docs/reference/live-protocol.md.
        nodes: Of the tree under way, or of the last one.
    """

    t_s: float
    report: RobotReport
    world: Mapping[str, Any]
    nodes: Sequence[Mapping[str, Any]]


class Recording:
    """Moments and events of one run, in order of time.

    Attributes:
        name: Of the run.
        robot, scene, asked: Which robot, where, and what was asked of it.
        moments: At least one, once the run has begun.
        events: As JSON.
        log: Lines for people.
        pictures: Of the robot's camera, as JPEG, each with its time; none where they were not recorded.
    """

    def __init__(self, run: RecordedRun) -> None:
        self.name = run.name
        self.robot, self.scene, self.asked = (
            str(run.header.get(key, "")) for key in ("robot", "scene", "input")
        )
        self.moments: list[Moment] = []
        self.events: list[Mapping[str, Any]] = []
        self.log: list[LogLine] = []
        self.pictures: list[tuple[float, bytes]] = []

    @property
    def ends_s(self) -> float:
        """Simulated time of the last moment, or of what happened after it."""
        moments_s = (one.t_s for one in self.moments[-1:])
        return max([0.0, *moments_s, *(float(one.get("t_s", 0.0)) for one in self.events[-1:])])

    def moment(self, t_s: float) -> Moment:
        """The moment at a time, or the last before it; the first one for any time before."""
        index = bisect.bisect_right(self.moments, t_s, key=lambda one: one.t_s)
        return self.moments[max(index - 1, 0)]

    def picture(self, t_s: float) -> bytes | None:
        """The last picture of the robot's camera up to a time, as JPEG; None where there is none."""
        index = bisect.bisect_right(self.pictures, t_s, key=lambda one: one[0])
        return self.pictures[index - 1][1] if index else None

    def log_until(self, t_s: float) -> tuple[LogLine, ...]:
        """Lines for people up to a time."""
        return tuple(self.log[: bisect.bisect_right(self.log, t_s, key=lambda one: one.t_s)])

    def newest(self, t_s: float, kinds: Sequence[str]) -> Mapping[str, Any] | None:
        """The last event of some kinds up to a time; None where there is none."""
        past = (event for event in reversed(self.events) if float(event.get("t_s", 0.0)) <= t_s)
        return next((event for event in past if event["event"] in kinds), None)

    @property
    def failures_s(self) -> tuple[float, ...]:
        """When something failed, was refused or stopped, rising, each time once."""
        times = {float(event["t_s"]) for event in self.events if is_failure(event)}
        return tuple(sorted(times))

    def next_failure_s(self, after_s: float) -> float | None:
        """The next failure after a time, the first one again after the last; None where nothing failed."""
        times = self.failures_s
        return next((t_s for t_s in times if t_s > after_s + 1e-6), times[0] if times else None)


@dataclass(frozen=True, slots=True)
class FirstDifference:
    """The first event in which two runs differ.

    Attributes:
        t_s: Simulated time at which it happened in the run in which it came first.
        number: Of the event, from 1.
        first, second: Its lines for people in the two runs, or what kind of event it is; empty where there is
            none any more.
    """

    t_s: float
    number: int
    first: str
    second: str


def first_difference(one: Recording, other: Recording) -> FirstDifference | None:
    """The first event in which two runs differ; None where they are the same.

    Events for the digest alone tell people nothing, and are not told of a live run: they count where nothing
    else differs and both runs have them.
    """
    kinds = [{event["event"] for event in run.events} for run in (one, other)]
    differs = _first_difference(one, other, _FOR_THE_DIGEST)
    return differs or _first_difference(one, other, _FOR_THE_DIGEST - (kinds[0] & kinds[1]))


def _first_difference(one: Recording, other: Recording, left_out: frozenset[str]) -> FirstDifference | None:
    kept = [[event for event in run.events if event["event"] not in left_out] for run in (one, other)]
    for number, (first, second) in enumerate(zip_longest(*kept), start=1):
        if first == second:
            continue
        times = [float(event.get("t_s", 0.0)) for event in (first, second) if event is not None]
        return FirstDifference(min(times), number, _told(first), _told(second))
    return None


def _told(event: Mapping[str, Any] | None) -> str:
    """What kind of event it is, with its numbers and words, cut to what is read at a glance."""
    if event is None:
        return ""
    rest = ", ".join(f"{key} {value}" for key, value in event.items() if key not in ("event", "t_s"))
    return f"{event['event']} at {float(event.get('t_s', 0.0)):.2f} s: {rest}"[:_GLANCE]


def is_failure(event: Mapping[str, Any]) -> bool:
    """Whether an event tells that something failed, was refused or stopped."""
    kind = event["event"]
    return kind in _FAILURES or (kind == "TaskEnded" and event.get("failure") is not None)


def recorded_again(run: RecordedRun, tell: Callable[[str], None]) -> tuple[Recording, ReplayVerdict]:
    """Run a recorded run again, and keep what there is to see.

    Args:
        run: The run.
        tell: Hears what is done.

    Raises:
        NotReplayableError: It was no run in lockstep, or its folder is not whole.
        UserError: The script, the scene or the machine is not good for it.
    """
    recording = Recording(run)
    keeper = _Keeper(recording)
    verdict = replay(run, tell, keeper, keeper.begin)
    return recording, verdict


class _Keeper:
    """Keeps what goes by; satisfies ``executive.screens.display.Display``."""

    def __init__(self, recording: Recording) -> None:
        self._recording, self._due_s = recording, 0.0
        self._assembly: Assembly | None = None
        self._tree: TaskTree | None = None
        self._world: Mapping[str, Any] = {"version": -1, "things": []}
        self._seen_of: object = None

    def begin(self, assembly: Assembly) -> None:
        """Look at a robot from now on."""
        self._assembly = assembly
        assembly.session.watch_periods(self._period)

    def event(self, event: Event) -> None:
        """Keep it, with its line."""
        told = event_json(event)
        self._recording.events.append(told)
        if (line := log_line(told, line_for(event))) is not None:
            self._recording.log.append(line)

    def tick(self, tree: TaskTree) -> None:
        """Know the tree under way."""
        self._tree = tree

    def note(self, line: str) -> None:
        """The events tell it."""

    def close(self) -> None:
        """Nothing to leave."""

    def _period(self) -> None:
        assembly = self._assembly
        if assembly is None or (t_s := assembly.clock.now_s()) < self._due_s:
            return
        self._due_s = t_s + MOMENT_EVERY_S
        before, report = self._recording.moments, report_of(assembly.loop, t_s)
        nodes: Sequence[Mapping[str, Any]] = before[-1].nodes if before else ()
        if self._tree is not None:
            told = tree_json(self._tree.snapshot(t_s).root)
            nodes = nodes if told == nodes else told
        before.append(Moment(t_s, report, self._believed(assembly), nodes))

    def _believed(self, assembly: Assembly) -> Mapping[str, Any]:
        """What is believed; made anew only where it has changed."""
        world = assembly.session.toolbox.world
        planned = assembly.loop.motion.planned
        now = (world.scene.version, world.sightings, id(planned))
        if now != self._seen_of:
            self._seen_of = now
            self._world = believed_json(assembly.session.toolbox, planned)
        return self._world
