"""How far, how long and how fast: numbers in digits and words, with their units."""

from __future__ import annotations

from collections.abc import Mapping

from executive.language.phrases.parts import Parts, words
from executive.language.phrases.values import Meaning, Measure, Quantity

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
        elif index and value >= _least_unit(total):
            return None
        else:
            total += value
    return total


def _least_unit(number: float) -> float:
    """What has to be more than whatever is added to a number: five, to a hundred and to twenty."""
    if number % 100 == 0:
        return 100.0
    return 10.0 if number % 10 == 0 and number % 100 >= 20 else 1.0


def _decimal(parts: Parts) -> float | None:
    """One point five."""
    whole, fraction = words(parts, "AMOUNT")
    return float(f"{whole.meaning}.{fraction.meaning}") if len(fraction.meaning) == 1 else None


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
    "duration": _measure("duration"),
    "distance": _measure("distance"),
    "angle": _measure("angle"),
    "linear_speed": _measure("linear_speed"),
    "angular_speed": _measure("angular_speed"),
    "amount": _number,
    "number": _number,
    "decimal": _decimal,
    "fraction": _fraction,
}
