"""From clauses to commands: what every word stands for, and the tasks that come of it."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from typing import Any

from executive.language.phrases.handled_thing import PREVIOUS
from executive.language.phrases.values import Bundle, Clause, Draft, Nominal, Trouble
from executive.language.resolve.antecedents import (
    LOOKS,
    OPENS,
    door_of,
    in_hand,
    it,
    of_one_kind,
    other_door,
    said_again,
    several,
)
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
from executive.language.resolve.kinds import TAKES_SEVERAL, task_type
from executive.language.resolve.people import all_of_them, person_meant, spoken_to, where_found
from executive.language.resolve.places import (
    described,
    destination,
    implied_source,
    inside_of,
    on_a_shelf,
    place,
    put_there,
    there,
    walked_to,
)
from executive.language.resolve.statements import taking_up
from executive.meaning import Command
from trees.tasks import FindTask, ObjectOf

__all__ = ["UnresolvedError", "commands_of", "description_of"]

_TO_EACH = frozenset({"wave", "say", "greet", "answer", "look_at", "point_at"})
"""What is done to several people one after the other."""

_ASIDE = frozenset(
    {"there_are", "again", "stays", "holds", "out", "tells", "watches", "inside", "looks_in", "together"}
    | {"lifts", "reaches", "reports", "one_of", "fetched", "lets_go"}
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
        _for_whom(told, clause)
        for named in (*clause.about, *clause.said_before):
            told = told.naming(named, "about")
        for bundle in clause.bundles:
            drafts = bundle if stated is None else taking_up(told, bundle, stated)
            told = told if stated is None else told.naming(stated.of, "about")
            stated = None
            for each in _for_each(told, drafts):
                told = _with_bundle(told, each, clause.text, people_in)
    if stated is not None or not told.steps:
        raise UnresolvedError(Trouble("something is stated that no task follows from"))
    trouble = trouble_after(told)
    if trouble is not None:
        raise UnresolvedError(trouble)
    return told.commands


def description_of(nominal: Nominal) -> Any:
    """A nominal that refers to nothing else, as the value of a slot.

    Raises:
        UnresolvedError: It does.
    """
    return described(Discourse(), nominal)


def _for_whom(told: Discourse, clause: Clause) -> None:
    """Check that nobody is stated to need what was just brought to nobody: "bring a blanket, Grandma is cold".

    Raises:
        UnresolvedError: Somebody is.
    """
    people = [str(one.kind) for one in clause.about if one.is_person and not clause.bundles]
    if people and told.steps and _is_for_nobody(told.steps[-1].said):
        raise ask("to whom?", ["me", *people])


def _is_for_nobody(said: Draft) -> bool:
    """Whether nobody is said to get it: "bring the cup"."""
    to = said.get("to")
    return said.action == "hand_over" and isinstance(to, Nominal) and to.reference == "asker"


def _for_each(told: Discourse, bundle: Bundle) -> Iterator[Bundle]:
    """One bundle for each thing or person that "them" stands for."""
    first, *rest = bundle
    thing, person = first.get("object"), first.get("person")
    if is_them(thing) and first.action in LOOKS and told.people and not told.recent(THINGS):
        slots = tuple(("person" if name == "object" else name, value) for name, value in first.slots)
        first, thing, person = replace(first, slots=slots), None, thing  # "find a person and look at them"
    if is_them(person) and first.action in _TO_EACH:
        yield from ((first.replacing("person", one), *rest) for one in all_of_them(told, person) or (person,))
    elif is_them(thing):
        for root in several(told, thing, first.action):
            yield (first.replacing("object", ObjectOf(root)), *rest)
    else:
        yield (first, *rest)


def _with_bundle(
    told: Discourse, bundle: Bundle, text: str, people_in: Callable[[str], Sequence[Nominal]]
) -> Discourse:
    """With tasks that are done one after the other to the same thing."""
    last: ObjectOf | None = None
    for each in bundle:
        one = each.replacing("object", last) if each.get("object") == PREVIOUS else each
        if one.get("fetched"):
            meant = _fetched(told, one)
            one = one if meant is None else one.replacing("object", meant)
            told = told if meant is None else _not_given_yet(told, meant, one)
            if meant is not None and meant.task in told.held and one.get("source") is None:
                last = meant
                continue
        last, told = _with_task(told, one, text)
        for person in people_in(one.get("text") or ""):  # "her" who is told is none of them
            told = told.naming(person, "quoted")
    return told


def _fetched(told: Discourse, one: Draft) -> ObjectOf | None:
    """What is brought somewhere, if it was named before.

    Raises:
        UnresolvedError: It may be another one than what is in the hand.
    """
    thing = one.get("object")
    if not isinstance(thing, Nominal):
        return thing if isinstance(thing, ObjectOf) else None
    if thing.reference:
        meant = it(told, thing, "pick")
        if not isinstance(meant, ObjectOf) or (told.held and meant.task not in told.held):
            raise ask("which of them does 'it' stand for?")
        return meant
    held = in_hand(told, thing, one.get("source"))
    return held if held is not None or thing.is_place else _same_thing(told, one, thing)


def _same_thing(told: Discourse, one: Draft, thing: Nominal) -> ObjectOf | None:
    """What a noun was said of before, unless it is said to be at another place than that.

    Raises:
        UnresolvedError: It was given away since.
    """
    before = said_again(told, thing)
    if not isinstance(before, ObjectOf):
        return None
    source = one.get("source")
    if source is not None and not thing.whose and source != told.source_of(before.task):
        return None
    if before.task in told.given and not thing.whose:
        raise ask(f"the {thing.kind} is given away by then: is another one meant?")
    return before


def _not_given_yet(told: Discourse, meant: ObjectOf, one: Draft) -> Discourse:
    """Without a hand-over that nobody asked for: "bring the blanket and put it on the bed".

    Raises:
        UnresolvedError: It was asked for, so that the thing is given away by now.
    """
    if meant.task not in told.given or one.get("source") is not None:
        return told
    last = told.steps[-1]
    if last.root != meant.task or not _is_for_nobody(last.said):
        raise ask("it is given away by then: shall it be taken back first?")
    return replace(told, steps=told.steps[:-1])


def _with_task(told: Discourse, one: Draft, text: str) -> tuple[ObjectOf, Discourse]:
    """What a task is done to, and the discourse with it, unless it is done already.

    Raises:
        UnresolvedError: It is not clear what is meant.
    """
    if one.get("one_of") is not None:  # "find some cups", which only counting them makes clear
        raise UnresolvedError(Trouble(one.get("one_of"), asks=True, rivals=True))
    named, value = _object_of(told, one)
    task = len(told.steps)
    root = value.task if isinstance(value, ObjectOf) else task
    if one.action in PUTS_DOWN and isinstance(value, ObjectOf):
        told = _not_given_yet(told, value, one)
        task = len(told.steps)
    if named is None and _is_so_already(told, one, root):
        return ObjectOf(root), told
    trouble = trouble_with(told, Order(one, named, root))
    if trouble is not None:
        raise UnresolvedError(trouble)
    before = told
    if named is not None:
        told = replace(told.naming(named, "object"), kind=named if named.kind is not None else told.kind)
    elif isinstance(value, ObjectOf):
        told = _again(told, root)
    slots: _Slots = {} if one.get("object") is None else {"object": value}
    for name, said in one.slots:
        if name != "object" and name not in _ASIDE:
            told = _with_slot(told, one, name, said, root, slots)
    for also in one.get("together") or ():
        told = told.naming(also, "about")
    if "source" not in slots and named is not None:
        implied = implied_source(before, one, named)
        if implied is not None:
            slots["source"] = implied[1]
            told = told.naming(implied[0], "taken", root)
    if "count" in slots and (isinstance(value, ObjectOf) or one.action not in TAKES_SEVERAL):
        if not isinstance(value, ObjectOf):
            raise ask("which one is meant?")
        del slots["count"]  # "the two cups, ... the cups": as many as there were
    command = task_type(slots.pop("action", one.action))(text, **slots)
    if before.steps and _is_done(before.steps[-1].command, command):
        return ObjectOf(root), before
    return ObjectOf(root), replace(told, steps=(*told.steps, Step(command, one, root, told.clause)))


def _again(told: Discourse, root: int) -> Discourse:
    """With a thing that a task acted on before, as one that is named now."""
    thing = next((one for one in told.things if one.task == root), None)
    return told if thing is None else replace(told, named=(*told.named, replace(thing, clause=told.clause)))


def _is_so_already(told: Discourse, one: Draft, root: int) -> bool:
    """Whether what is in the hand is only lifted, or stays where it was put: "leave it there"."""
    if one.action == "pick":
        return root in told.held and all(name in ("object", "lifts", "reaches") for name, _ in one.slots)
    stays = bool(one.get("stays")) and one.get("there") is not None
    return stays and root in told.placed and root not in told.held


def _is_done(last: Command, command: Command) -> bool:
    """Whether the task before walks to the same place, opens or closes the same, or finds it."""
    if command.action not in ("walk_to", "find", "place", "put_in", *OPENS) or last.action != command.action:
        return False
    if isinstance(command, FindTask) and command.person is None:
        return isinstance(command.object, ObjectOf)
    return replace(command, text=last.text) == last  # type: ignore[type-var]


def _object_of(told: Discourse, one: Draft) -> tuple[Nominal | None, Any]:
    """The thing of a task: what was named anew, if it was, and the value of the slot.

    Raises:
        UnresolvedError: It is not clear which one it is.
    """
    thing = one.get("object")
    if not isinstance(thing, Nominal):
        return None, thing
    if one.get("inside"):
        return None, inside_of(told)
    if thing.is_bare_one:
        raise ask("which object is meant?")
    if thing.reference:
        before: Any = it(told, thing, one.action)
    else:
        before = said_again(told, thing)
        before = _same_thing(told, one, thing) if isinstance(before, ObjectOf) else before
        if before is None and one.action in PUTS_DOWN and not thing.is_plain and one.get("source") is None:
            before = None if thing.indefinite else in_hand(told, thing)  # by then another one is on the left
    if isinstance(before, ObjectOf):
        return None, before
    thing = before or thing
    if one.action in OPENS:
        thing = other_door(told, thing, one.action) if thing.anaphoric else door_of(told, thing, one.action)
        if isinstance(thing, ObjectOf):
            return None, thing
    named = told.same_kind(thing)
    if thing.anaphoric:
        of_one_kind(told, *(each.of for each in told.recent(("thing",))))
    return named, described(told, named)


def _with_slot(told: Discourse, one: Draft, name: str, said: Any, root: int, slots: _Slots) -> Discourse:
    """With a slot filled, and the discourse with what it names.

    Raises:
        UnresolvedError: It is not clear what is meant.
    """
    if name == "there":
        slots.update(put_there(told, said, root))
        return told
    if name == "text":
        slots["words"] = said
        return told
    if not isinstance(said, Nominal) and name not in ("to", "on"):
        slots[name] = said
        return told
    if name in ("person", "of"):
        return _with_person(told, one, name, said, slots)
    if name == "source":
        of = there(told, said, root) if said.reference == "there" else _as_before(told, said)
        slots[name] = place(told, of, root)
        return told.naming(of, "taken" if isinstance(slots[name], ObjectOf) else "source", root)
    if one.action == "walk_to":
        slots[name], walked = walked_to(told, _as_before(told, said))
        return told if isinstance(slots[name], ObjectOf) else _walking(told, walked)
    return _with_goal(told, one, name, said, root, slots)


def _with_goal(told: Discourse, one: Draft, name: str, said: Any, root: int, slots: _Slots) -> Discourse:
    """With where a thing or a person goes."""
    of = _as_before(told, said)
    if of is not said and of == told.source_of(root):
        raise ask(f"the same {of.kind}, or another one?")  # "from the big table ... on the table"
    if is_them(of) and one.action == "hand_over":
        of = person_meant(told, of)
    slots[name] = goal = place(told, of, root, into=one.action == "put_in")
    if ObjectOf(root) in (goal, getattr(getattr(goal, "relation", None), "to", None)):
        raise ask("is it the same one twice? say how they differ")
    if not isinstance(of, Nominal):
        return told.naming(of, "by")
    return told.naming(of, "again" if isinstance(goal, ObjectOf) else "goal")


def _as_before(told: Discourse, of: Any) -> Any:
    """A place or a person as it was told before."""
    if isinstance(of, Nominal) and (of.is_place or of.sort == "person"):
        before = said_again(told, of)
        of = before if isinstance(before, Nominal) else of
    return on_a_shelf(told, of)


def _walking(told: Discourse, to: Any) -> Discourse:
    """With where the robot goes; a thing there is "it" when nothing was handled before."""
    if not isinstance(to, Nominal):
        return told.naming(to, "beside")
    first = all(told.commands[one.task].action == "walk_to" for one in told.things)
    if to.sort == "thing" and not to.reference and to.is_single and first:
        told = told.naming(to, "object")
    return told.naming(to, "walk")


def _with_person(told: Discourse, one: Draft, name: str, of: Nominal, slots: _Slots) -> Discourse:
    """With whom a task is about or whom it is done to."""
    place_said = one.get("source")
    if of.reference == "asker":  # "find Ana and say the time"
        met = spoken_to(told)
        slots.update({} if met is None else {name: destination(told, met)})
        return told
    if one.get("count") is None:
        of = person_meant(told, of, anew=place_said is not None)
        slots[name] = destination(told, of)
    else:  # several people are only looked for
        slots[name] = described(told, of)
    if one.action == "find" and isinstance(place_said, Nominal):
        return where_found(told, of, place_said)
    return told.naming(of, "person")
