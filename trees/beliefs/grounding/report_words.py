"""What was seen, in words for people."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence

from trees.beliefs.scene.believed_thing import BelievedThing
from trees.beliefs.scene.scene_update import kind_of
from trees.tasks import Count

# Nearer to the line straight ahead than this, a thing is on neither side.
_STRAIGHT_M = 0.05

_IRREGULAR = {"box": "boxes", "shelf": "shelves", "person": "people"}
_NUMBERS = ("no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten")


def plural(words: str, count: int) -> str:
    """Words as one or as many, with the number: "two red cups"."""
    number = _NUMBERS[count] if count < len(_NUMBERS) else str(count)
    if count == 1:
        return f"{number} {words}"
    return f"{number} {_many(words)}"


def numbered(words: str, count: Count) -> str:
    """Words with how many are meant: "the red cup", "two red cups", "all red cups"."""
    if count == 1:
        return f"the {words}"
    return plural(words, count) if isinstance(count, int) else f"{count} {_many(words)}"


def _many(words: str) -> str:
    *before, noun = words.split()
    return " ".join([*before, _IRREGULAR.get(noun, noun + "s")])


def listed(parts: Sequence[str]) -> str:
    """Parts as people list them: "a, b and c"."""
    if len(parts) < 2:
        return "".join(parts)
    return f"{', '.join(parts[:-1])} and {parts[-1]}"


def kinds_in(names: Iterable[str]) -> str:
    """What names of a scene stand for, each kind once: "red cup, table"; a leg is no second table."""
    return ", ".join(sorted(set(map(kind_of, names)))) or "nothing"


def counted(things: Iterable[BelievedThing]) -> list[str]:
    """How many there are of each, from the most common on: "two red cups", "one blue box"."""
    counts = Counter(thing.words for thing in things)
    return [plural(words, count) for words, count in sorted(counts.items(), key=_commonest)]


def _commonest(item: tuple[str, int]) -> tuple[int, str]:
    return -item[1], item[0]


def whereabouts(thing: BelievedThing) -> str:
    """Where a thing is: "on the table, 0.45 m ahead, 0.20 m to the right"."""
    on = f"on the {kind_of(thing.support)}, " if thing.support else ""
    return on + direction(float(thing.place_m[0]), float(thing.place_m[1]))


def direction(ahead_m: float, left_m: float) -> str:
    """A place on the floor, seen from the robot: "1.20 m behind me, 0.20 m to the right"."""
    along = f"{abs(ahead_m):.2f} m {'ahead' if ahead_m >= 0.0 else 'behind me'}"
    if abs(left_m) <= _STRAIGHT_M:
        return along
    return f"{along}, {abs(left_m):.2f} m to the {'left' if left_m > 0.0 else 'right'}"
