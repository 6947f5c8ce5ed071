"""How many things or people are looked for: one, as many as are said, or all that a plural names."""

from __future__ import annotations

from dataclasses import replace

from executive.language.phrases.arranging import trouble
from executive.language.phrases.values import Draft, Nominal, draft
from executive.vocabulary.inflection import plural

_PEOPLE = "person"
"""The only word for several people whom perception can tell from anybody else."""


def looked_for(nominal: Nominal, source: Nominal | None, *, existing: bool) -> Draft:
    """The task of looking for something.

    Which one is asked where several cannot be told: pieces of furniture are seen in parts, and "some" is no
    number. The question comes with the task, for other readings know better: "find some cups and count
    them".

    Args:
        nominal: What is looked for.
        source: Where it is said to be.
        existing: Whether it is asked if there is any such thing, be it one or several.

    Raises:
        TroubleError: It is asked whether there are so many.
    """
    if existing and nominal.counted:
        raise trouble("whether there are so many is not told; they can be counted", str(nominal.count))
    count = 1 if existing else _how_many(nominal)
    if existing and nominal.is_person:
        nominal = replace(nominal, plural=False)  # "are there any people": one is enough
    slot = "person" if nominal.is_person else "object"
    thing = {slot: replace(nominal, count=count)}
    told = draft("find", **thing, source=source, count=None if count == 1 else count)
    unclear = f"which one of the {plural(nominal.kind or 'thing')}?"
    return told if count == 1 or _can_be_several(nominal) else told.with_slot("one_of", unclear)


def _how_many(nominal: Nominal) -> int | str:
    """The slot ``count``: a bare plural is satisfied by one ("find cups"), "the cups" are all of them."""
    if nominal.reference:
        return 1
    if nominal.counted or nominal.is_vague:
        return nominal.count
    return "all" if nominal.plural and nominal.determined else 1


def _can_be_several(nominal: Nominal) -> bool:
    if nominal.is_vague or nominal.is_place:
        return False
    return nominal.kind == _PEOPLE if nominal.is_person else True
