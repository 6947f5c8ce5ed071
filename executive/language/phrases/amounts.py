"""How many things are meant: numbers, "both", "all", "some", "one of"."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from executive.language.phrases.features import COUNTED_FROM, of_noun
from executive.language.phrases.parts import Parts, always, words
from executive.language.phrases.values import Meaning, Nominal, Trouble

MAX_COUNT = 20
"""More things at once than anybody means; beyond it the number is taken for a mistake."""

WHICH_OBJECT = Trouble("which object is meant?", asks=True)
"""The question where nothing tells what is meant."""

WHICH_GLASSES = Trouble("glasses to see with, or to drink from?", asks=True)


def _several(nominal: Nominal, parts: Parts) -> Nominal | Trouble | None:
    """Two cups, both cups, all three cups, every cup."""
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
    if nominal.kind == "glasses" and count == "all":
        return WHICH_GLASSES
    plural = nominal.plural or bool(every or words(parts, "ALL"))
    return replace(nominal, count=count, counted=True, determined=True, plural=plural)


def _one_of(nominal: Nominal, parts: Parts) -> Nominal | None:
    """One of the cups, the biggest of the two cups."""
    if not nominal.plural:
        return None
    if nominal.ordinal in COUNTED_FROM and any(word.meaning == "a" for word in words(parts, "DET")):
        return None  # "a third of the cups"
    return replace(nominal, plural=False, determined=True)


def _some(nominal: Nominal, parts: Parts) -> Nominal | None:
    """A few cups, some cups: nobody knows how many; some water, any cup: one."""
    (many,) = words(parts, "MANY")
    if not nominal.plural and many.meaning != "some":
        return None
    return replace(nominal, count=many.meaning if nominal.plural else 1, determined=True, indefinite=True)


MEANINGS: Mapping[str, Meaning] = {
    "several": of_noun(_several),
    "one_of": of_noun(_one_of),
    "some": of_noun(_some),
    "everything": always(Nominal("any", count="all", counted=True, plural=True, determined=True)),
    "vague": always(WHICH_OBJECT),
}
