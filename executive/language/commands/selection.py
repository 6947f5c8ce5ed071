"""Answers that tell one thing from others: "the left one", "red", "the one next to the box"."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from executive.language.commands import meanings
from executive.language.commands.going import target
from executive.language.phrases.features import described
from executive.language.phrases.values import Item, Nominal, Trouble, Where
from executive.language.resolve import places
from executive.language.resolve.discourse import Discourse, UnresolvedError
from trees.tasks import ObjectDescription


@dataclass(frozen=True, slots=True)
class Selection:
    """What tells the thing from others."""

    of: Nominal


def _selection(parts: tuple[Any, ...]) -> Selection | Trouble | None:
    item = next((part for part in parts if isinstance(part, Item)), None)
    if item is None:
        one = described(Nominal("any"), parts)
        if not isinstance(one, Nominal):
            return one
        item = Item(one, tuple(part for part in parts if isinstance(part, Where)))
    nominal = target(item)
    told = nominal.kind is not None or not nominal.is_plain
    return Selection(nominal) if told and not (nominal.reference or nominal.is_person) else None


def description_of(selection: Selection) -> ObjectDescription | None:
    """The description that is compared with what is seen."""
    try:
        described = places.described(Discourse(), selection.of)
    except UnresolvedError:
        return None
    return described if isinstance(described, ObjectDescription) else None


MEANINGS = meanings({"selection": _selection})
