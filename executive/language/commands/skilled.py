"""Skills of which the grammar knows only the words, said alone or of whom or what they are aimed at.

"Take a bow", "bow to Ana", "guide Ana to the kitchen": whom or what it is said of fills the slot of the task
that is for it: ``person``, ``to`` for a place, or ``object``.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import fields
from types import MappingProxyType

from executive.language.commands.going import target
from executive.language.phrases.arranging import clause, guarded, trouble
from executive.language.phrases.parts import Parts, words
from executive.language.phrases.values import Clause, Draft, Item, Meaning, Nominal, draft
from executive.language.resolve.kinds import task_type
from executive.language.text.word import Word


def _skilled(parts: Parts) -> Clause:
    (verb,) = words(parts, "SKILL", "SKILL_AT")
    action = verb.meaning.partition(":")[0]
    slots: dict[str, Nominal] = {}
    for part in parts:
        if isinstance(part, Item):
            nominal = target(part)
            slots["person" if nominal.is_person else "to" if nominal.is_place else "object"] = nominal
        elif isinstance(part, Nominal):
            slots["to"] = part
    return clause(parts, [(_checked(verb, action, slots),)])


def _checked(verb: Word, action: str, slots: Mapping[str, Nominal]) -> Draft:
    """A draft of slots that tasks of this skill have.

    Raises:
        TroubleError: There is no such skill here, or it is done to nothing of this sort.
    """
    kind = task_type(action)
    if kind is None:
        raise trouble(f"{verb.said!r}: {action!r} is no skill of this robot", verb.said)
    known = {field.name for field in fields(kind)}
    for slot, nominal in slots.items():
        if slot not in known:
            what = nominal.said or nominal.kind or "that"
            raise trouble(f"{verb.said!r} is not done to {what!r}", nominal.kind)
    return draft(action, **slots)


MEANINGS: Mapping[str, Meaning] = MappingProxyType({"skilled": guarded(_skilled)})
