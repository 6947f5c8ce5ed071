"""How far, how long, how fast and how many: numbers in digits and words, with their units."""

from __future__ import annotations

import math
from collections.abc import Mapping
from types import MappingProxyType

from executive.language.phrases.parts import Parts, words
from executive.language.phrases.values import Meaning, Measure, Quantity, Trouble
from executive.language.text.word import Word

_DENOMINATORS = range(2, 11)
"""What people divide a metre or a minute by."""


def _measure(of: Quantity) -> Meaning:
    def meaning(parts: Parts) -> Measure:
        unit = next(part for part in reversed(parts) if isinstance(part, Word))
        number = next(part for part in parts if isinstance(part, float))
        return Measure(of, number * float(unit.meaning), f"{number:g}")

    return meaning


def _distances(parts: Parts) -> Measure | None:
    """One meter twenty centimeters."""
    return _larger_first("distance", "LENGTH", parts)


def _durations(parts: Parts) -> Measure | None:
    """One minute and thirty seconds: the larger unit first."""
    return _larger_first("duration", "TIME", parts)


def _larger_first(of: Quantity, unit_class: str, parts: Parts) -> Measure | None:
    numbers = [part for part in parts if isinstance(part, float)]
    units = [float(word.meaning) for word in words(parts, unit_class)]
    joined = all(word.said in ("and", "&") for word in words(parts, "AND"))
    if len(numbers) != 2 or units[0] <= units[1] or not joined:
        return None
    total = sum(number * unit for number, unit in zip(numbers, units, strict=True))
    return Measure(of, total, f"{total:g}")


def _and_a_half(of: Quantity, unit_class: str) -> Meaning:
    """A minute and a half."""

    def meaning(parts: Parts) -> Measure:
        unit = float(words(parts, unit_class)[0].meaning)
        number = sum(float(word.meaning) for word in words(parts, "ARTICLE", "AMOUNT", "AND_A_HALF"))
        return Measure(of, number * unit, f"{number:g}")

    return meaning


def _amount(parts: Parts) -> float | None:
    numbers = [
        float(part.meaning) for part in parts if isinstance(part, Word) and part.word_class != "BULLET"
    ]
    if len(numbers) == 2:
        tens, ones = numbers
        return tens + ones if 20 <= tens < 100 and 1 <= ones <= 9 else None
    return numbers[0]


def _number(parts: Parts) -> float | None:
    found = [part for part in parts if isinstance(part, Word) and part.word_class != "BULLET"]
    if found[0].word_class == "HALF":
        return 0.5
    if len(found) == 1:
        return float(found[0].meaning)
    first, second = found
    if second.word_class == "QUARTERS":
        return float(first.meaning) * float(second.meaning)
    if second.word_class == "TENS":
        return float(first.meaning) * 100 if second.meaning == "100" else None
    return _amount(parts) if first.word_class == "TENS" else float(first.meaning) + float(second.meaning)


def _hundreds(parts: Parts) -> float | None:
    """A hundred and twenty."""
    found = words(parts, "AMOUNT", "ARTICLE", "TENS")
    if any(word.said not in ("and", "&") for word in words(parts, "AND")):
        return None
    index = next((index for index, word in enumerate(found[:2]) if word.meaning == "100"), None)
    rest = () if index is None else found[index + 1 :]
    below = _amount(tuple(rest)) if rest else None
    if index is None or below is None or not 1 <= below < 100:
        return None
    return 100 * (float(found[0].meaning) if index else 1) + below


def _decimal(parts: Parts) -> float | None:
    whole, _, fraction = parts
    return float(whole.meaning) + float(fraction.meaning) / 10 if float(fraction.meaning) < 10 else None


def _fraction(parts: Parts) -> float | None:
    """1/2, and 2 1/2: a whole number and a part of one."""
    numbers = [float(word.meaning) for word in words(parts, "NUM")]
    *whole, above, below = numbers
    if not all(one.is_integer() for one in numbers) or below not in _DENOMINATORS or not 0 < above < below:
        return None
    return sum(whole) + above / below


def _point(parts: Parts) -> float | None:
    """Point five; what follows is a digit."""
    (digit,) = words(parts, "AMOUNT")
    return float(f"0.{digit.meaning}") if len(digit.meaning) == 1 else None


def _angle_of_pi(parts: Parts) -> Measure | None:
    """Pi, pi/2, 2 pi: radians, whether they are called so or not."""
    if any(unit.meaning != "1" for unit in words(parts, "ANGLE")):
        return None
    pi = next(index for index, part in enumerate(parts) if getattr(part, "word_class", "") == "PI")
    factors = [float(word.meaning) for word in words(parts[:pi], "NUM", "AMOUNT")]
    divided = [float(word.meaning) for word in words(parts[pi:], "NUM")]
    if 0.0 in divided:
        return None
    value = math.pi * math.prod(factors) / math.prod(divided)
    return Measure("angle", value, f"{value:g}")


def _part_turn(parts: Parts) -> Measure:
    """A quarter turn."""
    (turn,) = words(parts, "PART_TURN")
    return Measure("angle", float(turn.meaning), turn.said)


def _said_again(parts: Parts) -> Measure | None:
    """A little bit, like half a meter: as much as is said then."""
    commas = all(mark.meaning == "," for mark in words(parts, "PAUSE"))
    measure: Measure = parts[-1]
    return measure if commas and measure.of in ("distance", "duration", "angle") else None


def _paces(parts: Parts) -> Trouble:
    (pace,) = words(parts, "PACES")
    return Trouble(f"{pace.said!r}: how long one is cannot be told; say it in metres", pace.said)


MEANINGS: Mapping[str, Meaning] = MappingProxyType(
    {
        "duration": _measure("duration"),
        "durations": _durations,
        "distances": _distances,
        "duration_and_a_half": _and_a_half("duration", "TIME"),
        "distance_and_a_half": _and_a_half("distance", "LENGTH"),
        "distance": _measure("distance"),
        "angle": _measure("angle"),
        "linear_speed": _measure("linear_speed"),
        "angular_speed": _measure("angular_speed"),
        "amount": _amount,
        "number": _number,
        "decimal": _decimal,
        "hundreds": _hundreds,
        "fraction": _fraction,
        "point_five": _point,
        "angle_of_pi": _angle_of_pi,
        "part_turn": _part_turn,
        "paces": _paces,
        "said_again": _said_again,
    }
)
