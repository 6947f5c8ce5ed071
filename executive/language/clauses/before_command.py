"""What may stand before a command: its number in a list, a hand, a place, its thing, a question about it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from types import MappingProxyType

from executive.language.clauses.statements import named_thing
from executive.language.phrases.arranging import guarded, unfit
from executive.language.phrases.parts import Parts, always, words
from executive.language.phrases.values import Clause, Hand, Item, Meaning, Trouble, Where

_OPENS_A_PHRASE = (",", ":")
"""Marks between a command and what is said of it before it."""

_NUMBERS_NOTHING = (",", "?")
"""Marks behind a number that may be how many of something."""

_WITH_A_HAND = frozenset({"pick", "place", "put_in", "hand_over", "open", "close", "wave", "point_at"})
"""Tasks of which it can be said which hand does them."""

_FOUND_SOMEWHERE = frozenset({"pick", "find", "count", "describe"})
"""Tasks of which a place before them can only say where their thing is."""


def _numbered(parts: Parts) -> int | None:
    """The number of a step, in digits, in words or as a letter."""
    number = words(parts, "NUM", "AMOUNT", "LETTER")[0].meaning
    is_step = bool(words(parts, "STEP"))
    marked = any(part.meaning not in _NUMBERS_NOTHING for part in words(parts, "PAUSE", "PAREN", "BULLET"))
    return int(number) if number.isdecimal() and (is_step or marked) else None


def _clause(parts: Parts) -> Clause | None:
    """A command, with its number."""
    command: Clause = parts[-1]
    numbers = [part for part in parts if isinstance(part, int)]
    if len(numbers) > 1:
        return None  # "turn left 90. 2. Wave"
    return replace(command, number=numbers[0]) if numbers else command


def _led(parts: Parts) -> Clause | None:
    """A command behind the hand that does it, or behind where its thing is."""
    led: Hand | Where = parts[0]
    command: Clause = parts[-1]
    if any(mark.meaning not in _OPENS_A_PHRASE for mark in words(parts, "PAUSE")):
        return None  # "the cup. With your left hand. Wave"
    by_hand = isinstance(led, Hand)
    slot, takes = ("hand", _WITH_A_HAND) if by_hand else ("source", _FOUND_SOMEWHERE)
    value = led.side if isinstance(led, Hand) else led.of
    if any(one.action not in takes or one.get(slot) is not None for one, *_ in command.bundles):
        return None
    bundles = tuple((one.with_slot(slot, value), *rest) for one, *rest in command.bundles)
    topic = isinstance(led, Where) and led.role == "is"
    return replace(command, bundles=bundles, terse=True, topic=topic, hand_first=by_hand)


def _led_by_hand(parts: Parts) -> Clause | None:
    """A command behind an order to use a hand: "use your right hand to wave"."""
    return _led((Hand(words(parts, "LEFT_RIGHT")[0].meaning), parts[-1]))


def _fronted(parts: Parts) -> Clause:
    """A command behind its thing, which it calls "it": "the red cup, pick it up"."""
    item: Item = parts[0]
    command: Clause = parts[-1]
    listed = [mark.meaning for mark in words(parts, "PAUSE")]
    if any(mark not in _OPENS_A_PHRASE for mark in listed) or len(command.bundles) != 1:
        raise unfit()
    mention = named_thing(item, sorts=frozenset({"thing", "container", "door"}))
    return replace(command, mention=mention, terse=True, topic="," in listed)


def _minding(parts: Parts) -> Clause | None:
    """A command in the form of "would you mind opening it"."""
    command: Clause = parts[-1]
    return replace(command, form="base") if command.form == "ing" else None


def _maybe_ordered(parts: Parts) -> Trouble:
    """A command that is asked about, permitted, planned or hoped for: "are you able to open the fridge?"."""
    said = words(parts, "MAYBE_ORDER")[0].said
    return Trouble("is that asked or told, or shall it be done?", said, asks=True)


MEANINGS: Mapping[str, Meaning] = MappingProxyType(
    {
        "nothing": always(""),  # a courtesy or a reason, which say nothing of what is to be done
        "numbered": _numbered,
        "clause": _clause,
        "led": _led,
        "fronted": guarded(_fronted),
        "led_by_hand": _led_by_hand,
        "minding": _minding,
        "maybe_ordered": _maybe_ordered,
    }
)
