"""What a terminal shows while a run is under way, laid out as plain text for any size.

header    where, when, and whether the robot may move
tree      every node with its status, the running leaf always in sight
now       the running leaf with its numbers, the newest failure with its numbers
question  with its choices, while one is open
log       the newest lines; beside the tree on a wide screen
keys      what can be pressed
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

from executive.dialogue.clarification import OpenQuestion
from executive.screens.tree_lines import TreeLine, tree_lines
from trees.snapshot import NodeSnapshot, TreeSnapshot

Style = Literal["", "bold", "dim", "ok", "running", "bad", "ask", "alarm"]

WIDE = 120
"""Columns from which the log stands beside the tree."""

LOG_LINES = 4
"""Newest lines below the tree on a narrow screen."""

KEYS = "c cancel   e emergency stop   p pause"
QUESTION_KEYS = "1-9 choose   a answer in words   c never mind   e emergency stop"

_TREE_STYLES: dict[str, Style] = {"idle": "dim", "running": "running", "success": "ok", "failure": "bad"}


@dataclass(frozen=True, slots=True)
class ScreenState:
    """Everything that the live screen shows at one moment.

    Attributes:
        place: Robot, scene and seed, in a few words.
        t_s: Simulated time.
        safety: State of the robot: "NORMAL", "EMERGENCY: ...".
        alarmed: Whether that is anything but normal.
        task: What was asked for.
        tree: The tree at its newest tick, or None before the first.
        failure: The newest failure as a sentence, or nothing.
        motion: The motion under way, or nothing.
        question: The open question, or None.
        paused: Whether simulated time is held.
        log: Newest lines, the last one newest.
        keys: Whether keys are listened to.
    """

    place: str = ""
    t_s: float = 0.0
    safety: str = "NORMAL"
    alarmed: bool = False
    task: str = ""
    tree: TreeSnapshot | None = None
    failure: str = ""
    motion: str = ""
    question: OpenQuestion | None = None
    paused: bool = False
    log: tuple[str, ...] = ()
    keys: bool = False


@dataclass(frozen=True, slots=True)
class Cell:
    """A piece of a row in one style."""

    text: str
    style: Style = ""


Row = tuple[Cell, ...]


def screen(state: ScreenState, width: int, height: int, unicode: bool = True) -> list[Row]:
    """Lay the screen out: at most ``height`` rows, each at most ``width`` columns."""
    head = [
        _header(state, width, unicode),
        (Cell(_fit(("─" if unicode else "-") * width, width, unicode), "dim"),),
    ]
    foot = _foot(state, width, unicode)
    wide = width >= WIDE
    logged = [] if wide else [_line(line, "dim", width, unicode) for line in state.log[-LOG_LINES:]]
    room = height - len(head) - len(foot) - len(logged)
    if room < 3 and logged:  # the tree matters more than what has passed
        room, logged = room + len(logged), []
    body = (
        _wide_body(state, width, max(room, 1), unicode)
        if wide
        else _tree(state, width, max(room, 1), unicode)
    )
    return [*head, *body, *logged, *foot][:height]


def text_of(rows: Sequence[Row]) -> str:
    """The rows without their styles."""
    return "\n".join("".join(cell.text for cell in row).rstrip() for row in rows)


def _header(state: ScreenState, width: int, unicode: bool) -> Row:
    """The safety state stands at the right and is never cut off."""
    said = "PAUSED  " if state.paused else ""
    right = _fit(_plain(f"{said}{state.t_s:8.2f} s  {state.safety}"), max(width - 2, 1), unicode)
    left = _fit(_plain(f"{state.place}  {state.task}").strip(), max(width - len(right) - 2, 0), unicode)
    gap = " " * max(width - len(left) - len(right), 0)
    return Cell(left, "bold"), Cell(gap), Cell(right, "alarm" if state.alarmed else "ok")


def _tree(state: ScreenState, width: int, height: int, unicode: bool) -> list[Row]:
    if state.tree is None:
        return [(Cell("nothing is under way", "dim"),)]
    lines: list[TreeLine] = tree_lines(state.tree, width, height, unicode)
    return [(Cell(line.text, _TREE_STYLES[line.status]),) for line in lines]


def _wide_body(state: ScreenState, width: int, height: int, unicode: bool) -> list[Row]:
    """The tree at the left, the log at the right."""
    left_width = width // 2
    right_width = width - left_width - 3
    left = _tree(state, left_width, height, unicode)
    right = [_fit(_plain(line), right_width, unicode) for line in state.log[-height:]]
    bar = " │ " if unicode else " | "
    rows: list[Row] = []
    for i in range(max(len(left), len(right))):
        (cell,) = left[i] if i < len(left) else (Cell(""),)
        told = right[i] if i < len(right) else ""
        rows.append((Cell(cell.text.ljust(left_width), cell.style), Cell(bar, "dim"), Cell(told, "dim")))
    return rows


def _foot(state: ScreenState, width: int, unicode: bool) -> list[Row]:
    rows: list[Row] = []
    now = _running(state.tree)
    if now or state.motion:
        motion = f"  [{state.motion}]" if state.motion else ""
        rows.append(_line(f"now     {now or 'waiting'}{motion}", "running", width, unicode))
    if state.failure:
        rows.append(_line(f"failed  {state.failure}", "bad", width, unicode))
    if state.question is not None:
        head, *choices = state.question.lines()
        rows.append(_line(f"asked   {head}", "ask", width, unicode))
        rows += [_line(f"        {choice.strip()}", "ask", width, unicode) for choice in choices]
    if state.keys:
        keys = QUESTION_KEYS if state.question is not None else KEYS
        rows.append(
            _line(f"keys    {'p go on   ' + keys[:-10] if state.paused else keys}", "dim", width, unicode)
        )
    return rows


def _running(tree: TreeSnapshot | None) -> str:
    """The running leaf with its place and its message."""
    if tree is None or tree.root.status != "running":
        return ""
    names: list[str] = []
    node: NodeSnapshot | None = tree.root
    message = ""
    while node is not None:
        names.append(node.name)
        message = node.message
        node = next((child for child in node.children if child.status == "running"), None)
    return "/".join([names[0], *names[-2:]] if len(names) > 3 else names) + (
        f": {message}" if message else ""
    )


def _line(text: str, style: Style, width: int, unicode: bool) -> Row:
    return (Cell(_fit(_plain(text), width, unicode), style),)


def _plain(text: str) -> str:
    return "".join(one if one.isprintable() else " " for one in text)


def _fit(text: str, width: int, unicode: bool) -> str:
    if not unicode:
        text = text.encode("ascii", "replace").decode()
    end = "…" if unicode else "~"
    return text if len(text) <= width else text[: max(width - 1, 0)] + end[: max(width, 0)]
