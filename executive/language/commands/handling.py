"""Who gets which thing: picking up, bringing, giving."""

from __future__ import annotations

from executive.language.commands import meanings
from executive.language.commands.placing import put_draft
from executive.language.phrases.arranging import ME, Arranged, arranged, clause, found_there, trouble, unfit
from executive.language.phrases.handled_thing import (
    ASKER,
    BIN,
    PREVIOUS,
    WHO_IS_MET,
    WHOEVER_IS_THERE,
    count_of,
    has_clear_place,
    thing,
)
from executive.language.phrases.lists import spoken
from executive.language.phrases.parts import Parts, senses, words
from executive.language.phrases.values import Bundle, Clause, Draft, Nominal, draft


def picked(one: Arranged, *, fetched: bool = False) -> Draft:
    """A thing, picked up; ``fetched`` where it is to be carried on."""
    nominal = thing(one, "picking up")
    if one.source == BIN:
        raise trouble("is it in the bin, or shall it go there?", asks=True)
    if fetched:
        has_clear_place(one)
    count = count_of(nominal)
    return draft(
        "pick", object=nominal, source=one.source, hand=one.hand, count=count, fetched=fetched or None
    )


def _pick(parts: Parts) -> Clause:
    how = senses(parts, "PICK", "OUT")
    if "off" in how:
        raise trouble("off what?", asks=True)  # "take the cup off"
    bundles = []
    for one in arranged(parts):
        one = one if one.object.reference else found_there(one)
        if one.goal is not None or one.back:
            raise unfit()
        if one.is_for_another and one.person is not None:
            raise trouble(f"picking up for {one.person.kind}: say to whom it shall be given", one.person.kind)
        bundles.append((picked(one).with_slot("out", "out" in how or None),))
    return clause(parts, bundles)


def _fetch(parts: Parts) -> Clause:
    bundles: list[Bundle] = []
    for one in arranged(parts):
        goal = one.goal
        if goal is not None and goal.relation:
            raise unfit()
        person = one.person if goal is None else goal.of
        has_clear_place(one)
        bundles.append((picked(one),) if person is None else handed(picked(one), person))
    return clause(parts, bundles)


def recipient(nominal: Nominal) -> Nominal:
    """Somebody, if one person can be handed things there."""
    if nominal.reference == "here":
        return ME
    if nominal.reference == "them":
        return nominal
    if not nominal.is_person:
        raise unfit()
    if nominal.count != 1 or nominal.plural:
        raise trouble("several people at once: name one", nominal.kind)
    return nominal


def handed(taken: Draft, person: Nominal) -> Bundle:
    """What is picked up, handed to somebody."""
    return (taken, draft("hand_over", object=PREVIOUS, to=recipient(person)))


def _transport(one: Arranged) -> Bundle:
    taken = picked(one, fetched=True)
    goal, beside = one.goal, one.object.relation
    if goal is None:
        if beside is not None and beside.to.is_person and beside.to.sort != "me" and one.person is None:
            raise trouble(f"is it by {beside.to.kind}, or shall it go there?", asks=True)
        return handed(taken, one.person or ASKER)
    if goal.relation is None and (goal.of.is_person or goal.of.reference == "here"):
        return handed(taken, goal.of)
    if goal.of.reference == "there":
        return (taken, draft("place", object=PREVIOUS, there=goal))
    return (taken, put_draft(PREVIOUS, goal, None, None))


def _bring(parts: Parts) -> Clause:
    """Things to where they go; verbs of mere carrying need to be told where that is."""
    each = arranged(parts)
    if words(parts, "CARRY") and any(one.goal is None for one in each):
        raise unfit()
    if len({one.goal is None and one.person is None for one in each}) > 1:
        raise trouble("where shall each of them go?", asks=True)  # "the cup to the sink and the plate"
    return clause(parts, [_transport(one) for one in each])


def _give(parts: Parts) -> Clause:
    how = senses(parts, "GIVE", "OVER")
    each = arranged(parts)
    bundles = []
    for one in each:
        person = one.goal.of if one.goal is not None else one.person
        if person is None:
            if all(other.object.is_person for other in each):
                raise trouble("what shall be given?", asks=True)
            passes = "pass" in how or one.back
            if not (passes or "over" in how):
                raise trouble("to whom?", asks=True)
            person = WHOEVER_IS_THERE if passes else WHO_IS_MET
        bundles.append(given(one, person))
    return clause(parts, bundles)


def given(one: Arranged, person: Nominal) -> Bundle:
    """A thing, handed to somebody from where it is."""
    nominal = thing(one, "handing over")
    has_clear_place(one)
    return (
        draft(
            "hand_over",
            object=nominal,
            source=one.source,
            to=recipient(person),
            hand=one.hand,
            count=count_of(nominal),
        ),
    )


def _can_i_have(parts: Parts) -> Clause:
    each = arranged(parts)
    if any(one.goal is not None or one.back for one in each):
        raise unfit()
    return clause(parts, [given(one, ME) for one in each])


def _wants(parts: Parts) -> Clause:
    """A wish, of whoever speaks or of somebody else: whether it is an order is asked."""
    who = next((part for part in parts if isinstance(part, Nominal)), ME)
    for one in arranged(parts):
        thing(one, "wanting")
        if one.goal is not None:
            raise unfit()
    raise trouble(f"shall it be brought to {'you' if who.sort == 'me' else spoken(who)}?", asks=True)


MEANINGS = meanings(
    {
        "pick": _pick,
        "fetch": _fetch,
        "bring": _bring,
        "carry": _bring,
        "give": _give,
        "can_i_have": _can_i_have,
        "want": _wants,
        "wants_for": _wants,
    }
)
