"""How a run is shown: a live tree, plain lines, or nothing but the result."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import IO, TYPE_CHECKING, Any, Protocol

from rich.console import Console, Group
from rich.live import Live
from rich.text import Text

from executive.dialogue.clarification import OpenQuestion
from executive.reports.feedback import line_for, sentence
from executive.screens.rows import Row, Style
from executive.screens.screen import ScreenState, screen
from executive.session.events import Event, TaskAccepted
from executive.session.lifecycle import LifecycleChanged
from robots.clock import WallClock
from robots.control.events import EmergencyReset, EmergencyStopped, MotionEnded, MotionStarted
from trees.events import LeafFailed, NodeChanged

if TYPE_CHECKING:
    from trees.build import TaskTree

REDRAW_S = 0.1
"""Wall time between two drawings: drawing must not slow the run down."""

_STYLES: dict[Style, str] = {
    "": "",
    "bold": "bold",
    "dim": "dim",
    "ok": "green",
    "running": "bold cyan",
    "bad": "red",
    "ask": "bold yellow",
    "alarm": "bold white on red",
    "cursor": "reverse",
}
_KEPT_LINES = 60


class Display(Protocol):
    """Shows what goes on while a run is under way."""

    def event(self, event: Event) -> None:
        """Take an event."""
        ...

    def tick(self, tree: TaskTree) -> None:
        """Take the tree after a tick; a snapshot is made only when it will be drawn."""
        ...

    def note(self, line: str) -> None:
        """Show a line that stays."""
        ...

    def close(self) -> None:
        """Leave the terminal as it was found."""
        ...


class NoDisplay:
    """Shows nothing."""

    def event(self, event: Event) -> None:
        """Drop it."""

    def tick(self, tree: TaskTree) -> None:
        """Drop it."""

    def note(self, line: str) -> None:
        """Drop it."""

    def close(self) -> None:
        """Nothing to leave."""


class _Teller:
    """Makes lines of events; of the tree's nodes only the leaves are told."""

    def __init__(self) -> None:
        self._tree: TaskTree | None = None
        self._leaves: frozenset[str] = frozenset()

    def learn(self, tree: TaskTree) -> None:
        """Know the leaves of a tree that is shown for the first time."""
        if tree is not self._tree:
            self._tree = tree
            self._leaves = tree.leaf_places

    def line(self, event: Event) -> str | None:
        """The event's line with the simulated time, or None."""
        if isinstance(event, NodeChanged) and event.where not in self._leaves:
            return None
        line = line_for(event)
        return None if line is None else f"[{event.t_s:7.2f} s] {line}"


class PlainDisplay:
    """A line for each thing that happens, for pipes, logs and people without a drawing terminal."""

    def __init__(self, stream: IO[str]) -> None:
        self._stream = stream
        self._teller = _Teller()

    def event(self, event: Event) -> None:
        """Write its line."""
        line = self._teller.line(event)
        if line is not None:
            self.note(line)

    def tick(self, tree: TaskTree) -> None:
        """Learn a new tree's leaves; the events say the rest."""
        self._teller.learn(tree)

    def note(self, line: str) -> None:
        """Write a line."""
        encoding = getattr(self._stream, "encoding", None) or "utf-8"
        self._stream.write(line.encode(encoding, "replace").decode(encoding) + "\n")
        self._stream.flush()

    def close(self) -> None:
        """Nothing to leave."""


class KeptScreen:
    """Keeps what a screen shows of a run.

    Attributes:
        state: What is shown now.
    """

    def __init__(self, place: str = "", keys: bool = False) -> None:
        self.state = ScreenState(place=place, keys=keys)
        self._teller = _Teller()

    def event(self, event: Event) -> None:
        """Take what it changes into the screen's state."""
        line = self._teller.line(event)
        log = (*self.state.log, line)[-_KEPT_LINES:] if line is not None else self.state.log
        self.state = replace(self.state, t_s=event.t_s, log=log, **_changes(event, self.state))


class LiveDisplay(KeptScreen):
    """Shows a run as a screen that is drawn again in place."""

    def __init__(self, console: Console, place: str = "", keys: bool = False) -> None:
        super().__init__(place, keys)
        self._console = console
        self._live = Live(console=console, auto_refresh=False, transient=False)
        self._wall = WallClock()
        self._drawn_s = -REDRAW_S
        self._tree: TaskTree | None = None
        self._started = False

    def tick(self, tree: TaskTree) -> None:
        """Draw when it is time to, and always at the end."""
        self._teller.learn(tree)
        self._tree = tree
        now_s = self._wall.now_s()
        if now_s - self._drawn_s < REDRAW_S and tree.status == "running":
            return
        self._drawn_s = now_s
        self.draw()

    def draw(self) -> None:
        """Draw the screen as it is now."""
        if self._tree is not None:
            self.state = replace(self.state, tree=self._tree.snapshot(self.state.t_s))
        if not self._started:
            self._live.start()
            self._started = True
        self._live.update(drawing(self.state, self._console), refresh=True)

    def ask(self, question: OpenQuestion | None) -> None:
        """Show a question, or take it away."""
        self.state = replace(self.state, question=question)
        self.draw()

    def pause(self, paused: bool) -> None:
        """Show whether time is held."""
        self.state = replace(self.state, paused=paused)
        self.draw()

    def jog(self, lines: tuple[str, ...]) -> None:
        """Show what a person who jogs the robot has to know; nothing once nobody does."""
        if lines != self.state.by_hand:
            self.state = replace(self.state, by_hand=lines)
            self.draw()

    def offer(self, offered: bool) -> None:
        """Show that a person may take over, or no more."""
        self.state = replace(self.state, offered=offered)
        self.draw()

    @property
    def width(self) -> int:
        """Columns."""
        return self._console.width

    def note(self, line: str) -> None:
        """Print a line above the drawing."""
        self._console.print(line, markup=False, highlight=False)

    def close(self) -> None:
        """Leave the last drawing standing."""
        if self._started:
            self._live.stop()
            self._started = False


def _changes(event: Event, state: ScreenState) -> dict[str, Any]:
    """What an event changes on the screen, beside time and log."""
    match event:
        case TaskAccepted(text=text):
            return {"task": text, "failure": "", "motion": ""}
        case LeafFailed(failure=failure) if not failure.choices:
            return {"failure": sentence(failure)}
        case MotionStarted(motion=motion):
            return {"motion": motion}
        case MotionEnded(motion=motion) if motion == state.motion:
            return {"motion": ""}
        case LifecycleChanged(after=after, reason=reason):
            normal = after == "NORMAL"
            return {"safety": after if normal else f"{after}: {reason}", "alarmed": not normal}
        case EmergencyStopped(reason=reason):
            return {"safety": f"EMERGENCY: {reason}", "alarmed": True}
        case EmergencyReset():
            return {"safety": "RECOVERY", "alarmed": True}
        case _:
            return {}


def drawing(state: ScreenState, console: Console) -> Group:
    """The screen for a console's size, in its colours if it has any."""
    unicode = console.encoding.lower().startswith("utf")
    return painted(screen(state, console.width, max(console.height - 1, 5), unicode))


def painted(rows: Sequence[Row]) -> Group:
    """Rows in the colours that a console has."""
    return Group(
        *(
            Text.assemble(*((cell.text, _STYLES[cell.style]) for cell in row), no_wrap=True, overflow="crop")
            for row in rows
        )
    )
