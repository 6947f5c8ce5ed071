"""What may stand before a command: its number in a list, a hand, a place, who is to do it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from types import MappingProxyType
from typing import Any

from executive.language.clauses.neighbours import WITH_A_HAND
from executive.language.clauses.scopes import Separator
from executive.language.commands.placing import MEANINGS as PLACING
from executive.language.phrases.arranging import ME
from executive.language.phrases.parts import Parts, words
from executive.language.phrases.values import Clause, Draft, Hand, Item, Meaning, Nominal, Trouble, Where


class _Nothing:
    """A part that says nothing of its own."""

    __slots__ = ()


NOTHING = _Nothing()


def _nothing(_parts: Parts) -> Any:
    return NOTHING


@dataclass(frozen=True, slots=True)
class Numbered:
    """Which one of a numbered list a command is.

    Attributes:
        number: Of it.
        spelled: Whether it is a mere number in words, which alone may be how many: "two: wave".
    """

    number: int
    spelled: bool = False


_MARKS = ",.:!"
_ENDS_A_NUMBER = (".", ")", ":", "paren", "slash")


def _list_number(parts: Parts) -> Numbered | None:
    is_mark = parts[-1].word_class == "BULLET" or parts[-1].meaning in _ENDS_A_NUMBER
    return step_number(parts) if is_mark else None


def step_number(parts: Parts) -> Numbered | None:
    """The number of a step, in digits, in words or as a letter."""
    (said,) = words(parts, "NUM", "AMOUNT", "LETTER")
    return Numbered(int(said.meaning)) if said.meaning.isdecimal() else None


def _spelled_number(parts: Parts) -> Numbered | None:
    said, mark = parts
    fits = mark.meaning in (":", ",", ".") and said.said != "single"
    return Numbered(int(said.meaning), spelled=True) if fits else None


def _roman_number(parts: Parts) -> Numbered:
    return Numbered(int(parts[-1].meaning))


def _clause(parts: Parts) -> Clause | None:
    """A command, with what was said before it."""
    command: Clause = parts[-1]
    if any(mark.meaning not in (",", ":") for mark in words(parts, "PAUSE")):
        return None  # "the cup. With your left hand. Wave"
    if sum(isinstance(part, Numbered) for part in parts) > 1:
        return None  # "turn left 90. 2. Wave"
    for part in parts[:-1]:
        if isinstance(part, Where) and part.of.reference == "there" and _goes(command):
            command = replace(command, terse=True)  # else it belongs to what was said before
            continue
        slot = (
            ("hand", part.side)
            if isinstance(part, Hand)
            else ("source", part.of)
            if isinstance(part, Where)
            else None
        )
        if isinstance(part, Numbered):
            command = replace(command, number=part.number, spelled=part.spelled)
        if isinstance(part, Where) and part.role == "is":
            if not _is_taken_or_seen(command):
                return None  # "in the kitchen, put the cup on the table"
            command = replace(command, placed=True)
        if slot is not None:  # "take the cup with the right, wave", "... from the table, wave": of which?
            command = replace(command, terse=True)
        if isinstance(part, Hand):
            command = replace(command, hand_first=True)
        if slot is not None:
            changed = _with_slot(command, *slot)
            if changed is None:
                return None
            command = changed
    return command


_BRIEF = frozenset({"pick", "hand_over", "look_at", "point_at", "find", "count", "describe"})


def _is_brief(one: Draft, said: str) -> bool:
    """Whether it takes but a moment; what is lent to somebody has a duration."""
    to_me = one.get("to") == ME
    if one.action == "walk_to":
        return to_me and said != "hurry"
    return one.action in _BRIEF and said != "while" and (to_me or one.action != "hand_over")


def _briefly(parts: Parts) -> Clause | None:
    """A command that is only said to be a short one: "come here for a sec"."""
    *said, moment = parts
    drafts = [one for bundle in said[-1].bundles for one in bundle]
    return _clause(tuple(said)) if all(_is_brief(one, moment.meaning) for one in drafts) else None


def _minding(parts: Parts) -> Clause | None:
    """A command in the form of "would you mind opening it"."""
    command: Clause = parts[-1]
    return replace(command, form="base") if command.form == "ing" else None


def _warned(_parts: Parts) -> Trouble:
    """A warning before a statement: "careful, the cup is hot. Pick it up"."""
    return Trouble("that is a warning: shall it be done all the same?", asks=True, rivals=True)


def _maybe_ordered(parts: Parts) -> Trouble:
    """A command that is asked about, permitted, planned or hoped for: "are you able to open the fridge?"."""
    said = words(parts, "MAYBE_ORDER")[0].said
    return Trouble("is that asked or told, or shall it be done?", said, asks=True)


def _is_taken_or_seen(command: Clause) -> bool:
    """Whether a place before it can only be where its thing is."""
    return all(bundle[0].action in ("pick", "find", "count", "describe") for bundle in command.bundles)


def _goes(command: Clause) -> bool:
    """Whether it goes somewhere, where "from there" says nothing."""
    return all(one.action in ("walk_to", "move", "go_home") for bundle in command.bundles for one in bundle)


def _clause_with_hand(parts: Parts) -> Clause | Trouble | None:
    """A command with a hand before it; a mere "right," may be no more than how one begins to speak."""
    side = words(parts, "LEFT_RIGHT")[0]
    if not words(parts, "HAND", "USE") and side.said in ("left", "right"):
        return Trouble(f"is {side.said!r} the hand to use?", side.said, asks=True)
    joined = [part for part in parts if isinstance(part, Separator)]
    orders = any(word.said == "use" for word in words(parts, "USE"))
    if not orders and any(one.value >= Separator.THEN.value for one in joined):
        return None  # "take the cup with the right. Wave"
    return _clause((Hand(side.meaning), *words(parts, "PAUSE"), parts[-1]))


def _hand_moves(parts: Parts) -> Clause | Trouble | None:
    """Terse: "right hand: bowl onto tray"."""
    side = words(parts, "LEFT_RIGHT")[0]
    of, where = next(part for part in parts if isinstance(part, Nominal)), parts[-1]
    if words(parts, "PAUSE")[-1].meaning != ":" or of.reference or not isinstance(where, Where):
        return None
    put = PLACING["put"]((Item(of, (where, Hand(side.meaning))),))
    return replace(put, terse=True) if isinstance(put, Clause) else put


STEPS = ("first", "second", "third", "fourth", "fifth", "sixth")


def _ordinal_step(parts: Parts) -> Numbered | None:
    said = parts[0].meaning
    return Numbered(STEPS.index(said) + 1) if said in STEPS else None


_TAKES = {
    "hand": WITH_A_HAND,
    "source": frozenset({"pick", "place", "put_in", "hand_over", "find", "count", "describe"}),
}


def _with_slot(command: Clause, name: str, value: Any) -> Clause | None:
    bundles = []
    for bundle in command.bundles:
        first, *rest = bundle
        if first.action not in _TAKES[name] or first.get(name) not in (None, value):
            return None
        bundles.append((_filled(first, name, value), *rest))
    return replace(command, bundles=tuple(bundles))


def _filled(first: Draft, name: str, value: Any) -> Draft:
    return first if first.get(name) is not None else first.with_slot(name, value)


MEANINGS: Mapping[str, Meaning] = MappingProxyType(
    {
        "nothing": _nothing,
        "list_number": _list_number,
        "step_number": step_number,
        "spelled_number": _spelled_number,
        "roman_number": _roman_number,
        "ordinal_step": _ordinal_step,
        "clause": _clause,
        "briefly": _briefly,
        "minding": _minding,
        "warned": _warned,
        "maybe_ordered": _maybe_ordered,
        "clause_with_hand": _clause_with_hand,
        "hand_moves": _hand_moves,
    }
)
