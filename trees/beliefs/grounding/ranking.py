"""Sizes and orders: which of the things that fit is the biggest, the leftmost, the second."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from types import MappingProxyType

import numpy as np

from trees.beliefs.grounding.choice_words import CLEARLY_LARGER
from trees.beliefs.grounding.spatial_relation import APART_M
from trees.beliefs.grounding.unmatched import NoneFitsError, UntellableError
from trees.beliefs.scene.believed_thing import BelievedThing

_SIZES: Mapping[str, tuple[str, bool]] = MappingProxyType(
    {
        **dict.fromkeys(("small", "smaller", "little", "tiny"), ("volume", False)),
        **dict.fromkeys(("big", "bigger", "large", "larger", "huge"), ("volume", True)),
        **dict.fromkeys(("smallest",), ("volume", False)),
        **dict.fromkeys(("biggest", "largest"), ("volume", True)),
        **dict.fromkeys(("tall", "taller", "tallest", "high"), ("height", True)),
        **dict.fromkeys(("short", "shorter", "shortest", "low"), ("height", False)),
        **dict.fromkeys(("wide", "wider", "widest", "thick"), ("radius", True)),
        **dict.fromkeys(
            ("narrow", "narrower", "narrowest", "thin", "thinner", "thinnest"), ("radius", False)
        ),
    }
)
_MEASURES: Mapping[str, tuple[Callable[[BelievedThing], float], float]] = MappingProxyType(
    {
        "volume": (lambda thing: thing.volume_m3, CLEARLY_LARGER),
        "height": (lambda thing: 2.0 * thing.half_height_m, CLEARLY_LARGER ** (1 / 3)),
        "radius": (lambda thing: thing.radius_m, CLEARLY_LARGER ** (1 / 3)),
    }
)


def there_are(count: int) -> str:
    """Say how many there are: "there are 3"."""
    return "there is 1" if count == 1 else f"there are {count}"


def sized(size: str, fitting: list[BelievedThing], noun: str) -> list[BelievedThing]:
    """The extreme of those that fit; "big" is all that are clearly larger than the smallest."""
    if size not in _SIZES:
        raise UntellableError(f"which one is {size}? that cannot be seen", fitting)
    if len(fitting) == 1:
        return fitting
    measure_name, largest = _SIZES[size]
    measure, ratio = _MEASURES[measure_name]
    values = sorted(measure(thing) for thing in fitting)
    if values[-1] < ratio * values[0]:
        raise UntellableError(f"which one is the {size} one? they are of nearly one size", fitting)
    if compares_all(size):
        extreme = values[-1] if largest else values[0]
        return [
            thing for thing in fitting if max(measure(thing), extreme) < ratio * min(measure(thing), extreme)
        ]
    middle = (values[0] * values[-1]) ** 0.5
    kept = [thing for thing in fitting if (measure(thing) > middle) == largest]
    if not kept:
        raise NoneFitsError(f"no {noun} seen", True)
    return kept


def compares_all(size: str | None) -> bool:
    """Whether a word is one of size, and means the extreme of all: "biggest", "bigger"."""
    return size is not None and size in _SIZES and size.endswith(("st", "er"))


_NUMBERS: Mapping[str, int] = MappingProxyType(
    {
        **{word: i for i, word in enumerate(
            ("first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth", "ninth", "tenth"), 1
        )},
        **{f"{i}{end}": i for i, end in enumerate(("st", "nd", "rd", *["th"] * 7), 1)},
    }
)  # fmt: skip


ASIDE_M = 0.25
"""What stands so far to the right is not "the left one", if there is no other."""

ORDER_WORDS = frozenset(
    {
        *(
            "leftmost",
            "left",
            "rightmost",
            "right",
            "nearest",
            "closest",
            "nearer",
            "closer",
            "middle",
            "central",
        ),
        *("farthest", "furthest", "farther", "further", "topmost", "lowest", "last", "other"),
    }
)
"""Single words that pick one thing from a row."""

PLACES: Mapping[str, str] = MappingProxyType(
    {
        **dict.fromkeys(("top", "topmost", "upper"), "top"),
        **dict.fromkeys(("middle", "central"), "middle"),
        **dict.fromkeys(("bottom", "lowest", "lower"), "bottom"),
        **dict.fromkeys(("left", "leftmost"), "left"),
        **dict.fromkeys(("right", "rightmost"), "right"),
    }
)
"""Words for a place in a row or a column, each by the plainest that means it."""

SIZE_WORDS = frozenset(_SIZES)
"""Words that compare sizes."""


def ordered(ordinal: str, fitting: list[BelievedThing], noun: str) -> list[BelievedThing]:
    """The one that an ordinal picks; those that cannot be told apart in that order are all kept."""
    words = ordinal.replace("_", " ").split()
    word = words[0] if words else ""
    side = "right" if words[-1:] == ["right"] else "left"
    if len(fitting) == 1 and (aside := wrong_side(ordinal, fitting[0])) is not None:
        raise NoneFitsError(f"no {noun} seen; the only one is on the {aside}", True)
    if PLACES.get(ordinal) == "left":
        return least(fitting, lambda thing: -float(thing.place_m[1]))
    if PLACES.get(ordinal) == "right":
        return least(fitting, lambda thing: float(thing.place_m[1]))
    if word in ("nearest", "closest", "nearer", "closer", "front"):
        return least(fitting, lambda thing: thing.distance_m)
    if word in ("farthest", "furthest", "farther", "further", "back", "rear"):
        return least(fitting, lambda thing: -thing.distance_m)
    if PLACES.get(word) == "top":
        return least(fitting, lambda thing: -thing.top_m)
    if PLACES.get(word) == "bottom":
        return least(fitting, lambda thing: thing.bottom_m)
    number = len(fitting) if word == "last" else _NUMBERS.get(word)
    if PLACES.get(word) == "middle":
        if len(fitting) % 2 == 0:
            raise UntellableError(f"which one is in the middle? there are {len(fitting)}", fitting)
        number = len(fitting) // 2 + 1
        if _is_column(fitting):
            return _nth(fitting, lambda thing: -thing.top_m, number)
    if number is None or (len(words) > 1 and words[1:] not in (["from", "the", side], ["from", side])):
        raise UntellableError(f"which one is the {ordinal.replace('_', ' ')} one?", fitting)
    if number > len(fitting):
        raise NoneFitsError(f"no {noun} seen; {there_are(len(fitting))} of the kind", True)
    sign = 1.0 if side == "right" else -1.0
    return _nth(fitting, lambda thing: sign * float(thing.place_m[1]), number)


def _is_column(things: Sequence[BelievedThing]) -> bool:
    """Whether things are above one another, as the drawers of a chest are, and not beside."""
    places = np.array([thing.place_m for thing in things])
    return float(np.ptp(places[:, 2])) > float(np.linalg.norm(np.ptp(places[:, :2], axis=0)))


def wrong_side(ordinal: str, only: BelievedThing) -> str | None:
    """On which side the only thing is, where "the left one" is said and it stands clearly on the right."""
    y_m = float(only.place_m[1])
    if PLACES.get(ordinal) == "left" and y_m < -ASIDE_M:
        return "right"
    return "left" if PLACES.get(ordinal) == "right" and y_m > ASIDE_M else None


def least(things: list[BelievedThing], key: Callable[[BelievedThing], float]) -> list[BelievedThing]:
    """The one with the least value, and all that perception cannot tell from it."""
    return _nth(things, key, 1)


def _nth(
    things: list[BelievedThing], key: Callable[[BelievedThing], float], number: int
) -> list[BelievedThing]:
    ordered = sorted(things, key=lambda thing: (key(thing), thing.name))
    if not ordered:
        return []
    value = key(ordered[number - 1])
    return [thing for thing in ordered if abs(key(thing) - value) <= APART_M]
