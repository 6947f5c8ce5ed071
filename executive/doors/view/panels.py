"""What the page tells in words, as HTML: how things stand, the tree, why something failed, the log.

Colours are mixed with the page's own, so that all is read in the dark and in the light.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from html import escape
from typing import Any

from executive.doors.view.recording import FirstDifference
from executive.doors.view.seen import Level, LogLine, Seen
from executive.doors.view.shown_lines import Line
from executive.reports.feedback import quantity, sentence
from executive.runs.recorded_failure import failure_from
from executive.screens.tree_lines import GLYPHS
from trees.failures import Failure

_GREY, _BLUE = "light-dark(#5c636a, #a6adb4)", "light-dark(#1864ab, #74c0fc)"
_GREEN, _ORANGE = "light-dark(#237032, #69db7c)", "light-dark(#a63c00, #ffa94d)"
_RED = "light-dark(#c92a2a, #ff8787)"
"""In the light and in the dark: each with a contrast of 4.5 or more, as WCAG 2.2 asks of small text."""
_STATUS_COLORS: Mapping[str, str] = {
    "idle": _GREY,
    "running": _BLUE,
    "success": _GREEN,
    "failure": _RED,
}
_LEVEL_COLORS: Mapping[Level, str] = {
    "info": "inherit",
    "said": _BLUE,
    "warning": _ORANGE,
    "error": _RED,
    "alarm": _RED,
}
_LEVELS: tuple[Level, ...] = ("info", "said", "warning", "error", "alarm")
_SHOWN_LINES = 120
_BLOCK = "font-size:13px;line-height:1.35;overflow-wrap:anywhere;padding:2px 8px"
_SCROLLS = "max-height:min(62vh,46rem);overflow-y:auto"


def status_panel(seen: Seen) -> str:
    """Robot, place, time, state, the task and its running leaf."""
    rows = [f"<b>{escape(seen.robot)}</b> in {escape(seen.scene)} &nbsp; {seen.t_s:.1f} s"]
    if seen.emergency:
        rows.append(_alarm(f"EMERGENCY STOP: {seen.emergency}. A person leaves it: `executive reset`"))
    elif seen.state and seen.state != "NORMAL":
        rows.append(_alarm(seen.state))
    if seen.complaint:
        rows.append(_alarm(seen.complaint))
    held = " <b>paused</b>" if seen.paused else ""
    rows.append(f"task: <b>{escape(seen.task)}</b>{held}" if seen.task else "waits for a task")
    if seen.task and (leaf := running_leaf(seen.nodes)) is not None:
        rows.append(f"now: {escape(leaf['name'])} {escape(leaf['message'])}")
    return _block(rows)


def running_leaf(nodes: Sequence[Mapping[str, Any]]) -> Mapping[str, Any] | None:
    """The node that runs and has no running node below it, the last of them; None where nothing runs."""
    running = [node for node in nodes if node["status"] == "running"]
    return running[-1] if running else None


def tree_panel(lines: Sequence[Line]) -> str:
    """The tree, a node a line.

    Args:
        lines: Those that are shown, from the root down.
    """
    leaf = running_leaf([line.node for line in lines])
    return _block((_node(line, line.node is leaf) for line in lines), _SCROLLS)


def found_panel(nodes: Sequence[Mapping[str, Any]], search: str) -> str:
    """Nodes that are searched for, and what they are in.

    Args:
        nodes: From the root down, with their depths.
        search: Letters in their names or messages.
    """
    return tree_panel([Line(node, "", branch=False, open=True) for node in _matching(nodes, search)])


def _matching(nodes: Sequence[Mapping[str, Any]], search: str) -> list[Mapping[str, Any]]:
    wanted = search.strip().lower()
    above: list[int] = []
    shown: set[int] = set()
    for index, node in enumerate(nodes):
        above = [*(i for i in above if nodes[i]["depth"] < node["depth"]), index]
        if wanted in f"{node['name']} {node['message']}".lower():
            shown.update(above)
    return [nodes[i] for i in sorted(shown)]


def _node(line: Line, current: bool) -> str:
    node = line.node
    status = str(node["status"])
    color = _STATUS_COLORS.get(status, "inherit")
    message = escape(str(node["message"])) if status != "idle" else ""
    weight = "font-weight:600;background:rgba(28,126,214,.14);" if current else ""
    folded = ' <span style="opacity:.75">\u25b8</span>' if line.branch and not line.open else ""
    return (
        f'<span style="display:block;{weight}padding-left:{10 * int(node["depth"])}px">'
        f'<span style="color:{color}">{GLYPHS.get(status, "?")} {escape(str(node["name"]))}</span>{folded} '  # type: ignore[call-overload]
        f'<span style="opacity:.75">{message}</span></span>'
    )


def ending_panel(seen: Seen) -> str:
    """What the last task measured, or why it failed, link by link; empty while there is nothing to tell."""
    if seen.failure is not None:
        rows = [
            f'<span style="display:block;padding-left:{12 * depth}px;color:{_RED}">'
            f"{'because: ' if depth else 'failed: '}{escape(sentence(link))}</span>"
            for depth, link in enumerate(_chain(failure_from(seen.failure)))
        ]
        return _block(rows)
    if seen.evidence:
        told = (escape(quantity(key, value)) for key, value in seen.evidence.items())
        return _block(["<b>measured</b>", *told])
    return ""


def _chain(failure: Failure | None) -> Iterable[Failure]:
    while failure is not None:
        yield failure
        failure = failure.cause


def log_panel(log: Sequence[LogLine], least: Level = "info") -> str:
    """The newest lines of the log, the newest below and in sight.

    Args:
        log: Lines, the newest last.
        least: Lines of a lower level are left out.
    """
    kept = [one for one in log if _LEVELS.index(one.level) >= _LEVELS.index(least)][-_SHOWN_LINES:]
    rows = (
        f'<span style="color:{_LEVEL_COLORS[one.level]}">{one.t_s:.1f} {escape(one.text)}</span>'
        for one in reversed(kept)
    )
    return _block(rows, f"{_SCROLLS};display:flex;flex-direction:column-reverse")


def question_panel(question: Mapping[str, Any], with_choices: bool = False) -> str:
    """What is asked.

    Args:
        question: With ``text``, and perhaps ``tried`` and ``choices``.
        with_choices: Whether the choices are told as well, where no buttons do.
    """
    tried = str(question.get("tried") or "")
    wrong = f"<i>{escape(tried)}</i>" if tried else ""
    told = question.get("choices", ()) if with_choices else ()
    choices = " · ".join(escape(str(one)) for one in told)
    return _block([wrong, f"<b>{escape(str(question['text']))}</b>", choices])


def difference_panel(differs: FirstDifference | None) -> str:
    """The first event in which two runs differ, as it was in each."""
    if differs is None:
        return _block(["both runs are the same, event by event"])
    rows = [f"<b>event {differs.number} differs</b>"]
    for number, told in enumerate((differs.first, differs.second), start=1):
        rows.append(f"{number}: {escape(told) or '<i>no more events</i>'}")
    return _block(rows)


def _alarm(text: str) -> str:
    return f'<b style="color:#fff;background:#e03131;padding:1px 6px;border-radius:4px">{escape(text)}</b>'


def _block(rows: Iterable[str], style: str = "") -> str:
    inner = "".join(f"<div>{row}</div>" for row in rows if row)
    return f'<div style="{_BLOCK};{style}">{inner}</div>'
