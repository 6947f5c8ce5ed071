"""Words that tell things apart, for the choices of a question."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from trees.beliefs.grounding.spatial_relation import APART_M
from trees.beliefs.scene.believed_thing import BelievedThing

CLEARLY_LARGER = 1.25
"""Ratio of volumes from which people call one of two things the bigger: 8 % along each edge, several
times what a size is misjudged by."""


def from_the_left(things: Sequence[BelievedThing]) -> list[BelievedThing]:
    """In the order in which the robot sees them, from its left to its right."""
    return sorted(things, key=lambda thing: (-float(thing.place_m[1]), float(thing.place_m[0]), thing.name))


def told_apart(things: Sequence[BelievedThing]) -> list[tuple[BelievedThing, str]]:
    """Each thing with words that fit no other of them, from the left to the right."""
    ordered = from_the_left(things)
    told: dict[str, str] = {}
    for words in dict.fromkeys(thing.words for thing in ordered):
        alike = [thing for thing in ordered if thing.words == words]
        told.update(zip([thing.name for thing in alike], _told(words, alike), strict=True))
    return [(thing, told[thing.name]) for thing in ordered]


def _told(words: str, alike: list[BelievedThing]) -> list[str]:
    """Words for things of one colour and kind: by side, by distance, by size, or by measure."""
    if len(alike) == 1:
        return [words]
    places = [float(thing.place_m[1]) for thing in alike]
    if all(left - right > APART_M for left, right in pairwise(places)):
        return [f"{side} {words}" for side in _sides(len(alike))]
    if len(alike) == 2:
        first, second = (thing.distance_m for thing in alike)
        if abs(first - second) > APART_M:
            return [f"{'nearer' if one else 'farther'} {words}" for one in (first < second, second < first)]
        first, second = (thing.volume_m3 for thing in alike)
        if max(first, second) > CLEARLY_LARGER * min(first, second):
            return [f"{'bigger' if one else 'smaller'} {words}" for one in (first > second, second > first)]
    return [
        f"{words} {x:.2f} m ahead, {abs(y):.2f} m to the {'left' if y > 0 else 'right'}, {z:.2f} m high"
        for x, y, z in (thing.place_m for thing in alike)
    ]


def _sides(count: int) -> list[str]:
    if count == 2:
        return ["left", "right"]
    if count == 3:
        return ["left", "middle", "right"]
    names = ("first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth", "ninth", "tenth")
    return [names[i] if i < len(names) else f"{i + 1}th" for i in range(count)]
