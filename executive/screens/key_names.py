"""What a terminal sends for keys, by name: some keys are several characters."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

_ARROWS: Mapping[str, str] = MappingProxyType({"A": "up", "B": "down", "C": "right", "D": "left"})
_ESCAPE = "\x1b"


def key_names(text: str) -> tuple[str, ...]:
    """Names of the keys that were pressed; what is no key of ours, as F5, is left out.

    Args:
        text: What the terminal sent. Arrows are ``ESC [ A`` or ``ESC O A``, as the terminal's mode has it.
    """
    names: list[str] = []
    k = 0
    while k < len(text):
        one, k = text[k], k + 1
        if one in "\r\n":
            names.append("enter")
        elif one != _ESCAPE:
            names.append(one)
        elif text[k : k + 1] in ("[", "O"):
            k += 1
            begin = k
            while k < len(text) and not text[k].isalpha() and text[k] != "~":
                k += 1
            last = text[k : k + 1]
            if last in _ARROWS and (k == begin or text[begin:k].startswith("1;")):
                names.append(_ARROWS[last])
            k += 1
    return tuple(names)
