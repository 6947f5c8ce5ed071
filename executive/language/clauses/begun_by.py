"""Commands that are said to be the first or the last: "begin by opening the fridge, then take the milk"."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from executive.language.clauses.scopes import UNCLEAR_ORDER, Further, Separator
from executive.language.phrase_parts import Parts, words
from executive.language.phrases import Clause, Trouble

_TO = "_to"
"""How the meanings end of words that stand before a command itself: "your first task is to"."""

_JOINS = frozenset({Separator.AND, Separator.COMMA, Separator.THEN})


def begun_by(parts: Parts) -> Clause | None:
    """A command after "begin by" or "your first task is to", with the form that it has elsewhere."""
    command: Clause = parts[-1]
    begun = words(parts, "BEGIN_BY")[0].meaning
    if command.form != ("base" if begun.endswith(_TO) else "ing"):
        return None
    return replace(command, form="base", begun=begun)


def in_base_form(said: Sequence[Further]) -> Trouble | list[Further]:
    """All clauses, with those that "by" goes on to as if it were not said: "by opening it and taking it out".

    Args:
        said: The clauses of a sentence; what is the first or the last one must stand there.
    """
    commands = [one.part for one in said if not isinstance(one.part, Clause) or one.part.bundles]
    clauses = [one for one in commands if isinstance(one, Clause)]
    first, last = commands[:1], commands[-1:]
    if any(one.begun.startswith("first") and one is not first[0] for one in clauses):
        return UNCLEAR_ORDER  # "take the cup. Begin by opening the fridge"
    if any(one.begun.startswith("last") and one is not last[0] for one in clauses):
        return replace(UNCLEAR_ORDER, rivals=True)  # "wave at the end and take the cup"
    found: list[Further] = []
    by = False
    for one in said:
        part = one.part
        if isinstance(part, Clause):
            begins = bool(part.begun) and not part.begun.endswith(_TO)
            by = begins or (by and part.form == "ing" and one.separator in _JOINS)
            if by and part.form == "ing":
                one = replace(one, part=replace(part, form="base"))
        else:
            by = False
        found.append(one)
    return found
