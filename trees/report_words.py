"""What was seen, in words for people."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence

from trees.believed_thing import BelievedThing

_IRREGULAR = {"box": "boxes", "shelf": "shelves"}
_NUMBERS = ("no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten")


def plural(words: str, count: int) -> str:
    """Words as one or as many, with the number: "two red cups"."""
    number = _NUMBERS[count] if count < len(_NUMBERS) else str(count)
    if count == 1:
        return f"{number} {words}"
    *before, noun = words.split()
    many = _IRREGULAR.get(noun, noun + "s")
    return " ".join([number, *before, many])


def listed(parts: Sequence[str]) -> str:
    """Parts as people list them: "a, b and c"."""
    if len(parts) < 2:
        return "".join(parts)
    return f"{', '.join(parts[:-1])} and {parts[-1]}"


def inventory(things: Iterable[BelievedThing]) -> str:
    """What is there, from the most common on: "two red cups and one blue box"."""
    counts = Counter(thing.words for thing in things)
    if not counts:
        return "nothing"
    return listed([plural(words, count) for words, count in sorted(counts.items(), key=_commonest)])


def _commonest(item: tuple[str, int]) -> tuple[int, str]:
    return -item[1], item[0]


def whereabouts(thing: BelievedThing) -> str:
    """Where a thing is: "on the table, 0.45 m ahead, 0.20 m to the right"."""
    x, y = float(thing.place_m[0]), float(thing.place_m[1])
    on = f"on the {thing.support}, " if thing.support else ""
    side = f", {abs(y):.2f} m to the {'left' if y > 0.0 else 'right'}" if abs(y) > 0.05 else ""
    return f"{on}{x:.2f} m ahead{side}"
