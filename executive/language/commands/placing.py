"""Where things are put, and what is opened and closed."""

from __future__ import annotations

from dataclasses import replace

from executive.language.commands import meanings
from executive.language.phrases.arranging import Arranged, arranged, clause, trouble, unfit
from executive.language.phrases.handled_thing import BACK, BIN, count_of, thing
from executive.language.phrases.lists import another_of
from executive.language.phrases.parts import Parts, senses, words
from executive.language.phrases.values import Clause, Draft, Item, Items, Nominal, Relative, Where, draft
from executive.language.resolve.kinds import listed
from robots.scenes.furniture_names import kind_called
from trees.beliefs.grounding.articles import with_article

HOLDERS = listed("holders")
"""Things that others are put into or onto."""


def put_draft(nominal: Nominal, goal: Where, source: Nominal | None, hand: str | None) -> Draft:
    """The task that puts a thing to where it goes.

    Raises:
        TroubleError: Nothing can be put there, or it may be on it, in it or beside it.
    """
    of = goal.of
    slots = {"object": nominal, "source": source, "hand": hand, "count": count_of(nominal)}
    if of.count != 1:
        raise trouble("several places at once: name one", of.kind)
    if goal.relation is not None:
        return draft("place", **slots, to=Relative(goal.relation, of))
    if of.reference in ("here", "this"):
        raise trouble("where shall it be put?", asks=True)
    if of.reference == "there":
        return draft("place", **slots, there=goal)
    if of.is_person or of.sort == "you":
        raise trouble(f"nothing is put on or into a person ({of.kind!r})", of.kind)
    if of.sort == "door" and goal.preposition == "at":
        return draft("place", **slots, to=Relative("next_to", of))
    inside, upon = goal.preposition == "in", goal.preposition == "on"
    shelved = of.sort != "furniture" or of.kind in listed("shelves")
    if of.sort == "door" or (inside and not shelved):
        raise trouble(f"nothing can be put on or into the {of.kind}", of.kind)
    if inside and of.sort not in ("room", "furniture"):
        return draft("put_in", **slots, to=of)
    beside = of.sort == "furniture" and kind_called(of.kind or "") not in listed("surfaces")
    if goal.preposition == "at" and beside:
        raise trouble(f"on the {of.kind}, or next to it?", asks=True)
    if of.sort == "furniture" or (upon and of.sort != "room"):
        return draft("place", **slots, on=of)
    if not upon and of.sort in ("container", "room"):
        return draft("place", **slots, to=of)
    if of.sort == "thing" and goal.preposition == "to" and of.is_single:
        raise trouble(f"into the {of.kind}, onto it or next to it?", asks=True)
    raise unfit()


def _put(parts: Parts) -> Clause:
    down = bool(words(parts, "DOWN", "PUT_DOWN"))
    stays = "leave" in senses(parts, "PUT") or None
    bundles = []
    for one in arranged(parts, goes=True):
        nominal = thing(one, "putting down")
        if one.is_for_another:
            raise unfit()
        if one.goal is not None:
            put = put_draft(nominal, one.goal, one.source, one.hand)
        elif one.back:
            put = draft("place", object=nominal, hand=one.hand, there=Where("to", BACK, "at"))
        elif down and not (nominal.count == "all" and nominal.sort == "any" and nominal.is_plain):
            count = count_of(nominal)
            put = draft("place", object=nominal, source=one.source, hand=one.hand, count=count)
        else:
            raise unfit()
        bundles.append((put.with_slot("stays", stays),))
    return clause(parts, bundles)


def _put_it(parts: Parts) -> Clause:
    """A thing that was named before: "take the milk and put in the basket"."""
    *verb, where = parts
    it = Nominal("any", reference="it", determined=True, said="it")
    return _put((*verb, Items((Item(it, (where,)),))))


def _discard(parts: Parts) -> Clause:
    """What is thrown away goes into the bin."""
    each, goal = arranged(parts), Where("to", BIN, "in")
    if any(one.is_handled or one.person or (one.source and one.source.kind == BIN.kind) for one in each):
        raise unfit()
    return clause(parts, [(put_draft(thing(one, "throwing"), goal, one.source, None),) for one in each])


def _drop(parts: Parts) -> Clause:
    for one in arranged(parts):
        thing(one, "dropping")
    raise trouble("where shall it be put?", asks=True)


def _move_thing(parts: Parts) -> Clause:
    """Things that go from where they are to somewhere else; what is thrown goes into the bin alone."""
    verb = words(parts, "PUT_IN", "MOVE_THING")[0]
    into, bundles = verb.word_class == "PUT_IN", []
    for one in arranged(parts, goes=True):
        goal = one.goal
        if goal is None or (into and (goal.preposition != "in" or goal.of.sort == "room")):
            raise unfit()
        if not into and goal.role == "either" and goal.relation is None and not goal.atop:
            raise unfit()
        if "throw" in senses(parts, "PUT_IN") and goal.of.kind != BIN.kind:
            raise trouble(f"{verb.said!r}: throwing is no skill of this robot yet", verb.said)
        bundles.append((put_draft(thing(one, "moving"), goal, one.source, one.hand),))
    return clause(parts, bundles)


def _door_to_a_room(one: Arranged) -> Arranged:
    """Read "the door to the kitchen" as the kitchen door: what is opened goes nowhere."""
    door, goal = one.object, one.goal
    named = door.sort != "door" or door.name is not None
    if named or goal is None or goal.preposition != "to" or goal.of.sort != "room" or not goal.of.is_plain:
        return one
    return replace(one, object=replace(door, name=f"{goal.of.kind} {door.kind}"), goal=None)


def _opened(parts: Parts) -> Clause:
    action = "close" if words(parts, "CLOSE", "CLOSED") else "open"
    each = [_door_to_a_room(one) for one in arranged(parts, has_source=False)]
    named: list[Nominal] = []
    for one in each:
        nominal = another_of(one.object, named)
        named.append(nominal)
        if one.goal is not None or one.back or (one.person is not None and not one.person.is_person):
            raise unfit()
        where = nominal.relation
        behind = where is not None and where.kind == "behind" and not where.to.is_place
        if nominal.reference == "this" or behind:
            raise trouble("which one is meant?", asks=True)  # "the door behind you"
        if nominal.sort != "thing" and (nominal.count != 1 or nominal.plural):
            raise trouble(f"only one at a time can be told to {action}; name each of them", nominal.kind)
        told = nominal.anaphoric and nominal.sort == "any" and not nominal.is_plain
        if not (told or nominal.reference or nominal.sort in ("container", "door")):
            what = nominal.kind or "thing"
            message = f"to {action} {with_article(what)} ({what!r}) is nothing that this robot can do"
            raise trouble(message, what)
    pairs = zip(each, named, strict=True)
    opened = clause(parts, [(draft(action, object=of, hand=one.hand),) for one, of in pairs])
    return replace(opened, about=tuple(one.person for one in each if one.person is not None))


MEANINGS = meanings(
    {
        "put": _put,
        "put_it": _put_it,
        "put_into": _move_thing,
        "move_thing": _move_thing,
        "drop": _drop,
        "discard": _discard,
        "open": _opened,
        "close": _opened,
    }
)
