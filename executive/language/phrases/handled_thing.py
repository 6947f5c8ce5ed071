"""The thing that a command is about: whether a hand can take it, and how many there are."""

from __future__ import annotations

from dataclasses import replace

from executive.language.phrases.amounts import WHICH_OBJECT
from executive.language.phrases.arranging import Arranged, TroubleError, trouble
from executive.language.phrases.values import Draft, Nominal, draft
from executive.vocabulary.inflection import plural
from trees.beliefs.grounding.articles import with_article

PREVIOUS = Nominal("any", reference="previous", determined=True)
IT = Nominal("any", reference="it", determined=True)
ASKER = Nominal("me", "me", reference="asker", determined=True)
"""Who asks for a thing, when nobody is said to get it."""

WHOEVER_IS_THERE = replace(ASKER, name="there")
"""The same, unless somebody was gone to just before: "go to Ana and pass the cup"."""

WHO_IS_MET = replace(ASKER, name="met")
"""Who was gone to just before; where that is nobody, it is asked: "hand over the cup"."""

BACK = Nominal("any", reference="there", name="back")
"""The place that a thing was taken from."""

BIN = Nominal("container", "bin")
"""Where things are thrown away."""


def thing(one: Arranged, doing: str) -> Nominal:
    """The object, if it is something that a hand can take."""
    nominal = one.object
    if nominal.is_person or nominal.is_place or nominal.sort in ("you", "animal"):
        noun = "an animal" if nominal.sort == "animal" else "the place" if nominal.is_place else "a person"
        named = f" ({nominal.kind!r})" if nominal.kind else ""
        raise trouble(f"{doing} {noun}{named} is nothing that this robot does", nominal.kind)
    unclear = nominal.plural and not (nominal.reference or nominal.counted or nominal.determined)
    if unclear or nominal.is_vague:
        raise trouble("how many of them?", asks=True)
    unnamed = nominal.sort == "any" and nominal.kind is None and not (nominal.reference or one.source)
    if unnamed and nominal.is_plain and nominal.count == 1 and not nominal.is_bare_one:
        raise TroubleError(WHICH_OBJECT)
    if nominal.plural and not nominal.reference and not nominal.counted:
        nominal = replace(nominal, count="all")
    return nominal


def count_of(nominal: Nominal) -> int | str | None:
    """The slot ``count``, unless it is one."""
    return None if nominal.count == 1 else nominal.count


def has_clear_place(one: Arranged) -> None:
    """What somebody is brought "in a cup" or "on a tray" may have to be put there.

    Raises:
        TroubleError: It is said so.
    """
    place = one.source
    if place is not None and place.indefinite and place.sort in ("thing", "any"):
        raise trouble(f"is it in or on {with_article(place.kind)}, or shall it be brought so?", asks=True)


def looked_for(nominal: Nominal, source: Nominal | None, *, existing: bool) -> Draft:
    """The task of looking for something; ``existing`` is whether it is asked if there is any such thing.

    A bare plural is satisfied by one ("find cups"), "the cups" are all of them. Where several cannot be told,
    as furniture that is seen in parts, it is asked which one is meant, whatever else the words may mean.
    """
    if existing and (nominal.counted or nominal.count == "many"):
        raise trouble("whether there are so many is not told; they can be counted", str(nominal.count))
    every = nominal.plural and nominal.determined and not (nominal.counted or nominal.is_vague)
    count = 1 if existing or nominal.reference else "all" if every else nominal.count
    if nominal.is_person and (existing or (count == 1 and nominal.traits)):
        nominal = replace(nominal, plural=False)  # "are there any people": one is enough
    thing = {"person" if nominal.is_person else "object": replace(nominal, count=count)}
    told = draft("find", **thing, source=source, count=None if count == 1 else count)
    told_apart = nominal.kind == "person" if nominal.is_person else not nominal.is_place  # guests are not
    if count == 1 or (told_apart and not nominal.is_vague):
        return told
    raise trouble(f"which one of the {plural(nominal.kind or 'thing')}?", asks=True, rivals=True)
