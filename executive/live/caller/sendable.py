"""What can be sent to a served robot: words that cross the socket, a script for what is served there."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from executive.errors import UserError
from executive.live.desk_messages import MAX_STATEMENTS, ScriptLine
from executive.scripts.task_script import TaskScript
from executive.understanding.understanding import understand

_MAX_CHARACTERS = 20_000
"""Of one text; the protocol's own bound."""
_LONGEST_REMARK = 500
"""Characters of a reason for a stop or a cancel."""


class NotSendableError(UserError):
    """Something that a served robot cannot be told."""


def sendable(text: str) -> str:
    """The text as it is sent, with plain spaces between the words.

    Raises:
        NotSendableError: It holds what no sentence may hold, or is too long.
    """
    spaced = "".join(" " if char.isspace() else char for char in text)
    if spaced.isprintable() and len(spaced) <= _MAX_CHARACTERS:
        return spaced
    refusal = understand(text).parsed.refusal
    if refusal is not None:
        raise NotSendableError(f"refused: {refusal}")
    odd = next((f"it holds U+{ord(char):04X}" for char in spaced if not char.isprintable()), "")
    raise NotSendableError(f"cannot be sent: {odd or f'it has more than {_MAX_CHARACTERS} characters'}")


def printable(text: str) -> str:
    """A remark as it can be sent: what cannot be printed is left out, and it is cut where it is too long."""
    spaced = "".join(" " if char.isspace() else char for char in text[:_LONGEST_REMARK])
    return "".join(char for char in spaced if char.isprintable())


def script_lines(path: Path, script: TaskScript) -> list[ScriptLine]:
    """The statements of a script, as they are sent.

    Raises:
        NotSendableError: One of them cannot be, or there are too many.
    """
    count = len(script.statements)
    if count > MAX_STATEMENTS:
        raise NotSendableError(f"{path}: task: has {count} statements; {MAX_STATEMENTS} can be sent at most")
    lines = []
    for index, one in enumerate(script.statements):
        try:
            text = sendable(one.parsed.text)
        except NotSendableError as wrong:
            raise NotSendableError(f"{path}: task[{index}].say: {wrong}") from None
        last = index == count - 1
        timeout_s = one.timeout_s or 0.0
        lines.append(ScriptLine(sendable(str(path)), text, one.on_failure, one.expect, timeout_s, last))
    return lines


def require_served_as(path: Path, script: TaskScript, served: Mapping[str, Any]) -> None:
    """Find out whether a script is for what is served; what it leaves open is as it is served.

    Args:
        path: The script's file.
        script: What it says.
        served: What the control process tells of itself: ``robot``, ``scene``, ``seed``.

    Raises:
        NotSendableError: It is for another robot, scene or seed.
    """
    for key, wanted in (("robot", script.robot), ("scene", script.scene), ("seed", script.seed)):
        there = served[key]
        if wanted is None or wanted == there or (key == "scene" and _same_file(str(wanted), str(there))):
            continue
        raise NotSendableError(
            f"{path}: {key}: {wanted!r} is wanted, but {there!r} is served; serve the robot with "
            f"--{key} {wanted}, or leave the line out"
        )


def _same_file(wanted: str, there: str) -> bool:
    try:
        return Path(wanted).samefile(there)
    except OSError:
        return False
