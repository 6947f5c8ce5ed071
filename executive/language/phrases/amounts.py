"""How many things are meant, and how far, how long and how fast: numbers in digits and words."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from executive.language.phrases.features import COUNTED_FROM, of_noun
from executive.language.phrases.parts import Parts, always, words
from executive.language.phrases.values import Meaning, Measure, Nominal, Quantity, Trouble

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
    fits = not nominal.anaphoric if count == 1 else many or every
    if count is None or every_other or not fits:
        return None
    if nominal.kind == "glasses" and count == "all":
        return WHICH_GLASSES
    plural = nominal.plural or bool(every or words(parts, "ALL"))
    return replace(nominal, count=count, counted=True, determined=True, plural=plural)


def _one_of(nominal: Nominal, parts: Parts) -> Nominal | None:
    """One of the cups, the biggest of the two cups."""
    a_part = nominal.ordinal in COUNTED_FROM and any(word.meaning == "a" for word in words(parts, "DET"))
    if a_part or not nominal.plural:
        return None  # "a third of the cups"
    return replace(nominal, plural=False, determined=True)


def _some(nominal: Nominal, parts: Parts) -> Nominal | None:
    """A few cups, some cups: nobody knows how many; some water, any cup: one."""
    (many,) = words(parts, "MANY")
    if not nominal.plural and many.meaning != "some":
        return None
    return replace(nominal, count=many.meaning if nominal.plural else 1, determined=True, indefinite=True)


_DENOMINATORS = range(2, 11)
"""What people divide a metre or a minute by."""

_NUMBERS = ("ARTICLE", "COUPLE", "AMOUNT", "NUM", "TENS", "HALF", "QUARTER", "QUARTERS", "AND_A_HALF")
_UNITS = ("TIME", "LENGTH", "ANGLE", "LINEAR_SPEED", "ANGULAR_SPEED")


def _number(parts: Parts) -> float | None:
    """A number in digits or in words that are added: "twenty five", "a hundred and ten", "two and a half"."""
    total = 0.0
    for index, word in enumerate(words(parts, *_NUMBERS)):
        value = float(word.meaning)
        if word.word_class == "QUARTERS":
            return total * value
        if value == 100 and 1 <= total < 10:
            total *= value
        elif index and (value >= 100 or (total % 100 and value >= 10) or (total % 10 and value >= 1)):
            return None  # "five twenty"
        else:
            total += value
    return total


def _fraction(parts: Parts) -> float | None:
    """1/2, and 2 1/2: a whole number and a part of one."""
    *whole, above, below = (float(word.meaning) for word in words(parts, "NUM"))
    if not all(one.is_integer() for one in (*whole, above)) or not 0 < above < below in _DENOMINATORS:
        return None
    return sum(whole) + above / below


def _measure(of: Quantity) -> Meaning:
    def meaning(parts: Parts) -> Measure | None:
        """A number of units, or of two with the larger one first: "one minute and thirty seconds"."""
        numbers = [part for part in parts if isinstance(part, float)] or [_number(parts) or 0.0]
        units = [float(word.meaning) for word in words(parts, *_UNITS)]
        if units != sorted(set(units), reverse=True):
            return None
        total = sum(number * unit for number, unit in zip(numbers, units, strict=True))
        said = numbers[0] if len(numbers) == 1 else total
        return Measure(of, total, f"{said:g}")

    return meaning


MEANINGS: Mapping[str, Meaning] = {
    "several": of_noun(_several),
    "one_of": of_noun(_one_of),
    "some": of_noun(_some),
    "everything": always(Nominal("any", count="all", counted=True, plural=True, determined=True)),
    "vague": always(WHICH_OBJECT),
    "duration": _measure("duration"),
    "distance": _measure("distance"),
    "angle": _measure("angle"),
    "linear_speed": _measure("linear_speed"),
    "angular_speed": _measure("angular_speed"),
    "amount": _number,
    "number": _number,
    "fraction": _fraction,
}
