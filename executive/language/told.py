"""Commands with "you" before them, as learners of English give them: "you take the cup, you give me"."""

from __future__ import annotations

from executive.language.phrases import Clause, Trouble

_SEEN = frozenset({"find"})
"""Tasks of which "you find it on the table" says where it is."""


def as_told(command: Clause) -> Clause | Trouble | None:
    """The command, unless it may as well be said of what the robot did: "you put the cup on the table"."""
    if command.form == "ed":
        told = "it may be told of what is done already; say without 'you' what is to be done"
        return Trouble(told, "you", rivals=True)
    drafts = [one for bundle in command.bundles for one in bundle]
    if command.form != "base" or not drafts or any(one.action in _SEEN for one in drafts):
        return None
    return command
