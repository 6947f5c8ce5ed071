"""Waving at people, looking and pointing at what is named."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from executive.language.commands import meanings
from executive.language.commands.going import target
from executive.language.phrases.arranging import clause, trouble, unfit
from executive.language.phrases.handled_thing import IT
from executive.language.phrases.parts import Parts, senses, words
from executive.language.phrases.values import Clause, Hand, Item, Items, Nominal, draft


def _each(parts: Parts) -> list[tuple[Nominal, str | None]]:
    """Whom or what a gesture is aimed at, and with which hand; one without an aim is aimed at nothing.

    Raises:
        TroubleError: Somebody is named beside "her", who may be the same: "wave to Ana and her".
    """
    items: Sequence[Item] = next((part.each for part in parts if isinstance(part, Items)), ())
    him = [item.of.reference in ("him", "them") for item in items]
    if any(him) and any(item.of.is_person and not item.of.reference for item in items):
        raise trouble("who is meant?", asks=True)
    each = []
    for item in items:
        rest = tuple(one for one in item.details if not isinstance(one, Hand))
        each.append((target(Item(item.of, rest)), _side((*parts, *item.details))))
    return each


def _side(parts: Sequence[Any]) -> str | None:
    sides = {part.side for part in parts if isinstance(part, Hand)}
    sides |= {word.meaning for word in words(parts, "LEFT_RIGHT")}
    if len(sides) > 1:
        raise unfit()
    return next(iter(sides), None)


def somebody(nominal: Nominal, doing: str) -> Nominal:
    """Who is named, or "them", who may be one person of whom no more is known.

    Raises:
        TroubleError: It is a thing, or "it".
    """
    if nominal.reference == "it":
        raise trouble("who is meant?", asks=True)
    if not nominal.is_person and nominal.reference != "them":
        raise trouble(f"{doing} {nominal.kind or 'a thing'}: only a person can be meant", nominal.kind)
    return nominal


def _wave(parts: Parts) -> Clause:
    bundles = [(draft("wave", person=somebody(of, "waving at"), hand=side),) for of, side in _each(parts)]
    return clause(parts, bundles or [(draft("wave", hand=_side(parts)),)])


def _point(parts: Parts) -> Clause:
    items = next(part for part in parts if isinstance(part, Items))
    if "aim" in senses(parts, "POINT_AT") and any(item.details for item in items.each):
        raise unfit()  # "point the lamp at the table"
    aimed = [(draft("point_at", **{_slot(of): of}, hand=side),) for of, side in _each(parts)]
    return clause(parts, aimed)


def _look(parts: Parts) -> Clause:
    into = "into" in senses(parts, "LOOK_AT")
    bundles = []
    for of, side in _each(parts):
        if side is not None:
            raise unfit()
        if into and of.anaphoric:
            raise trouble("which one is meant?", asks=True)  # "take the pen, then look in the right one"
        inside = (into and of.sort == "container") or None
        bundles.append((draft("look_at", **{_slot(of): of}, looks_in=inside),))
    return clause(parts, bundles)


def _slot(of: Nominal) -> str:
    return "person" if of.is_person else "to" if of.is_place else "object"


def _look_inside(parts: Parts) -> Clause:
    return clause(parts, [(draft("look_at", object=IT, inside=True),)])


MEANINGS = meanings(
    {
        "wave": _wave,
        "point": _point,
        "look": _look,
        "look_inside": _look_inside,
    }
)
