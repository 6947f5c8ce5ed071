"""Which courtesies are conditions: "if it's no trouble" is none, "if it's no trouble to reach" is one."""

from __future__ import annotations

_BEGINNINGS = ("if it ", "if it's ", "if that ", "if that's ")
_CONTENT = frozenset({"to", "for", "with", "that", "if", "when", "in", "on", "at"})
"""With which a courtesy goes on and says what is asked: "if it's ok with Ben"."""


def is_condition(said: str, following: str) -> bool:
    """Whether a courtesy is a condition because of what follows it.

    Args:
        said: The courtesy, lower-case.
        following: The word behind it, or nothing.
    """
    return said.startswith(_BEGINNINGS) and following in _CONTENT
