"""What is done with things: picking, bringing, giving, placing, opening."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from types import MappingProxyType
from typing import Any

from executive.language.arranging import ME, Arranged, Parts, arranged, clause, guarded, trouble, unfit
from executive.language.lattice import Word
from executive.language.nominals import said_again, shared_adjective, words
from executive.language.phrases import (
    Bundle,
    Clause,
    Item,
    Meaning,
    Mention,
    Nominal,
    Pair,
    Relative,
    Where,
    draft,
)

PREVIOUS = Nominal("any", reference="previous", determined=True)
IT = Nominal("any", reference="it", determined=True)
ASKER = Nominal("me", "me", reference="asker", determined=True)
"""Who asks for a thing, when nobody is said to get it."""

BACK = Nominal("any", reference="there", name="back")
"""The place that a thing was taken from."""

_SHARP = frozenset({"knife", "scissors", "screwdriver", "drill"})
_CHILDREN = frozenset({"child", "baby", "boy", "girl"})

_SURFACES = frozenset(
    {"table", "counter", "shelf", "bookshelf", "bench", "nightstand", "windowsill", "stove", "island"}
)
"""Furniture at which a thing is put by putting it onto it."""

_SHELVES = frozenset({"shelf", "bookshelf"})
"""Furniture that things are put into as well as onto."""


def thing(one: Arranged, doing: str) -> Nominal:
    """The object, if it is something that a hand can take."""
    nominal = one.object
    if nominal.is_person or nominal.sort == "you":
        raise trouble(f"{doing} a person ({nominal.kind!r}) is nothing that this robot does", nominal.kind)
    if nominal.is_place:
        raise trouble(
            f"{doing} the {nominal.kind} ({nominal.kind!r}) is nothing that this robot can do", nominal.kind
        )
    if nominal.reference == "this":
        raise trouble("which one is meant?", asks=True)
    unclear = nominal.plural and not nominal.reference and not nominal.counted and not nominal.determined
    if unclear or nominal.count == "some":
        raise trouble("how many of them?", asks=True)
    if (
        nominal.sort == "any"
        and nominal.kind is None
        and not nominal.reference
        and nominal.is_plain
        and nominal.count == 1
        and one.source is None
    ):
        raise trouble("which object is meant?", asks=True)
    if nominal.plural and not nominal.reference and not nominal.counted:
        nominal = replace(nominal, count="all")
    return nominal


def count_of(nominal: Nominal) -> int | str | None:
    """The slot ``count``, unless it is one."""
    return None if nominal.count == 1 else nominal.count


def _pick_bundle(one: Arranged, *, doing: str = "picking up", fetched: bool = False) -> Any:
    nominal = thing(one, doing)
    return draft(
        "pick",
        object=nominal,
        source=one.source,
        hand=one.hand,
        count=count_of(nominal),
        fetched=fetched or None,
    )


def _pick(parts: Parts) -> Clause:
    each = arranged(parts)
    each = [_from_there(one) for one in each]
    for one in each:
        if one.goal is not None or one.back:
            raise unfit()
        if one.person is not None and one.person.sort != "me":
            raise trouble(f"picking up for {one.person.kind}: say to whom it shall be given", one.person.kind)
    return clause(parts, [(_pick_bundle(one),) for one in each])


def _from_there(one: Arranged) -> Arranged:
    """Read "there" of a thing that is picked up as the place that was named."""
    if one.goal is not None and one.goal.of.reference == "there" and one.source is None:
        return replace(one, goal=None, source=one.goal.of)
    return one


def _fetch(parts: Parts) -> Clause:
    each = arranged(parts)
    bundles = []
    for one in each:
        person = one.person
        if one.goal is not None:
            if one.goal.relation is not None or not (
                one.goal.of.is_person or one.goal.of.reference == "here"
            ):
                raise unfit()
            person = one.goal.of
        taken = _pick_bundle(one)
        bundles.append((taken,) if person is None else _handed(one, taken, person))
    return clause(parts, bundles)


def _recipient(nominal: Nominal) -> Nominal:
    if nominal.reference == "here":
        return ME
    if nominal.reference == "them":
        return nominal
    if not nominal.is_person:
        raise unfit()
    if nominal.count != 1 or nominal.plural:
        raise trouble("several people at once: name one", nominal.kind)
    return nominal


def _handed(one: Arranged, taken: Any, person: Nominal) -> Bundle:
    _safe_for(one.object, person)
    return (taken, draft("hand_over", object=PREVIOUS, to=_recipient(person)))


def _is_beside_somebody(relation: Relative) -> bool:
    return relation.to.is_person and relation.to.sort != "me" and relation.kind != "nearest"


def _transport(one: Arranged) -> Bundle:
    taken = _pick_bundle(one, doing="taking away", fetched=True)
    goal, relation = one.goal, one.object.relation
    if goal is None and one.person is None and relation is not None and _is_beside_somebody(relation):
        where = f"{relation.kind.replace('_', ' ')} {relation.to.kind}"
        raise trouble(f"is it {where}, or shall it go there?", asks=True)
    if goal is None:
        return _handed(one, taken, one.person or ASKER)
    if goal.relation is None and (goal.of.is_person or goal.of.reference == "here"):
        return _handed(one, taken, goal.of)
    if goal.of.reference == "there":
        return (taken, draft("place", object=PREVIOUS, there=goal))
    return (taken, _put_draft(PREVIOUS, goal, None, None))


def _bring(parts: Parts) -> Clause:
    return clause(parts, [_transport(one) for one in arranged(parts)])


_PLACING = frozenset({"place", "placing", "set", "setting", "deposit", "depositing", "position", "drop off"})
"""Verbs of which nobody thinks that they say what to wear, as of "put on the hat"."""


def _with_it(parts: Parts) -> Parts:
    """With the thing that a terse command leaves out: "take the cup, place on the shelf"."""
    return (*(part for part in parts if isinstance(part, Word)), Item(IT), *parts[1:])


def _put_it(parts: Parts) -> Clause:
    if words(parts, "PUT")[0].said not in _PLACING:
        raise unfit()
    return _put(_with_it(parts))


def _bring_it(parts: Parts) -> Clause:
    if any(isinstance(part, Where) and part.of.is_place and part.relation for part in parts):
        raise unfit()
    if words(parts, "CARRY") and any(
        isinstance(part, Where) and part.of.reference == "here" for part in parts
    ):
        raise unfit()
    return _bring(_with_it(parts))


def _give_it(parts: Parts) -> Clause:
    return _give(_with_it(parts))


def _carry(parts: Parts) -> Clause:
    each = arranged(parts)
    if any(one.goal is None for one in each):
        raise unfit()
    return clause(parts, [_transport(one) for one in each])


def _pairs(parts: Parts) -> list[tuple[Nominal, Arranged]]:
    result = []
    for pair in (part for part in parts if isinstance(part, Pair)):
        (one,) = arranged((pair.item,))
        if one.goal is not None or (one.person is not None and one.person.sort != "me"):
            raise unfit()
        result.append((_recipient(pair.person), one))
    return result


def _bring_pairs(parts: Parts) -> Clause:
    bundles: list[Bundle] = []
    person = ME
    for person, one in _pairs(parts):
        bundles.append(_handed(one, _pick_bundle(one, fetched=True), person))
    bundles += [_handed(one, _pick_bundle(one, fetched=True), person) for one in _more(parts)]
    return clause(parts, bundles)


def _more(parts: Parts) -> list[Arranged]:
    """Further things for the same person: "me the cup and the bottle"."""
    loose = tuple(part for part in parts if isinstance(part, Item))
    if not loose:
        return []
    paired = [part.item for part in parts if isinstance(part, Pair)]
    each_item = (*paired, *loose)
    again = said_again(each_item[-2].of, each_item[-1].of, parts)
    if again is not None:
        raise trouble(again.message, asks=True)
    unclear = shared_adjective(each_item)
    if unclear is not None:
        raise trouble(unclear.message, asks=True)
    each = arranged(loose)
    if any(one.goal is not None or one.person is not None for one in each):
        raise unfit()
    return each


def _pair(parts: Parts) -> Pair | None:
    person, item = parts
    if not isinstance(person, Nominal) or not person.is_person or item.of.is_person:
        return None
    return Pair(person, item)


def _give(parts: Parts) -> Clause:
    each = arranged(parts)
    over = bool(words(parts, "OVER")) or any("over" in part.said for part in parts if isinstance(part, Word))
    bundles = []
    for one in each:
        if one.goal is not None and one.goal.relation is not None:
            raise unfit()
        person = one.goal.of if one.goal is not None else one.person
        if person is None:
            if not over and not one.back:
                raise trouble("to whom?", asks=True)
            person = ASKER
        bundles.append(_give_bundle(one, person))
    return clause(parts, bundles)


def _safe_for(nominal: Nominal, person: Nominal) -> None:
    if nominal.kind in _SHARP and person.kind in _CHILDREN:
        raise trouble(f"a {nominal.kind} is not handed to a {person.kind}", nominal.kind)


def _give_bundle(one: Arranged, person: Nominal) -> Bundle:
    nominal = thing(one, "handing over")
    _safe_for(nominal, person)
    return (
        draft(
            "hand_over",
            object=nominal,
            source=one.source,
            to=_recipient(person),
            hand=one.hand,
            count=count_of(nominal),
        ),
    )


def _give_pairs(parts: Parts) -> Clause:
    pairs = _pairs(parts)
    bundles = [_give_bundle(one, person) for person, one in pairs]
    bundles += [_give_bundle(one, pairs[-1][0]) for one in _more(parts)]
    return clause(parts, bundles)


def _can_i_have(parts: Parts) -> Clause:
    each = arranged(parts)
    if any(one.goal is not None or one.back for one in each):
        raise unfit()
    return clause(parts, [_give_bundle(one, ME) for one in each])


def _put_draft(nominal: Nominal, goal: Where, source: Nominal | None, hand: str | None) -> Any:
    of = goal.of
    slots = {"object": nominal, "source": source, "hand": hand, "count": count_of(nominal)}
    if of.count != 1:
        raise trouble("several places at once: name one", of.kind)
    if goal.relation is not None:
        return draft("place", **slots, to=Relative(goal.relation, of))
    if of.reference == "here" or of.reference == "this":
        raise trouble("where shall it be put?", asks=True)
    if of.reference == "there":
        return draft("place", **slots, there=goal)
    if of.is_person:
        raise trouble(f"nothing is put on or into a person ({of.kind!r})", of.kind)
    if of.sort == "you":
        raise unfit()
    if goal.preposition == "in":
        if of.sort == "room":
            return draft("place", **slots, to=of)
        if of.sort == "furniture" and of.kind in _SHELVES:
            return draft("place", **slots, on=of)
        if of.sort in ("furniture", "door"):
            raise trouble(f"nothing can be put into the {of.kind}", of.kind)
        return draft("put_in", **slots, to=of)
    if of.sort == "door" and goal.preposition == "at":
        return draft("place", **slots, to=Relative("next_to", of))
    if of.sort == "door":
        raise trouble(f"nothing can be put on the {of.kind}", of.kind)
    if goal.preposition == "at" and of.sort == "furniture" and of.kind not in _SURFACES:
        raise trouble(f"on the {of.kind}, or next to it?", asks=True)
    if goal.preposition == "on":
        if of.sort == "room":
            raise unfit()
        return draft("place", **slots, on=of)
    if of.sort == "furniture":
        return draft("place", **slots, on=of)
    if of.sort in ("container", "room"):
        return draft("place", **slots, to=of)
    raise unfit()


def _put(parts: Parts) -> Clause:
    each = arranged(parts, goes=True)
    down = bool(words(parts, "DOWN")) or any("down" in part.said for part in parts if isinstance(part, Word))
    bundles: list[Bundle] = []
    for one in each:
        nominal = thing(one, "putting down")
        if one.person is not None and one.person.sort != "me":
            raise unfit()
        if one.goal is not None:
            bundles.append((_put_draft(nominal, one.goal, one.source, one.hand),))
        elif one.back:
            bundles.append((draft("place", object=nominal, hand=one.hand, there=Where("to", BACK, "at")),))
        elif down and nominal.count == "all" and nominal.sort == "any" and nominal.is_plain:
            raise trouble("what shall be put down?", asks=True)
        elif down:
            bundles.append(
                (draft("place", object=nominal, source=one.source, hand=one.hand, count=count_of(nominal)),)
            )
        else:
            raise unfit()
    return clause(parts, bundles)


def _put_into(parts: Parts) -> Clause:
    each = arranged(parts, goes=True)
    if any(one.goal is None or one.goal.preposition != "in" or one.goal.of.sort == "room" for one in each):
        raise unfit()
    verb = words(parts, "PUT_IN")[0]
    if verb.said.split()[0] in ("throw", "toss") and any(
        one.goal is not None and one.goal.of.kind != "bin" for one in each
    ):
        raise trouble(f"{verb.said!r}: throwing is no skill of this robot yet", verb.said)
    return clause(
        parts,
        [(_put_draft(thing(one, "throwing"), one.goal, one.source, one.hand),) for one in each if one.goal],
    )


def _move_thing(parts: Parts) -> Clause:
    each = arranged(parts, goes=True)
    for one in each:
        if one.goal is None:
            raise unfit()
        if one.goal.role == "either" and one.goal.relation is None and not one.goal.atop:
            raise unfit()
    return clause(
        parts,
        [(_put_draft(thing(one, "moving"), one.goal, one.source, one.hand),) for one in each if one.goal],
    )


def _drop(parts: Parts) -> Clause:
    each = arranged(parts)
    for one in each:
        thing(one, "dropping")
        if one.goal is not None or one.source is not None or one.back:
            raise unfit()
    raise trouble("where shall it be put?", asks=True)


def _mention(parts: Parts) -> Clause:
    """A statement of where a thing is."""
    each = arranged(tuple(part for part in parts if isinstance(part, (Item, Where))))
    (one,) = each
    nominal = one.object
    if one.goal is not None or one.back or one.hand is not None or one.person is not None:
        raise unfit()
    placed = one.source is not None or nominal.relation is not None
    if nominal.sort != "thing" or nominal.reference or not placed or nominal.anaphoric:
        raise unfit()
    if nominal.count == "some" or (nominal.plural and not nominal.counted and not nominal.determined):
        raise trouble("how many of them?", asks=True)
    if nominal.plural and not nominal.counted:
        nominal = replace(nominal, count="all")
    return Clause((), "base", mention=Mention(nominal, one.source))


def _want(parts: Parts) -> Clause:
    each = arranged(parts)
    for one in each:
        thing(one, "wanting")
        if one.goal is not None:
            raise unfit()
    raise trouble("shall it be brought to you?", asks=True)


def _opened(action: str) -> Callable[[Parts], Clause]:
    def meaning(parts: Parts) -> Clause:
        bundles = []
        for one in arranged(parts, has_source=False):
            nominal = one.object
            if one.goal is not None or one.back or (one.person is not None and one.person.sort != "me"):
                raise unfit()
            if nominal.reference == "this":
                raise trouble("which one is meant?", asks=True)
            pulled = any(word.said.startswith("pull") and "out" in word.said for word in words(parts, "OPEN"))
            if pulled and nominal.kind not in ("drawer", "drawers"):
                raise unfit()
            relation = nominal.relation
            if (
                nominal.sort == "door"
                and relation is not None
                and (relation.kind, relation.to.sort) == ("behind", "you")
            ):
                raise trouble("which door? is it behind the robot, or the one it walks through?", asks=True)
            if nominal.count != 1 or nominal.plural:
                raise trouble(f"only one at a time can be told to {action}", nominal.kind)
            if not nominal.reference and nominal.sort not in ("container", "door"):
                what = nominal.kind or "thing"
                raise trouble(f"to {action} a {what} ({what!r}) is nothing that this robot can do", what)
            bundles.append((draft(action, object=nominal, hand=one.hand),))
        return clause(parts, bundles)

    return meaning


def _push(parts: Parts) -> Clause:
    arranged(parts)
    verb = words(parts, "PULL", "PUSH")[0].said
    raise trouble(f"pushing or pulling things ({verb!r}) is no skill of this robot yet", verb)


_COMMANDS: Mapping[str, Callable[[Parts], Any]] = {
    "pick": _pick,
    "fetch": _fetch,
    "bring": _bring,
    "carry": _carry,
    "put_it": _put_it,
    "bring_it": _bring_it,
    "give_it": _give_it,
    "bring_pairs": _bring_pairs,
    "give": _give,
    "give_pairs": _give_pairs,
    "can_i_have": _can_i_have,
    "put": _put,
    "put_into": _put_into,
    "move_thing": _move_thing,
    "drop": _drop,
    "want": _want,
    "mention": _mention,
    "open": _opened("open"),
    "close": _opened("close"),
    "push": _push,
}

MEANINGS: Mapping[str, Meaning] = MappingProxyType(
    {"pair": _pair, **{name: guarded(meaning) for name, meaning in _COMMANDS.items()}}
)
