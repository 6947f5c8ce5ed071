"""From clauses to commands: what every word stands for, and the tasks that come of it."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import fields, replace
from typing import Any

from executive.language.phrases.handled_thing import PREVIOUS
from executive.language.phrases.values import Bundle, Clause, Draft, Nominal, Relative, Trouble
from executive.language.resolve import antecedents, people, places
from executive.language.resolve.antecedents import LOOKS, OPENED, OPENS
from executive.language.resolve.discourse import (
    PUTS_DOWN,
    THINGS,
    Discourse,
    Step,
    UnresolvedError,
    ask,
    is_them,
)
from executive.language.resolve.guards import Order, trouble_after, trouble_with
from executive.language.resolve.kinds import task_type
from executive.language.resolve.statements import taking_up
from executive.meaning import Command
from trees.tasks import FindTask, ObjectOf

__all__ = ["UnresolvedError", "commands_of"]

_TO_EACH = frozenset({"wave", "say", "greet", "answer", "look_at", "point_at"})
"""What is done to several people one after the other."""

_DONE_ONCE = frozenset({"walk_to", "find", "place", "put_in", *OPENS})
"""What need not be done again right after it was done."""

_ASIDE = frozenset(
    {"there_are", "stays", "out", "tells", "inside", "looks_in", "together", "reports", "fetched"}
)
"""Slots of a draft that are no slots of a task: how it was said."""

_Slots = dict[str, Any]


def commands_of(
    clauses: Sequence[Clause],
    people_in: Callable[[str], Sequence[Nominal]] = lambda _text: (),
    remembers: bool = False,
) -> tuple[Command, ...]:
    """The commands of clauses, in order.

    Args:
        clauses: What was said, in the order in which it is done.
        people_in: Who is named in words that are to be said.
        remembers: Whether "back" may be where a thing was before it was picked up, wherever that was.

    Raises:
        UnresolvedError: Something that is referred to is missing or not clear.
    """
    told = Discourse(remembers=remembers)
    stated = None
    for number, clause in enumerate(clauses):
        told = replace(told, clause=number, ahead=clause.said_before, backwards=clause.said_first)
        if clause.mention is not None and stated is not None:
            raise ask("which of them is meant?")
        stated = clause.mention or stated
        if not clause.bundles and any(one.is_person for one in clause.about) and _is_for_nobody(told):
            raise ask("to whom?")  # "bring a blanket, Grandma is cold"
        for named in (*clause.about, *clause.said_before):
            told = told.naming(named, "about")
        for bundle in clause.bundles:
            taken = bundle if stated is None else taking_up(told, bundle, stated)
            told = told if stated is None else told.naming(stated.of, "about")
            stated = None
            for each in _for_each(told, taken):
                told = _with_bundle(told, each, clause.text)
                for person in people_in(each[0].get("text") or ""):
                    told = told.naming(person, "quoted")
    if stated is not None or not told.steps:
        raise UnresolvedError(Trouble("something is stated that no task follows from"))
    trouble = trouble_after(told)
    if trouble is not None:
        raise UnresolvedError(trouble)
    return tuple(step.command for step in told.steps)


def _is_for_nobody(told: Discourse) -> bool:
    """Whether the last task brings something, and nobody is said to get it: "bring the cup"."""
    to = told.steps[-1].said.get("to") if told.last_action == "hand_over" else None
    return isinstance(to, Nominal) and to.reference == "asker"


def _for_each(told: Discourse, bundle: Bundle) -> Iterator[Bundle]:
    """One bundle for each thing or person that "them" stands for."""
    first, *rest = bundle
    thing, person = first.get("object"), first.get("person")
    if is_them(thing) and first.action in LOOKS and told.people and not told.recent(THINGS):
        slots = tuple(("person" if name == "object" else name, value) for name, value in first.slots)
        first, thing, person = replace(first, slots=slots), None, thing  # "find a person and look at them"
    if is_them(person) and first.action in _TO_EACH:
        for one in people.all_of_them(told, person) or [person]:
            yield (first.replacing("person", one), *rest)
    elif is_them(thing):
        for root in antecedents.several(told, thing, first.action):
            yield (first.replacing("object", ObjectOf(root)), *rest)
    else:
        yield (first, *rest)


def _with_bundle(told: Discourse, bundle: Bundle, text: str) -> Discourse:
    """With tasks that are done one after the other to the same thing."""
    last: ObjectOf | None = None
    for each in bundle:
        one = each.replacing("object", last) if each.get("object") == PREVIOUS else each
        meant = _before(told, one) if one.get("fetched") else None
        if isinstance(meant, ObjectOf):
            one = one.replacing("object", meant)
            told = _not_given_yet(told, one, meant.task)
            if meant.task in told.held and one.get("source") is None:
                last = meant
                continue
        last, told = _with_task(told, one, text)
    return told


def _before(told: Discourse, one: Draft) -> Nominal | ObjectOf | None:
    """What the thing of a task is, if it was named before, or picked up in these very words."""
    thing, source = one.get("object"), one.get("source")
    if not isinstance(thing, Nominal):
        return thing if isinstance(thing, ObjectOf) else None
    if thing.reference:
        return antecedents.it(told, thing, "place" if one.get("fetched") else one.action)
    before = antecedents.said_again(told, thing)
    if isinstance(before, ObjectOf) and before.task in told.moved("hand_over") and source is None:
        raise ask(f"the {thing.kind} is given away by then: is another one meant?")
    if isinstance(before, ObjectOf) and source is not None and source != told.source_of(before.task):
        return None
    again = one.action in PUTS_DOWN and not thing.is_plain and not thing.indefinite and source is None
    if before is None and (again or (one.get("fetched") and not thing.is_place)):
        return antecedents.in_hand(told, thing, source)
    return before


def _not_given_yet(told: Discourse, one: Draft, root: int) -> Discourse:
    """Without a hand-over that nobody asked for: "bring the blanket and put it on the bed"."""
    if root not in told.moved("hand_over") or one.get("source") is not None:
        return told
    picked = told.steps[-1].root == root < len(told.steps) - 1
    if not picked or not _is_for_nobody(told):
        raise ask("it is given away by then: shall it be taken back first?")
    return replace(told, steps=told.steps[:-1])


def _with_task(told: Discourse, one: Draft, text: str) -> tuple[ObjectOf, Discourse]:
    """What a task is done to, and the discourse with it, unless it is done already."""
    named, value = _object_of(told, one)
    root = value.task if isinstance(value, ObjectOf) else len(told.steps)
    if one.action in PUTS_DOWN and isinstance(value, ObjectOf):
        told = _not_given_yet(told, one, root)
    said_how = any(one.get(slot) for slot in ("hand", "source"))
    lifted = one.action == "pick" and root in told.held and not said_how
    nowhere = one.action == "place" and all(one.get(slot) is None for slot in ("on", "to", "there"))
    stays = one.get("there") is not None if one.get("stays") else nowhere
    left = stays and root in told.moved("place", "put_in")
    if named is None and (lifted or left):
        return ObjectOf(root), told  # "grasp it and lift it", "put it there and put it down"
    trouble = trouble_with(told, Order(one, named, root))
    if trouble is not None:
        raise UnresolvedError(trouble)
    before, slots = told, {} if value is None else {"object": value}
    told = told.acting_on(named, root)
    for name, said in one.slots:
        if name != "object" and name not in _ASIDE:
            told = _with_slot(told, one, name, said, root, slots)
    for also in one.get("together") or ():
        told = told.naming(also, "about")
    implied = None if named is None or "source" in slots else places.implied_source(before, one, named)
    if implied is not None:
        slots["source"] = implied[1]
        told = told.naming(implied[0], "taken", root)
    kind = task_type(slots.pop("action", one.action))
    if "count" in slots and isinstance(value, ObjectOf):
        del slots["count"]  # "the two cups, ... the cups": as many as there were
    elif "count" in slots and all(field.name != "count" for field in fields(kind)):
        raise ask("which one is meant?")
    command = kind(text, **slots)
    if before.steps and _is_done(before.steps[-1].command, command):
        return ObjectOf(root), before
    return ObjectOf(root), replace(told, steps=(*told.steps, Step(command, one, root, told.clause)))


def _is_done(last: Command, command: Any) -> bool:
    """Whether the task before walks to the same place, opens or closes the same, or finds it."""
    if command.action not in _DONE_ONCE or last.action != command.action:
        return False
    if isinstance(command, FindTask) and command.person is None:
        return isinstance(command.object, ObjectOf)
    return bool(replace(command, text=last.text) == last)


def _object_of(told: Discourse, one: Draft) -> tuple[Nominal | None, Any]:
    """The thing of a task: what was named anew, if it was, and the value of the slot."""
    thing = one.get("object")
    if not isinstance(thing, Nominal):
        return None, thing
    if one.get("inside"):
        return None, places.inside_of(told)
    if thing.is_bare_one:
        raise ask("which object is meant?")
    thing = _before(told, one) or thing
    if isinstance(thing, Nominal) and one.action in OPENS:
        thing = antecedents.door_of(told, thing, one.action)
    if isinstance(thing, ObjectOf):
        return None, thing
    named = told.same_kind(thing)
    if thing.anaphoric:
        opens = one.action in OPENS
        antecedents.of_one_kind(told, *(each.of for each in told.recent(OPENED if opens else ("thing",))))
        if opens and named.sort not in OPENED and thing.ordinal != "other":
            raise ask(f"which one is it to {one.action}?")
    return named, places.described(told, named)


def _with_slot(told: Discourse, one: Draft, name: str, said: Any, root: int, slots: _Slots) -> Discourse:
    """With a slot filled, and the discourse with what that names."""
    if name == "there":
        slots.update(places.put_there(told, said, root))
    elif name == "text":
        slots["words"] = said
    elif not isinstance(said, Nominal | Relative):
        slots[name] = said
    elif isinstance(said, Nominal) and name in ("person", "of"):
        return _with_person(told, one, name, said, slots)
    elif isinstance(said, Nominal) and name == "source":
        of = places.there(told, said, root) if said.reference == "there" else places.as_before(told, said)
        slots[name] = places.place(told, of, root)
        return told.naming(of, "taken" if isinstance(slots[name], ObjectOf) else "source", root)
    elif one.action == "walk_to":
        slots[name], walked = places.walked_to(told, places.as_before(told, said))
        return told.walking(walked)
    else:
        return _with_goal(told, one, name, said, root, slots)
    return told


def _with_goal(told: Discourse, one: Draft, name: str, said: Any, root: int, slots: _Slots) -> Discourse:
    """With where a thing or a person goes."""
    of = places.as_before(told, said)
    if of is not said and of == told.source_of(root):
        raise ask(f"the same {of.kind}, or another one?")  # "from the big table ... on the table"
    of = people.person_meant(told, of) if is_them(of) and one.action == "hand_over" else of
    slots[name] = goal = places.place(told, of, root, into=one.action == "put_in")
    if ObjectOf(root) in (goal, getattr(getattr(goal, "relation", None), "to", None)):
        raise ask("is it the same one twice? say how they differ")
    again = isinstance(goal, ObjectOf)
    return told.naming(of, "by" if isinstance(of, Relative) else "again" if again else "goal")


def _with_person(told: Discourse, one: Draft, name: str, of: Nominal, slots: _Slots) -> Discourse:
    """With whom a task is about or to whom it is done."""
    source = one.get("source")
    if one.get("count") is None:
        of = people.person_meant(told, of, anew=source is not None)
        slots[name] = places.destination(told, of)
    else:  # several people are only looked for
        slots[name] = places.described(told, of)
    if one.action == "find" and isinstance(source, Nominal):
        return people.where_found(told, of, source)
    return told.naming(of, "person")
