"""TOML that somebody else has written: with a byte-order mark or without, and bounded before it is read.

Python's own reader takes a time that grows with the square of the parts of a dotted key ("a.a.a.a"), and
recurses as deep as brackets nest.
"""

from __future__ import annotations

import re
from typing import Any

MOST_PARTS = 32
"""Parts of a dotted key: no file here has keys of more than four."""
BYTE_ORDER_MARK = "\ufeff"
"""What some editors put before a text; it is no part of it."""

_PART = r"""(?:[\w-]+|"[^"\n]*"|'[^'\n]*')[ \t]*"""
_LONG_KEY = re.compile(rf"(?:^|[\[{{,])[ \t]*(?:{_PART}\.[ \t]*){{{MOST_PARTS}}}", re.MULTILINE)


class TomlTextError(ValueError):
    """A text that is no TOML, or is not read; the message says why."""


def read_toml(text: str) -> dict[str, Any]:
    """Read a TOML document.

    Args:
        text: The document; a byte-order mark at its beginning is passed over.

    Raises:
        TomlTextError: It is no TOML, is nested too deeply, or has a key of very many parts.
    """
    import tomllib  # here: who finds its words kept reads no TOML

    text = text.removeprefix(BYTE_ORDER_MARK)
    long_key = _LONG_KEY.search(text)
    if long_key is not None:
        line = text.count("\n", 0, long_key.end()) + 1
        raise TomlTextError(f"a key has more than {MOST_PARTS} parts (at line {line})")
    try:
        return tomllib.loads(text)
    except tomllib.TOMLDecodeError as broken:
        raise TomlTextError(str(broken)) from broken
    except RecursionError as broken:
        raise TomlTextError("it is nested too deeply") from broken
