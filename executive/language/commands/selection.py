"""Answers that tell one thing from others: "the left one", "red", "the one next to the box"."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from executive.language.commands import meanings
from executive.language.commands.going import target
from executive.language.phrases.features import described
from executive.language.phrases.values import Item, Nominal, Trouble, Where
from executive.language.resolve.references import Resolver, UnresolvedError
from trees.tasks import ObjectDescription


@dataclass(frozen=True, slots=True)
class Selection:
    """What tells the thing from others."""

    of: Nominal


def _selection(parts: tuple[Any, ...]) -> Selection | Trouble | None:
    items = [part for part in parts if isinstance(part, Item)]
    if items:
        nominal = target(items[0])
    else:
        one = described(Nominal("any"), parts)
        if not isinstance(one, Nominal):
            return one
        nominal = target(Item(one, tuple(part for part in parts if isinstance(part, Where))))
    if (
        nominal.reference
        or nominal.is_person
        or (nominal.sort == "any" and nominal.is_plain and nominal.kind is None)
    ):
        return None
    return Selection(nominal)


def description_of(selection: Selection) -> ObjectDescription | None:
    """The description that is compared with what is seen."""
    try:
        described = Resolver().description(selection.of)
    except UnresolvedError:
        return None
    return described if isinstance(described, ObjectDescription) else None


MEANINGS = meanings({"selection": _selection})
