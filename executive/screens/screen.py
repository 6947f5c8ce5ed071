"""What a terminal shows while a run is under way, laid out as plain text for any size.

header    where, when, and whether the robot may move
tree      every node with its status, the running leaf always in sight
now       the running leaf with its numbers, the newest failure with its numbers
question  with its choices, while one is open
log       the newest lines; beside the tree on a wide screen
keys      what can be pressed
"""

from __future__ import annotations

from dataclasses import dataclass

from executive.dialogue.clarification import OpenQuestion
from executive.screens.rows import (
    Cell,
    Row,
    beside,
    fitted,
    line_row,
    printable,
    rule_row,
    running_step,
    tree_rows,
)
from trees.snapshot import TreeSnapshot

WIDE = 120
"""Columns from which the log stands beside the tree."""

LOG_LINES = 4
"""Newest lines below the tree on a narrow screen."""

KEYS = "c cancel   e emergency stop   p pause   t take over"
PAUSED_KEYS = "p go on   c cancel   e emergency stop"
OFFERED_KEYS = "t take over   any other key: leave it so"
QUESTION_KEYS = "1-9 choose   a answer in words   c never mind   e emergency stop"


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
        by_hand: What is shown to a person who jogs the robot; empty while nobody does.
        offered: Whether a person may take over what has failed.
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
    by_hand: tuple[str, ...] = ()
    offered: bool = False


def screen(state: ScreenState, width: int, height: int, unicode: bool = True) -> list[Row]:
    """Lay the screen out: at most ``height`` rows, each at most ``width`` columns."""
    head = [
        header_row(state, width, unicode),
        rule_row(width, unicode),
    ]
    foot = _foot(state, width, unicode)
    wide = width >= WIDE
    logged = [] if wide else [line_row(line, "dim", width, unicode) for line in state.log[-LOG_LINES:]]
    room = height - len(head) - len(foot) - len(logged)
    if room < 3 and logged:  # the tree matters more than what has passed
        room, logged = room + len(logged), []
    body = (
        _wide_body(state, width, max(room, 1), unicode)
        if wide
        else tree_rows(state.tree, width, max(room, 1), unicode)
    )
    return [*head, *body, *logged, *foot][:height]


def header_row(state: ScreenState, width: int, unicode: bool) -> Row:
    """The safety state stands at the right and is never cut off."""
    said = "PAUSED  " if state.paused else ""
    right = fitted(printable(f"{said}{state.t_s:8.2f} s  {state.safety}"), max(width - 2, 1), unicode)
    left = fitted(printable(f"{state.place}  {state.task}").strip(), max(width - len(right) - 2, 0), unicode)
    gap = " " * max(width - len(left) - len(right), 0)
    return Cell(left, "bold"), Cell(gap), Cell(right, "alarm" if state.alarmed else "ok")


def _wide_body(state: ScreenState, width: int, height: int, unicode: bool) -> list[Row]:
    """The tree at the left, the log at the right."""
    left_width = width // 2
    right_width = width - left_width - 3
    left = tree_rows(state.tree, left_width, height, unicode)
    right = [line_row(line, "dim", right_width, unicode) for line in state.log[-height:]]
    return beside(left, left_width, right, unicode)


def _foot(state: ScreenState, width: int, unicode: bool) -> list[Row]:
    rows: list[Row] = []
    now = running_step(state.tree)
    if now or state.motion:
        motion = f"  [{state.motion}]" if state.motion else ""
        rows.append(line_row(f"now     {now or 'waiting'}{motion}", "running", width, unicode))
    if state.failure:
        rows.append(line_row(f"failed  {state.failure}", "bad", width, unicode))
    if state.question is not None:
        head, *choices = state.question.lines()
        rows.append(line_row(f"asked   {head}", "ask", width, unicode))
        rows += [line_row(f"        {choice.strip()}", "ask", width, unicode) for choice in choices]
    if state.by_hand:
        return [*rows, *(line_row(line, "ask", width, unicode) for line in state.by_hand)]
    if state.offered:
        return [*rows, line_row(f"keys    {OFFERED_KEYS}", "ask", width, unicode)]
    if state.keys:
        keys = QUESTION_KEYS if state.question is not None else KEYS
        rows.append(line_row(f"keys    {PAUSED_KEYS if state.paused else keys}", "dim", width, unicode))
    return rows
