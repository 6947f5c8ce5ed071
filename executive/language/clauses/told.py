"""Commands with "you" before them, as learners of English give them: "you take the cup, you give me"."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from executive.language.phrases import Clause, Trouble

TOLD, DONE = "told", "done"
"""What a clause with "you" is: a command, or said of what was done: "you put it there" may be both."""

_SEEN = frozenset({"find"})
"""Tasks of which "you find it on the table" says where it is."""

_SAME_IN_THE_PAST = frozenset({"place", "put_in", "close"})
"""Tasks of which verbs such as "put" and "shut" may be past, so that they order nothing for sure."""


def as_told(command: Clause) -> Clause | None:
    """The command with what "you" makes of it."""
    drafts = [one for bundle in command.bundles for one in bundle]
    if command.form == "ed":
        return replace(command, form="base", you=DONE)
    if command.form != "base" or not drafts or any(one.action in _SEEN for one in drafts):
        return None
    return replace(command, you=TOLD)


def told_or_done(clauses: Iterable[Clause]) -> Trouble | bool | None:
    """What is wrong with the clauses of a sentence that are said of what was done.

    Behind "you take the cup", which can only order, "you put it there" orders too, so that there is no
    such reading (False); else it may be told of what is done already.
    """
    orders = False
    for clause in clauses:
        if clause.you == DONE:
            told = "it may be told of what is done already; say without 'you' what is to be done"
            return False if orders else Trouble(told, "you", rivals=True)
        actions = {one.action for bundle in clause.bundles for one in bundle}
        orders = orders or (clause.you == TOLD and actions.isdisjoint(_SAME_IN_THE_PAST))
    return None
