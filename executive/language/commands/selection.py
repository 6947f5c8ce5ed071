"""Answers that tell one thing from others: "the left one", "red", "the one next to the box"."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any

from executive.language.commands.going import target
from executive.language.phrases.arranging import guarded
from executive.language.phrases.features import described
from executive.language.phrases.values import Item, Meaning, Nominal, Trouble, Where
from executive.language.resolve import references
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
        described = references.description_of(selection.of)
    except references.UnresolvedError:
        return None
    return described if isinstance(described, ObjectDescription) else None


MEANINGS: Mapping[str, Meaning] = MappingProxyType({"selection": guarded(_selection)})
