"""Where things are put, and what is opened and closed."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from types import MappingProxyType
from typing import Any

from executive.language.phrases.arranging import Arranged, arranged, clause, guarded, trouble, unfit
from executive.language.phrases.handled_thing import BACK, BIN, count_of, thing
from executive.language.phrases.lists import another_of
from executive.language.phrases.parts import Parts, words
from executive.language.phrases.values import (
    HARMS,
    Bundle,
    Clause,
    Items,
    Meaning,
    Nominal,
    Relative,
    Where,
    draft,
)
from executive.language.text.word import Word
from robots.scenes.furniture_names import kind_called
from trees.beliefs.grounding.articles import with_article

_PLACING = frozenset({"place", "placing", "set", "setting", "deposit", "depositing", "position", "drop off"})
"""Verbs of which nobody thinks that they say what to wear, as of "put on the hat"."""

_SURFACES = frozenset(
    {"table", "counter", "shelf", "bookshelf", "bench", "nightstand", "windowsill", "stove", "island"}
)
"""Furniture at which a thing is put by putting it onto it."""

_DROPS = frozenset({"drop", "dropping"})
"""Verbs with which "off" before a place says that a thing is left there."""

_LEAVES = frozenset({"leave", "leaving", "left"})
"""Verbs that may as well say that nothing is to be moved."""

_HOLDS = frozenset(
    {"bowl", "basket", "box", "toolbox", "bag", "bucket", "jar", "cup", "glass", "pot", "pan", "backpack"}
    | {"suitcase", "container", "storage box", "storage bin", "wire basket", "pencil case", "toolkit", "tote"}
)
"""Things that others are moved to by putting them into it."""

_CARRIES = frozenset({"plate", "tray", "platter", "pallet", "saucer"})
"""Things that others are moved to by putting them onto it."""

HOLDERS = _HOLDS | _CARRIES
"""Things that others are put into or onto."""

_ADHESIVE = frozenset({"sticker", "label", "stamp", "poster", "tape", "magnet", "sticky note", "post-it"})
"""Things that "to stick" makes hold where they are put."""

_SHELVES = frozenset({"shelf", "bookshelf"})
"""Furniture that things are put into as well as onto."""


def one_at_a_time(action: str) -> str:
    """The refusal of opening or closing several things at once."""
    return f"only one at a time can be told to {action}; name each of them"


def put_draft(nominal: Nominal, goal: Where, source: Nominal | None, hand: str | None) -> Any:
    """The task that puts a thing to where it goes."""
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
    if goal.preposition == "at" and of.sort == "furniture" and kind_called(of.kind or "") not in _SURFACES:
        raise trouble(f"on the {of.kind}, or next to it?", asks=True)
    if goal.preposition == "on":
        if of.sort == "room":
            raise unfit()
        return draft("place", **slots, on=of)
    if of.sort == "furniture":
        return draft("place", **slots, on=of)
    if of.sort in ("container", "room"):
        return draft("place", **slots, to=of)
    if of.sort == "thing" and goal.preposition == "to" and of.is_single:
        raise trouble(f"into the {of.kind}, onto it or next to it?", asks=True)
    raise unfit()


def _put(parts: Parts) -> Clause:
    each = arranged(parts, goes=True)
    down = bool(words(parts, "DOWN")) or any("down" in part.said for part in parts if isinstance(part, Word))
    stays = any(word.said in _LEAVES for word in words(parts, "PUT"))
    bundles: list[Bundle] = []
    for one in each:
        nominal = thing(one, "putting down")
        if one.is_for_another:
            raise unfit()
        if one.goal is not None:
            bundles.append((put_draft(nominal, one.goal, one.source, one.hand),))
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
    if stays:
        bundles = [tuple(each.with_slot("stays", True) for each in bundle) for bundle in bundles]
    return clause(parts, bundles)


def _drop_off(parts: Parts) -> Clause:
    """What is carried somewhere and put down there: "drop it off at the sink"."""
    dropped = words(parts, "PUT")[0].said in _DROPS
    if not dropped or any(one.goal is None for one in arranged(parts, goes=True)):
        raise unfit()
    return _put(parts)


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
        [(put_draft(thing(one, "throwing"), one.goal, one.source, one.hand),) for one in each if one.goal],
    )


def _stick(parts: Parts) -> Clause:
    """Put onto furniture or next to something, as people say who are in a hurry; into is ``put_into``."""
    verb = words(parts, "STICK")[0].said
    for one in arranged(parts, goes=True):
        goal = one.goal
        known = goal is not None and (goal.relation is not None or goal.of.reference == "there")
        if one.back or known:
            continue
        if goal is None or goal.preposition != "on":
            raise unfit()
        if one.object.kind in _ADHESIVE or goal.of.sort != "furniture":
            raise trouble(f"making things hold somewhere ({verb!r}) is no skill of this robot yet", verb)
    return _put(parts)


def _discard(parts: Parts) -> Clause:
    """What is thrown away goes into the bin."""
    each = [_thrown(one) for one in arranged(parts)]
    details = [
        where for part in parts if isinstance(part, Items) for item in part.each for where in item.details
    ]
    out = any(isinstance(one, Where) and one.role == "from" and one.of.kind == BIN.kind for one in details)
    if out or any(one.goal is not None or one.back or one.person is not None for one in each):
        raise unfit()
    goal = Where("to", BIN, "in")
    bundles = [(put_draft(thing(one, "throwing"), goal, one.source, one.hand),) for one in each]
    return clause(parts, bundles)


def _thrown(one: Arranged) -> Arranged:
    """Read "discard it in the bin" as into it; what is in the bin is thrown away."""
    source = one.source
    if source is None or source.kind != BIN.kind:
        return one
    if source == BIN or source.relation is not None:
        raise unfit()
    return replace(one, source=None)


def _received(one: Arranged, verb: str) -> Arranged:
    """Read "to the basket" as into it where nothing else is meant: from somewhere, or back."""
    goal = one.goal
    if goal is None or goal.preposition != "to" or goal.of.sort != "thing" or goal.relation is not None:
        return one
    if one.source is None and not verb.startswith("return"):
        return one  # "move the cup to the box" may be beside it
    if goal.of.kind in _HOLDS:
        return replace(one, goal=replace(goal, preposition="in"))
    return replace(one, goal=replace(goal, preposition="on")) if goal.of.kind in _CARRIES else one


def _move_thing(parts: Parts) -> Clause:
    return moved(parts, words(parts, "MOVE_THING")[0].said)


def moved(parts: Parts, verb: str) -> Clause:
    """Things that go from where they are to somewhere else."""
    each = [_received(one, verb) for one in arranged(parts, goes=True)]
    for one in each:
        if one.goal is None:
            raise unfit()
        if one.goal.role == "either" and one.goal.relation is None and not one.goal.atop:
            raise unfit()
    return clause(
        parts,
        [(put_draft(thing(one, "moving"), one.goal, one.source, one.hand),) for one in each if one.goal],
    )


def _put_where(parts: Parts) -> Clause:
    """Put it where the bowl is: that is the bowl's place by now."""
    of = next(part for part in parts if isinstance(part, Nominal))
    if of.reference or of.is_person:
        raise unfit()
    raise trouble(f"on the {of.kind or 'other'}, in it or next to it?", asks=True)


def _put_with_others(parts: Parts) -> Clause:
    """Put it with the others: of which nothing tells what they are."""
    others = words(parts, "WITH_OTHERS")[0].said.rpartition(" the ")[2]
    items = next(part for part in parts if isinstance(part, Items))
    reference = next((one.of.reference for one in items.each if one.of.reference), None)
    if reference is None:
        raise trouble(f"what does 'the {others}' stand for?", asks=True)
    raise trouble(f"what do {reference!r} and 'the {others}' stand for?", asks=True)


def _drop(parts: Parts) -> Clause:
    each = arranged(parts)
    for one in each:
        thing(one, "dropping")
        if one.goal is not None or one.source is not None or one.back:
            raise unfit()
    if len(each) == 1 and each[0].object.reference == "it":  # "lower it onto the table and let go of it"
        return clause(parts, [(draft("place", object=each[0].object, lets_go=True),)])
    raise trouble("where shall it be put?", asks=True)


def _stays_so(parts: Parts) -> Clause:
    """Leave the door open."""
    words_said = words(parts, "LEAVE_SO", "OPENED", "CLOSED")
    said = f"{words_said[0].said} ... {words_said[-1].said}"
    raise trouble(f"{said!r}: what is to stay as it is needs no task; say 'open' or 'close'", said)


def _is_open(parts: Parts) -> Clause:
    """Is the fridge open?"""
    word = words(parts, "OPENED", "CLOSED")[-1].said
    raise trouble(f"whether something is {word!r} is not told by this robot yet", word)


def _door_to_a_room(one: Arranged) -> Arranged:
    """Read "the door to the kitchen" as the kitchen door: what is opened goes nowhere."""
    door, goal = one.object, one.goal
    if door.sort != "door" or goal is None or goal.preposition != "to" or goal.of.sort != "room":
        return one
    if door.name is not None or not goal.of.is_plain:
        return one
    return replace(one, object=replace(door, name=f"{goal.of.kind} {door.kind}"), goal=None)


def _opened(action: str) -> Callable[[Parts], Clause]:
    def meaning(parts: Parts) -> Clause:
        bundles = []
        named: list[Nominal] = []
        each = arranged(parts, has_source=False)
        for one in each:
            one = _door_to_a_room(one)
            nominal = another_of(one.object, named)
            named.append(nominal)
            if one.goal is not None or one.back or (one.person is not None and not one.person.is_person):
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
                and relation.kind == "behind"
                and (relation.to.sort == "you" or relation.to.is_person)
            ):
                who = "the robot" if relation.to.sort == "you" else relation.to.kind or "somebody"
                raise trouble(f"which door? is it behind {who}, or the one just walked through?", asks=True)
            if nominal.sort != "thing" and (nominal.count != 1 or nominal.plural):
                raise trouble(one_at_a_time(action), nominal.kind)
            if nominal.anaphoric and nominal.sort == "any" and not nominal.is_plain:
                bundles.append((draft(action, object=nominal, hand=one.hand),))
                continue  # "open the top drawer, then close the bottom one"
            if not nominal.reference and nominal.sort not in ("container", "door"):
                what = nominal.kind or "thing"
                raise trouble(
                    f"to {action} {with_article(what)} ({what!r}) is nothing that this robot can do", what
                )
            bundles.append((draft(action, object=nominal, hand=one.hand),))
        about = tuple(one.person for one in each if one.person is not None)
        return replace(clause(parts, bundles), about=about)

    return meaning


def _close_again(parts: Parts) -> Clause:
    """Close what was opened before, which the references tell."""
    closed: Clause = _opened("close")(parts)
    bundles = tuple(tuple(one.with_slot("again", True) for one in bundle) for bundle in closed.bundles)
    return replace(closed, bundles=bundles)


def _push(parts: Parts) -> Clause:
    verb = words(parts, "PULL", "PUSH")[0].said
    items = next(part for part in parts if isinstance(part, Items))
    if any(item.of.is_person and item.of.sort != "me" for item in items.each):
        raise trouble(f"{verb!r} {HARMS}", verb)
    arranged(parts)
    raise trouble(f"pushing or pulling things ({verb!r}) is no skill of this robot yet", verb)


_COMMANDS: Mapping[str, Callable[[Parts], Any]] = {
    "put": _put,
    "put_where": _put_where,
    "put_with_others": _put_with_others,
    "drop_off": _drop_off,
    "put_into": _put_into,
    "stick": _stick,
    "move_thing": _move_thing,
    "drop": _drop,
    "discard": _discard,
    "stays_so": _stays_so,
    "is_open": _is_open,
    "open": _opened("open"),
    "close": _opened("close"),
    "close_again": _close_again,
    "push": _push,
}

MEANINGS: Mapping[str, Meaning] = MappingProxyType(
    {name: guarded(meaning) for name, meaning in _COMMANDS.items()}
)
