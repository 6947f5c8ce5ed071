"""JSON from somebody who may be wrong, or hostile: bounded before it is read, strict when it is.

Python's own reader accepts NaN and infinities, keeps the last of two equal keys, and recurses as deep as
the text does.
"""

from __future__ import annotations

import json
import math
from typing import Any, NoReturn

MAX_CHARACTERS = 65_536
"""Far more than any plan of a few steps takes."""

MAX_DEPTH = 12
"""The deepest document that means anything: steps, an object, its relation, that one's object, and so on."""


class UntrustedJsonError(Exception):
    """A text that is not read; the message says why in a few words."""


def read_json(text: str) -> Any:
    """Read a JSON text.

    Raises:
        UntrustedJsonError: It is too long, too deep, not JSON, or holds what JSON does not allow.
    """
    if len(text) > MAX_CHARACTERS:
        raise UntrustedJsonError(f"it has {len(text)} characters, at most {MAX_CHARACTERS} are read")
    if _depth(text) > MAX_DEPTH:
        raise UntrustedJsonError(f"it is nested deeper than {MAX_DEPTH} levels")
    try:
        return json.loads(
            text,
            parse_constant=_no_constant,
            parse_float=_finite,
            parse_int=_bounded,
            object_pairs_hook=_object,
        )
    except json.JSONDecodeError as wrong:
        raise UntrustedJsonError(
            f"it is not JSON: {wrong.msg} at line {wrong.lineno}, column {wrong.colno}"
        ) from wrong
    except RecursionError as wrong:
        raise UntrustedJsonError("it is nested too deeply") from wrong


def _depth(text: str) -> int:
    """How deep brackets nest, those inside strings left out."""
    depth = deepest = 0
    in_string = escaped = False
    for character in text:
        if in_string:
            if escaped:
                escaped = False
            elif character == "\\":
                escaped = True
            elif character == '"':
                in_string = False
        elif character == '"':
            in_string = True
        elif character in "[{":
            depth += 1
            deepest = max(deepest, depth)
        elif character in "]}":
            depth -= 1
    return deepest


def _no_constant(name: str) -> NoReturn:
    raise UntrustedJsonError(f"{name} is no number of JSON")


def _finite(digits: str) -> float:
    value = float(digits)
    if not math.isfinite(value):
        raise UntrustedJsonError(f"the number {digits[:20]} is too large")
    return value


def _bounded(digits: str) -> int:
    if len(digits) > 18:
        raise UntrustedJsonError(f"the number {digits[:20]}… is too large")
    return int(digits)


def _object(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    made: dict[str, Any] = {}
    for key, value in pairs:
        if key in made:
            raise UntrustedJsonError(f"the key {key[:40]!r} is there twice")
        made[key] = value
    return made
