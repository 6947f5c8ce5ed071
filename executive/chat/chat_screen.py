"""What the chat's screen shows, laid out as plain text for any size.

header        where, when, and whether the robot may move
tree          every step with its status; beside the conversation on a wide screen, with the log below it
conversation  what both sides said, the newest at the bottom; questions with their choices
line          what is being typed
keys          what can be pressed
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from rich.cells import cell_len, chop_cells

from executive.chat.robot_watch import RobotStanding
from executive.chat.utterance import Utterance
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
from executive.screens.screen import WIDE, ScreenState, header_row

KEYS = "Ctrl-X stop   Ctrl-C cancel   Ctrl-P pause   PgUp/PgDn scroll   Ctrl-D end"
_TREE_ROWS = 9
"""Of a narrow screen, at most."""
_LOG_SHARE = 3
"""One row of so many beside the conversation is the log's."""
_NAMES = {"you": "you    ", "robot": "robot  "}
_INDENT = "       "


@dataclass(frozen=True, slots=True)
class ChatView:
    """Everything that the chat's screen shows at one moment.

    Attributes:
        place: Robot and scene, in a few words.
        now: How the robot stands.
        under_way: What is being done; nothing while it is free.
        asks: Whether an answer is waited for.
        waiting: How many lines wait for their turn.
        said: The conversation.
        log: Newest lines of feedback.
        text: What is typed so far.
        cursor: Where the next character comes.
        back: Rows that the conversation is scrolled back by.
    """

    place: str = ""
    now: RobotStanding = field(default_factory=RobotStanding)
    under_way: str = ""
    asks: bool = False
    waiting: int = 0
    said: tuple[Utterance, ...] = ()
    log: tuple[str, ...] = ()
    text: str = ""
    cursor: int = 0
    back: int = 0


def chat_screen(view: ChatView, width: int, height: int, unicode: bool = True) -> list[Row]:
    """Lay the screen out: at most ``height`` rows, each at most ``width`` columns."""
    head = [header_row(_header(view), width, unicode), rule_row(width, unicode)]
    foot = [rule_row(width, unicode), _input_row(view, width, unicode)]
    foot.append(line_row(KEYS, "dim", width, unicode))
    room = max(height - len(head) - len(foot), 1)
    body = _wide(view, width, room, unicode) if width >= WIDE else _narrow(view, width, room, unicode)
    return [*head, *body, *foot][:height] if room > 1 else [head[0], *body, foot[1]][:height]


def _header(view: ChatView) -> ScreenState:
    now = view.now
    safety = f"EMERGENCY: {now.emergency}" if now.emergency else now.state
    if now.silent:
        safety = f"NO ANSWER ({safety})"
    alarmed = bool(now.emergency or now.silent) or now.state != "NORMAL"
    return ScreenState(view.place, now.t_s, safety, alarmed, paused=now.paused)


def _wide(view: ChatView, width: int, height: int, unicode: bool) -> list[Row]:
    """The conversation at the left; tree and log at the right."""
    left_width = width // 2
    right_width = width - left_width - 3
    log_rows = min(height // _LOG_SHARE, len(view.log))
    tree = tree_rows(view.now.tree, right_width, max(height - log_rows - 1, 1), unicode)
    log = [line_row(line, "dim", right_width, unicode) for line in view.log[-log_rows:]] if log_rows else []
    gap: list[Row] = [()] * max(height - len(tree) - len(log) - 1, 0)
    right = [*tree, *gap, rule_row(right_width, unicode), *log] if log else [*tree, *gap]
    left = _conversation(view, left_width, height, unicode)
    return beside(left, left_width, right[:height], unicode)


def _narrow(view: ChatView, width: int, height: int, unicode: bool) -> list[Row]:
    """The tree above the conversation, while there is one and room for both."""
    most = min(_TREE_ROWS, height // 2)
    if view.now.tree is None or most < 3:
        return _conversation(view, width, height, unicode)
    tree = tree_rows(view.now.tree, width, most - 1, unicode)
    now = running_step(view.now.tree)
    across = line_row(f"now    {now}", "running", width, unicode) if now else rule_row(width, unicode)
    return [*tree, across, *_conversation(view, width, height - len(tree) - 1, unicode)]


def _conversation(view: ChatView, width: int, height: int, unicode: bool) -> list[Row]:
    """The newest of what was said, or what was said before it, in exactly so many rows."""
    rows = [row for said in view.said for row in _utterance(said, width, unicode)]
    last = max(len(rows) - min(view.back, max(len(rows) - height, 0)), 0)
    shown = rows[max(last - height, 0) : last]
    if last < len(rows) and shown:
        shown[-1] = line_row(f"({len(rows) - last + 1} more rows below: PgDn)", "dim", width, unicode)
    return [*([()] * (height - len(shown))), *shown]


def _utterance(said: Utterance, width: int, unicode: bool) -> list[Row]:
    rows: list[Row] = []
    for line in said.lines:
        indent = len(line) - len(line.lstrip())
        for number, piece in enumerate(_wrapped(printable(line), max(width - len(_INDENT), 8), indent)):
            begin = _INDENT if rows or number else _NAMES[said.who]
            rows.append((Cell(begin, "bold"), Cell(fitted(piece, width, unicode), said.style)))
    return rows


def _wrapped(line: str, width: int, indent: int) -> list[str]:
    """A line in pieces of at most so many columns, broken between words; a longer word is cut."""
    if cell_len(line) <= width:
        return [line]
    pieces, piece = [], " " * indent
    for word in line.split():
        for part in chop_cells(word, max(width - indent - 2, 1)):
            joined = f"{piece} {part}" if piece.strip() else f"{piece}{part}"
            if cell_len(joined) <= width:
                piece = joined
            else:
                pieces.append(piece)
                piece = " " * (indent + 2 * (indent > 0)) + part
    return [*pieces, piece]


def _input_row(view: ChatView, width: int, unicode: bool) -> Row:
    """What is being typed, with the cursor in sight, and at the right what becomes of it."""
    mark = "›" if unicode else ">"
    prompt = f"{'answer' if view.asks else 'you'} {mark} "
    hint = _hint(view)
    if hint and width - len(prompt) - len(hint) - 2 < len(view.text) + 1:
        hint = ""
    room = max(width - len(prompt) - len(hint) - 2, 1)
    text = printable(view.text) + " "
    begin = max(view.cursor - room + 1, 0)
    before, at, behind = text[begin : view.cursor], text[view.cursor], text[view.cursor + 1 : begin + room]
    gap = " " * max(room - len(before) - 1 - len(behind), 0)
    return (
        Cell(prompt, "ask" if view.asks else "bold"),
        Cell(_shown(before, unicode)),
        Cell(_shown(at, unicode), "cursor"),
        Cell(_shown(behind, unicode) + gap),
        Cell(hint, "dim"),
    )


def _hint(view: ChatView) -> str:
    if view.text or view.asks:
        return ""
    if view.waiting:
        return f"busy, {view.waiting} waiting"
    return "busy: what you say waits" if view.under_way else ""


def _shown(text: str, unicode: bool) -> str:
    return text if unicode else text.encode("ascii", "replace").decode()


def transcript(said: Sequence[Utterance]) -> list[str]:
    """A conversation as plain lines."""
    return [
        f"{(_NAMES[one.who] if number == 0 else _INDENT)}{line}"
        for one in said
        for number, line in enumerate(one.lines)
    ]
