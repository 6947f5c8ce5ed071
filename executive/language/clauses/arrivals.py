"""What is said to be done or reached before something else: "once you are there", "when you have it".

The robot's own steps are no conditions: "once you are at the shelf, take the box" is to go there and to take
it. Where "when" might be meant for some other time ("when you are in the kitchen, open the window"), the step
counts only if the sentence ordered it before.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from types import MappingProxyType
from typing import Any

from executive.language.clauses.scopes import Group, Separator
from executive.language.commands.going import goal_of
from executive.language.noun_phrases.arranging import ME, clause, guarded, trouble, unfit
from executive.language.noun_phrases.handled_thing import IT
from executive.language.phrase_parts import Parts, words
from executive.language.phrases import Clause, Draft, Item, Meaning, Nominal, draft

_THERE = Nominal("any", reference="there")
_OPENED_AND_CLOSED = frozenset({"open", "close"})
STILL = "still"
"""Value of ``done`` where a task that was ordered before counts only if none since undid it."""


def as_done(clause: Clause, unless_ordered: str | None = None) -> Clause:
    """A clause that says what is done by then: what was ordered before is not done twice.

    Args:
        clause: What is done.
        unless_ordered: The word for which it is a condition, unless it was ordered before.
    """

    def told(one: Draft) -> Draft:
        return one.with_slot("done", True).with_slot("condition", unless_ordered)

    bundles = tuple(tuple(told(one) for one in bundle) for bundle in clause.bundles)
    return replace(clause, form="base", bundles=bundles)


def done_by_then(clause: Clause) -> Clause:
    """A clause after "after": "find it. After finding it, ..." finds it once.

    "Open it, close it. After opening it, ..." opens it anew, for it is not open by then.
    """

    def told(one: Draft) -> Draft:
        return one if one.get("done") else one.with_slot("done", STILL)

    return replace(clause, bundles=tuple(tuple(told(one) for one in bundle) for bundle in clause.bundles))


def _done(action: str, slots: Mapping[str, Any], condition: str | None = None) -> Clause:
    return as_done(Clause(((draft(action, **slots),),), "base"), condition)


def at_last() -> Draft:
    """Being where was gone to just before, which is asked otherwise."""
    ((arrived,),) = _done("walk_to", {"to": _THERE}, "there").bundles
    return arrived


def _arrived_there(parts: Parts) -> Clause:
    (said,) = words(parts, "ONCE_THERE")
    return _done("walk_to", {"to": _THERE}, said.said.split()[0])


def _arrived_at(parts: Parts) -> Clause:
    """Once you are at the shelf, when you get to the kitchen."""
    (said,) = words(parts, "ONCE_YOU_ARE", "ONCE_YOU_REACH")
    goal = goal_of(parts[-1])
    habit = said.meaning == "is" and said.said.split()[0] == "when"
    return _done("walk_to", {"to": goal}, "when" if habit else None)


def _once_at(parts: Parts) -> Clause:
    """Once in the kitchen, once at the table."""
    of = goal_of(Item(parts[-1]))
    if words(parts, "ONCE")[0].said != "once" or not isinstance(of, Nominal) or not of.is_place:
        raise unfit()
    if words(parts, "IN") and of.sort != "room":
        raise unfit()
    return _done("walk_to", {"to": of})


def _it_is(parts: Parts) -> Clause:
    """Once it is open: of what was opened just before."""
    action = "open" if words(parts, "OPENED") else "close"
    of = next((part for part in parts if isinstance(part, Nominal)), IT)
    if not (of.reference == "it" or of.sort in ("container", "door")):
        raise unfit()
    return _done(action, {"object": of}, words(parts, "ONCE")[0].said)


def _done_to_it(parts: Parts) -> Clause:
    """Once found: of what the task before is about."""
    once, did = words(parts, "ONCE", "DONE_TO_IT")
    return _done(did.meaning, {"passive": True}, once.said)


def _been_done(parts: Parts) -> Clause:
    """Once the fridge has been opened: by whom is not said, so that it is asked unless it was ordered."""
    once, been, did = words(parts, "ONCE", "BEEN", "DONE_TO_IT")
    of = next((part for part in parts if isinstance(part, Nominal)), IT)
    opens = did.meaning in _OPENED_AND_CLOSED
    is_state = did.said == "open" or (been.meaning == "is" and did.said != "opened")
    fits = of.reference == "it" or of.sort in (("container", "door") if opens else ("thing",))
    if is_state or not fits or not of.is_single or did.meaning == "place":
        raise unfit()
    ((one,),) = _done(did.meaning, {"object": of, "by_anyone": did.said}, once.said).bundles
    return Clause(((one.replacing("done", STILL),),), "base")


def _has_it(parts: Parts) -> Clause:
    """Once you have the cup, with the cup in hand."""
    (of,) = (part for part in parts if isinstance(part, Nominal))
    if of.sort != "thing" and of.reference not in ("it", "them"):
        raise unfit()
    if not of.determined or (not of.reference and (of.count != 1 or (of.plural and not of.paired))):
        raise unfit()
    carried = words(parts, "WITH")
    if carried and carried[0].said != "with":
        raise unfit()
    return replace(_done("pick", {"object": of}), placed=bool(carried))


@dataclass(frozen=True, slots=True)
class _Carrying:
    """What is carried along; ``in_hand`` is whether it was said to be in the hand."""

    of: Nominal
    in_hand: bool


def _carrying(parts: Parts) -> _Carrying | None:
    if words(parts, "WITH")[0].said != "with":
        raise unfit()
    return _Carrying(parts[1], bool(words(parts, "IN_HAND")))


def _walk_with(parts: Parts) -> Clause:
    """Go to Ana with the cup: it is picked up first, unless it was.

    To a place or to somebody without a name, what is in no hand yet may tell which one is meant: "the table
    with the lamp".
    """
    carried = parts[-1]
    goal = ME if words(parts, "COME_BACK") else parts[-2]
    if not isinstance(goal, Nominal):
        raise unfit()
    known = carried.in_hand or goal.sort in ("me", "name") or goal.kind == "operator"
    (taken,) = _has_it((carried.of,)).bundles
    held = tuple(one.with_slot("condition", None if known else "with") for one in taken)
    return clause(parts, [held, (draft("walk_to", to=goal),)])


def _done_when(parts: Parts) -> Clause:
    """When you have found them; when you find them, if that was ordered."""
    (clause,) = (part for part in parts if isinstance(part, Clause))
    form, condition = ("base", "when") if words(parts, "YOU_DO") else ("ed", None)
    if clause.form != form:
        raise unfit()
    return as_done(clause, condition)


def _in_order(done: Clause) -> Clause:
    """What is said after the command it precedes, where more may have been ordered before both."""
    bundles = tuple(tuple(one.with_slot("late", True) for one in bundle) for bundle in done.bundles)
    return replace(done, bundles=bundles)


def _no_more_than_an_order(done: Clause, main: Clause) -> None:
    """Refuse what is in the hand as a tool, and a motion that ends somewhere.

    "With the key in your hand, open the door", "stop when you reach the table".
    """
    (first,), action = done.bundles[0], main.bundles[0][0].action
    if done.placed and action not in ("walk_to", "go_home"):
        raise unfit()
    if action in ("stop", "move") and first.action == "walk_to" and first.get("to") != _THERE:
        word = done.text.split()[0].lower()
        raise trouble(f"a condition ({word!r}) cannot be honoured; say what to do", word)


def _first(parts: Parts) -> Group:
    done, main = (part for part in parts if isinstance(part, Clause))
    _no_more_than_an_order(done, main)
    if main.form != "base" or Separator.STOP in parts or Separator.ASKED in parts:
        raise unfit()
    return Group((done,), (main,), "after_first")


def _last(parts: Parts) -> Group:
    main, done = (part for part in parts if isinstance(part, Clause))
    apart = any(one in parts for one in (Separator.AND, Separator.STOP, Separator.ASKED, Separator.THEN))
    if main.form != "base" or apart:
        raise unfit()
    _no_more_than_an_order(done, main)
    return Group((_in_order(done),), (main,), "by_then")


MEANINGS: Mapping[str, Meaning] = MappingProxyType(
    {
        name: guarded(meaning)
        for name, meaning in {
            "arrived_there": _arrived_there,
            "arrived_at": _arrived_at,
            "once_at": _once_at,
            "it_is": _it_is,
            "done_to_it": _done_to_it,
            "been_done": _been_done,
            "has_it": _has_it,
            "carrying": _carrying,
            "walk_with": _walk_with,
            "done_when": _done_when,
            "by_then_first": _first,
            "by_then_last": _last,
        }.items()
    }
)
