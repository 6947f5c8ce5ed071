"""How many things are meant: numbers, "both", "all", "some", "one of"."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from types import MappingProxyType

from executive.language.phrases.features import COUNTED_FROM, described, rank_of
from executive.language.phrases.parts import Parts, nominal_of, words
from executive.language.phrases.values import Meaning, Nominal, Trouble

MAX_COUNT = 20
"""More things at once than anybody means; beyond it the number is taken for a mistake."""

WHICH_OBJECT = Trouble("which object is meant?", asks=True)
"""The question where nothing tells what is meant."""


def _several(parts: Parts) -> Nominal | Trouble | None:
    """Two cups, both cups, all three cups, every cup."""
    nominal = described(nominal_of(parts), parts)
    if not isinstance(nominal, Nominal):
        return nominal
    couple, both, every = words(parts, "COUPLE"), words(parts, "BOTH"), words(parts, "EVERY")
    numbers = [part for part in parts if isinstance(part, float)] + [float(one.meaning) for one in couple]
    number = next(iter(numbers), None)
    many = nominal.plural or (nominal.mass and not (couple or both))
    count: int | str | None = "both" if both else "all" if every or words(parts, "ALL") else None
    if number is not None and not (number.is_integer() and 1 <= number <= MAX_COUNT):
        told = f"{number:g} things at once: a whole number from 1 to {MAX_COUNT} is understood"
        return Trouble(told, f"{number:g}")
    if number is not None and (count is None or number > 1):
        count = int(number)
    every_other = every and nominal.ordinal == "other" and not nominal.plural
    if count is None or every_other or not (many or every or count == 1):
        return None
    if nominal.anaphoric and count == 1:
        return None
    if count != 1 and rank_of(nominal) not in (None, "other"):
        return Trouble(one_by_one(str(rank_of(nominal))), rank_of(nominal))
    plural = nominal.plural or bool(every or words(parts, "ALL"))
    return replace(nominal, count=count, counted=True, determined=True, plural=plural)


def one_by_one(rank: str) -> str:
    """Why several things cannot be chosen by what only one of them can be."""
    return f"{rank!r} is one of them; name several things one by one"


def _one_of(parts: Parts) -> Nominal | Trouble | None:
    """One of the cups, the biggest of the two cups."""
    nominal = described(nominal_of(parts), parts)
    if not isinstance(nominal, Nominal) or not nominal.plural:
        return nominal if isinstance(nominal, Trouble) else None
    if nominal.ordinal in COUNTED_FROM and any(word.meaning == "a" for word in words(parts, "DET")):
        return None  # "a third of the cups"
    return replace(nominal, plural=False, determined=True)


def _some(parts: Parts) -> Nominal | Trouble | None:
    """A few cups, some cups: nobody knows how many; some water, any cup: one."""
    nominal = described(nominal_of(parts), parts)
    (many,) = words(parts, "MANY")
    if not isinstance(nominal, Nominal) or not (nominal.plural or many.meaning == "some"):
        return nominal if isinstance(nominal, Trouble) else None
    return replace(nominal, count=many.meaning if nominal.plural else 1, determined=True, indefinite=True)


def _everything(_parts: Parts) -> Nominal:
    return Nominal("any", count="all", counted=True, plural=True, determined=True)


def _vague(_parts: Parts) -> Trouble:
    return WHICH_OBJECT


MEANINGS: Mapping[str, Meaning] = MappingProxyType(
    {
        "several": _several,
        "one_of": _one_of,
        "some": _some,
        "everything": _everything,
        "vague": _vague,
    }
)
