"""The thing that a command is about: whether a hand can take it, and how many there are."""

from __future__ import annotations

from dataclasses import replace

from executive.language.phrases.arranging import Arranged, trouble
from executive.language.phrases.parts import Parts
from executive.language.phrases.values import Item, Nominal
from executive.language.text.word import Word
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

TRASH = "trash"
"""A word for the bin that says where a thing goes, or is: "the can in the trash"."""


def thing(one: Arranged, doing: str) -> Nominal:
    """The object, if it is something that a hand can take."""
    nominal = one.object
    if nominal.is_person or nominal.sort == "you":
        told = f"{doing} a person" + (f" ({nominal.kind!r})" if nominal.kind else "")
        raise trouble(f"{told} is nothing that this robot does", nominal.kind)
    if nominal.sort == "animal":
        raise trouble(f"{doing} an animal ({nominal.kind!r}) is nothing that this robot does", nominal.kind)
    if nominal.is_place:
        raise trouble(
            f"{doing} the {nominal.kind} ({nominal.kind!r}) is nothing that this robot can do", nominal.kind
        )
    unclear = nominal.plural and not nominal.reference and not nominal.counted and not nominal.determined
    if unclear or nominal.is_vague:
        raise trouble("how many of them?", asks=True)
    if (
        nominal.sort == "any"
        and nominal.kind is None
        and not nominal.reference
        and nominal.is_plain
        and nominal.count == 1
        and not nominal.is_bare_one
        and one.source is None
    ):
        raise trouble("which object is meant?", asks=True)
    if nominal.plural and not nominal.reference and not nominal.counted:
        nominal = replace(nominal, count="all")
    return nominal


def count_of(nominal: Nominal) -> int | str | None:
    """The slot ``count``, unless it is one."""
    return None if nominal.count == 1 else nominal.count


def with_it(parts: Parts) -> Parts:
    """With the thing that a terse command leaves out: "take the cup, place on the shelf"."""
    return (*(part for part in parts if isinstance(part, Word)), Item(IT), *parts[1:])


def only_for(one: Arranged, person: Nominal) -> None:
    """Nobody else may be named to get it: "hand the cup for Ana to Ben".

    Raises:
        TroubleError: Somebody is.
    """
    named = one.person
    if named is not None and named.sort != "me" and named != person:
        raise trouble(f"is it for {named.kind} or for {person.kind}?", asks=True)


def has_clear_place(one: Arranged) -> None:
    """What somebody is brought "in a cup" or "on a tray" may have to be put there.

    Raises:
        TroubleError: It is said so.
    """
    place = one.source
    if place is not None and place.indefinite and place.sort in ("thing", "any"):
        raise trouble(f"is it in or on {with_article(place.kind)}, or shall it be brought so?", asks=True)
