"""How a run is shown: a live tree, plain lines, or nothing but the result."""

from __future__ import annotations

from collections.abc import Iterator
from typing import IO, TYPE_CHECKING, Protocol

from rich.console import Console, Group
from rich.live import Live
from rich.text import Text

from executive.events import Event
from executive.feedback import line_for
from executive.outputs.tree_lines import tree_lines
from robots.clock import WallClock
from trees.events import NodeChanged
from trees.snapshot import NodeSnapshot, NodeStatus, TreeSnapshot

if TYPE_CHECKING:
    from trees.build import TaskTree

REDRAW_S = 0.1
"""Wall time between two drawings: drawing must not slow the run down."""

_STYLES: dict[NodeStatus, str] = {"idle": "dim", "running": "bold cyan", "success": "green", "failure": "red"}
_SHOWN_LINES = 4


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
            self._leaves = frozenset(_leaf_names(tree.snapshot(0.0).root))

    def line(self, event: Event) -> str | None:
        """The event's line with the simulated time, or None."""
        if isinstance(event, NodeChanged) and event.where.rpartition("/")[2] not in self._leaves:
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


def _leaf_names(node: NodeSnapshot) -> Iterator[str]:
    if node.kind == "leaf":
        yield node.name
    for child in node.children:
        yield from _leaf_names(child)


class LiveDisplay:
    """The tree drawn in place, with the newest lines below it."""

    def __init__(self, console: Console) -> None:
        self._console = console
        self._live = Live(console=console, auto_refresh=False, transient=False)
        self._wall = WallClock()
        self._drawn_s = -REDRAW_S
        self._teller = _Teller()
        self._lines: list[str] = []
        self._started = False

    def event(self, event: Event) -> None:
        """Keep its line among the newest."""
        line = self._teller.line(event)
        if line is not None:
            self._lines = [*self._lines, line][-_SHOWN_LINES:]

    def tick(self, tree: TaskTree) -> None:
        """Draw when it is time to, and always at the end."""
        self._teller.learn(tree)
        now_s = self._wall.now_s()
        if now_s - self._drawn_s < REDRAW_S and tree.status == "running":
            return
        self._drawn_s = now_s
        if not self._started:
            self._live.start()
            self._started = True
        self._live.update(drawing(tree.snapshot(0.0), self._lines, self._console), refresh=True)

    def note(self, line: str) -> None:
        """Print a line above the drawing."""
        self._console.print(line, markup=False, highlight=False)

    def close(self) -> None:
        """Leave the last drawing standing."""
        if self._started:
            self._live.stop()


def drawing(snapshot: TreeSnapshot, newest: list[str], console: Console) -> Group:
    """Lay a tree and the newest lines out for a console's size."""
    unicode = console.encoding.lower().startswith("utf")
    height = max(5, console.height - _SHOWN_LINES - 2)
    rows = [
        Text(line.text, style=_STYLES[line.status], no_wrap=True, overflow="crop")
        for line in tree_lines(snapshot, console.width, height, unicode)
    ]
    tail = [Text(line[: console.width], style="dim", no_wrap=True, overflow="crop") for line in newest]
    return Group(*rows, *tail)
