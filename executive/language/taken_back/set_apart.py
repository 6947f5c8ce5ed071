"""Whether what is named as not meant differs from what is meant: "the red cup, not the blue one".

Two descriptions are apart where both say something that cannot hold of one thing: another kind, another
colour, the other side. What only narrows ("the cup, not the one on the table") is not apart: what is meant
would be less than what is done.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from executive.language.noun_phrases.lists import SORTS_OF_THINGS
from executive.language.phrases import Item, Nominal, Relative, Where

Slots = Mapping[str, Any]

_NEVER_BOTH = """
small/big small/medium medium/big small/tall small/long big/short tall/short long/short tall/medium
short/medium thin/thick thin/wide smaller/bigger taller/shorter longer/shorter smallest/biggest
smallest/tallest tallest/shortest longest/shortest thinnest/widest
man/woman boy/girl left_of/right_of in_front_of/behind on/under on/in
"""
_EXCLUDING = {frozenset(pair.split("/")) for pair in _NEVER_BOTH.split()}
"""Sizes, people and relations that are never both said of one."""

_GENERAL = frozenset(
    {
        *("person", "man", "woman", "boy", "girl"),
        *("child", "guest", "operator", "adult", "friend", "colleague"),
    }
)
"""People of whom any other word may be said too: the woman may be the nurse."""

_ROWS = (
    frozenset({"leftmost", "middle", "rightmost"}),
    frozenset({"top", "middle", "bottom"}),
    frozenset({"first", "second", "third", "fourth", "fifth", "sixth"}),
)
"""Ranks of one row."""

_PARTS = frozenset(
    ["lid", "cap", "cover", "cork", "stopper", "label", "strap", "handle", "charger", "battery", "case"]
)
"""Kinds that may belong to what is meant: "the box, but not the lid" may be a box without its lid."""

_DESCRIBES = ("kind", "color", "size", "material", "ordinal", "name")

_APART, _SAME, _OTHER = "apart", "same", "other"
"""What is meant and what is not: two things; perhaps one; of different sorts, so that it says nothing."""


class Apart:
    """Compares what is not meant with tasks.

    Args:
        commands: What is meant, as JSON.
        sort_of: "room" or "place" of the name of a place, "" of other names.
    """

    def __init__(self, commands: Sequence[Slots], sort_of: Callable[[str], str]) -> None:
        self._commands, self._sort_of = commands, sort_of

    def stands_beside(self, excluded: Item | Where) -> bool:
        """Whether it is something else than what is meant, and of the same sort."""
        verdicts = self._verdicts(excluded)
        return _APART in verdicts and _SAME not in verdicts

    def is_unrelated(self, excluded: Item | Where) -> bool:
        """Whether it is nothing of what is meant, of the same sort or not: "forget the cup, go home"."""
        named = excluded.of.kind is not None and excluded.of.sort not in ("any", "you")
        return named and _SAME not in self._verdicts(excluded)

    def differs_from(self, others: Sequence[Slots]) -> bool:
        """Whether other tasks are none of these: other actions, or the same ones with another thing."""
        actions = [one["action"] for one in self._commands]
        if not others or set(actions).isdisjoint(one["action"] for one in others):
            return bool(others)
        if actions != [one["action"] for one in others]:
            return False
        return any(
            self._thing(one["object"], meant["object"], acted_on=True) == _APART
            for one, meant in zip(others, self._commands, strict=True)
            if not any("ref" in each.get("object", {"ref": 0}) for each in (one, meant))
        )

    def _verdicts(self, excluded: Item | Where) -> list[str]:
        of = excluded.of
        if of.reference or of.sort == "you" or of.is_vague or of.count == "all" or of.kind in _PARTS:
            return [_SAME]
        found = [(one["action"], self._compared(excluded, one)) for one in self._commands]
        beside = {action for action, verdicts in found if _APART in verdicts}
        if of.kind is None and not isinstance(excluded, Where):  # "one" stands for what the same is done to
            found = [(action, verdicts) for action, verdicts in found if action in beside]
        return [verdict for _, verdicts in found for verdict in verdicts]

    def _compared(self, excluded: Item | Where, command: Slots) -> list[str]:
        """What each of a command's slots is to what is not meant."""
        thing, goal = command.get("object", {}), command.get("to")
        is_somebody = isinstance(goal, str) and not self._sort_of(goal)
        gets = command["action"] == "hand_over" or (command["action"] == "walk_to" and is_somebody)
        people = [command.get("person"), goal if gets else None]
        aimed = command["action"] in ("look_at", "point_at") and "person" not in command
        if aimed and isinstance(excluded, Where) and excluded.relation is None:
            excluded = Item(excluded.of)  # "point at the box, not at the ball"
        if excluded.of.is_person:
            named = [_person(excluded.of, value) for value in people if value is not None]
            return named or ([_APART] if aimed else [])
        places = [
            (slot, {"kind": value} if isinstance(value, str) else value)
            for slot, value in command.items()
            if slot in ("from", "on", "to") and value not in people
        ]
        if isinstance(excluded, Where):
            relation = {"relation": thing["relation"]} if "relation" in thing else None
            beside = [("relation", relation)] if relation and excluded.relation else []
            return [self._place(excluded, command, slot, value) for slot, value in [*places, *beside]]
        said = _described(excluded)
        if said is None:
            return [_SAME]
        verdicts = []
        if thing and "ref" not in thing:
            meant = {**thing, "place": command.get("from"), "count": command.get("count", 1)}
            verdicts.append(self._thing(said, meant, acted_on=True))
        return verdicts + [self._thing(said, value, acted_on=False) for _, value in places]

    def _thing(self, said: Slots, meant: Slots, *, acted_on: bool) -> str:
        """What a thing or place is to another one; one that is "acted on" is also meant by "one"."""
        if "relation" in meant and "kind" not in meant and not acted_on:
            meant = _as_described(meant["relation"]["to"])
        one, other = said.get("kind"), meant.get("kind")
        if one is not None and other is not None and one != other:
            if self._sort_of(one) != self._sort_of(other):
                return _OTHER
            return _SAME if _may_be_one(one, other) else _APART
        if one is not None and other is None:
            return _SAME if acted_on else _OTHER
        if _clashes(said, meant):
            return _APART
        equal = any(meant.get(slot) == said[slot] for slot in set(said) - {"kind"})
        return _SAME if acted_on or equal or one is not None else _OTHER

    def _place(self, excluded: Where, command: Slots, slot: str, value: Slots) -> str:
        """What where something is or goes is to a place: "on the shelf, not in the fridge"."""
        beside = "relation" in value and "kind" not in value
        if beside != (excluded.relation is not None):
            return _SAME  # what is next to the bowl may be on the table
        said = _described(Item(excluded.of)) or {}
        if beside:
            relation = {"is": excluded.relation, "to": said}
            return _APART if _differ("relation", relation, value["relation"]) else _SAME
        one, other = said.get("kind"), value.get("kind")
        if one is None or one == other:
            inside = {"in": True, "on": False}.get(str(excluded.preposition))
            known = one is not None and set(value) == {"kind"} and slot != "from" and inside is not None
            if known and inside != (command["action"] == "put_in"):
                return _APART  # "on the fridge, not in the fridge"
            return _APART if _clashes(said, value) else _SAME
        alike = other is not None and self._sort_of(one) == self._sort_of(other)
        return _APART if alike else _SAME  # what is on the tray may be on the table, or in the kitchen


def _person(nominal: Nominal, meant: Any) -> str:
    """What a person is to another: two names are two people, but Ana may be "the woman"."""
    if isinstance(meant, str) != (nominal.sort in ("name", "me")):
        return _SAME
    if isinstance(meant, str):
        return _SAME if nominal.kind == meant else _APART
    said = _described(Item(nominal)) or {}
    if frozenset({said.get("kind"), meant.get("kind")}) in _EXCLUDING:
        return _APART
    kinds = {said.get("kind"), meant.get("kind")}
    if len(kinds) == 2:
        return _SAME if None in kinds or kinds & _GENERAL else _APART
    return _APART if _clashes(said, meant) else _SAME


def _described(item: Item) -> dict[str, Any] | None:
    """What is said of a thing, in the slots of a task; None where more is said than these hold."""
    of = item.of
    said: dict[str, Any] = {name: getattr(of, name) for name in _DESCRIBES if getattr(of, name) is not None}
    relation: Relative | None = of.relation
    for detail in item.details:
        if not isinstance(detail, Where) or detail.role == "to" or detail.of.reference:
            return None
        if detail.relation is not None:
            relation = Relative(detail.relation, detail.of)
        else:
            said["place"] = detail.of.kind
    if relation is not None and relation.to.sort != "you":
        said["relation"] = {"is": relation.kind, "to": _described(Item(relation.to)) or {}}
    if of.counted:
        said["count"] = of.count
    return said


def _as_described(value: Slots | str) -> Slots:
    """A description, of which a plain place is only its kind: "next to the table"."""
    return {"kind": value} if isinstance(value, str) else value


def _clashes(said: Slots, meant: Slots) -> bool:
    """Whether both say of one slot what cannot hold of one thing."""
    both = (slot for slot in said if slot != "kind" and None not in (said[slot], meant.get(slot)))
    return any(_differ(slot, said[slot], meant[slot]) for slot in both)


def _differ(slot: str, one: Any, other: Any) -> bool:
    if one == other:
        return False
    if slot == "size":
        return frozenset({one, other}) in _EXCLUDING
    if slot == "ordinal":
        return any({one, other} <= row for row in _ROWS)
    if slot == "place":
        return isinstance(one, str) and isinstance(other, str)
    if slot == "relation":
        to = _as_described(one["to"]).get("kind"), _as_described(other["to"]).get("kind")
        if None in to:
            return False
        same = one["is"] == other["is"]
        return to[0] != to[1] if same else frozenset({one["is"], other["is"]}) in _EXCLUDING
    return True


def _may_be_one(one: str, other: str) -> bool:
    """Whether two kinds may be one thing: "the cup" is "the coffee cup", the apple is a fruit."""
    first, second = one.split(), other.split()
    general = not SORTS_OF_THINGS.isdisjoint({one, other})
    return general or (first[-1] == second[-1] and 1 in (len(first), len(second)))
