"""One goal of an action, carried out by the robot: an order on its socket, watched until it has ended."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

from progress import Progress, under_way
from robot_link import EXECUTIVE, Link, ask

POLL_S = 0.1
LOOKS_EVERY_S = 0.5


def carry_out(
    folder: Path,
    order: Mapping[str, Any],
    tell: Callable[[Progress], None],
    why_to_end: Callable[[], str],
) -> dict[str, Any]:
    """Give an order to the robot, and hear it out.

    Args:
        folder: Where the robot is served.
        order: The message: its type under "kind", and its fields.
        tell: Takes how it goes on, whenever that is news.
        why_to_end: Asked a few times a second: why the task has to be cancelled, or nothing.

    Returns:
        The message with the result; a refusal looks alike.
    """
    told, asked_to_end, looked_s = Progress(), False, time.monotonic()
    try:
        link = Link(folder / EXECUTIVE)
        try:
            link.send(**order)
            while True:
                now, said = told, False
                message: dict[str, Any] = link.receive(POLL_S) or {"type": ""}
                match message["type"]:
                    case "line":
                        now, said = replace(told, line=str(message["text"])), True
                    case "result":
                        return message
                    case "error":
                        return {"outcome": "refused", "exit_code": 2, "text": f"refused: {message['reason']}"}
                if time.monotonic() - looked_s >= LOOKS_EVERY_S:
                    looked_s = time.monotonic()
                    now = _look(folder, now)
                if said or now != told:
                    tell(now)
                    told = now
                if not asked_to_end and (reason := why_to_end()):
                    ask(folder / EXECUTIVE, "cancel", reason=reason)
                    asked_to_end = True
        finally:
            link.close()
    except OSError as wrong:
        return {"outcome": "failed", "exit_code": 1, "text": f"failed: {wrong}"}


def _look(folder: Path, told: Progress) -> Progress:
    """How the task stands by the robot's status."""
    status = ask(folder / EXECUTIVE, "status")
    path, says = under_way(status.get("tree"))
    question = status.get("question") or {}
    return replace(
        told,
        tree_path=path,
        leaf_says=says,
        question=str(question.get("text", "")),
        choices=tuple(map(str, question.get("choices", ()))),
    )
