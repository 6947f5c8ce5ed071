"""Who gets which thing: picking, bringing, giving."""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Iterable, Mapping
from types import MappingProxyType
from typing import Any

from executive.language.commands.placing import put_draft
from executive.language.phrases.arranging import (
    ME,
    Arranged,
    TroubleError,
    arranged,
    clause,
    found_there,
    guarded,
    trouble,
    unfit,
)
from executive.language.phrases.handled_thing import (
    ASKER,
    BIN,
    IT,
    PREVIOUS,
    TRASH,
    WHO_IS_MET,
    WHOEVER_IS_THERE,
    count_of,
    has_clear_place,
    only_for,
    thing,
)
from executive.language.phrases.lists import spoken
from executive.language.phrases.parts import Parts, words
from executive.language.phrases.values import (
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


def picked(one: Arranged, *, doing: str = "picking up", fetched: bool = False) -> Any:
    """A thing, picked up; ``fetched`` where it is to be carried on."""
    nominal = thing(one, doing)
    if one.source is not None and one.source.said == TRASH:
        raise trouble("is it in the bin, or shall it go there?", asks=True)
    if fetched:
        has_clear_place(one)
    return draft(
        "pick",
        object=nominal,
        source=one.source,
        hand=one.hand,
        count=count_of(nominal),
        fetched=fetched or None,
    )


_TAKES = frozenset({"take", "taking"})
"""Verbs of which "take it there" is to carry it."""

_CHOOSES = frozenset({"pick", "picking"})
"""Verbs that with "out" mean to choose."""

_EXTRACTS = frozenset({"extract", "extracting", "extracted"})
"""Verbs that mean to take out, of what was opened."""

_LIFTS = frozenset({"lift", "lifting", "raise", "raising"})
"""Verbs of what may be in the hand by then."""

_REACHES = frozenset({"reach", "reaching"})
"""Verbs after which it may be said what the hand does there."""

_GATHERS = frozenset({"gather", "gathering", "collect", "collecting"})
"""Verbs after which "in" may say where things are, or where they are put together."""

_FETCHES = frozenset({"grab", "go grab", "grabbing"})
"""Verbs that are "to fetch" as well, where it is said for whom."""


def _pick(parts: Parts) -> Clause:
    _gathers_where(parts)
    taken = any(word.said in _TAKES for word in words(parts, "PICK"))
    carried = [one for one in arranged(parts) if taken and one.goal is not None and one.object.reference]
    each = [one if one in carried else found_there(one) for one in arranged(parts)]
    fetches = any(word.said in _FETCHES for word in words(parts, "PICK"))
    for one in each:
        if one.object.reference == "this" and one.goal is not None and one.goal.of.reference == "here":
            raise trouble("which one is meant?", asks=True)  # "pick up this one here"
        if fetches and one.person is not None and one.person.sort == "me":
            raise unfit()  # "grab it for me" is to be brought, as "get it for me" is
        if one.back or (one.goal is not None and (taken or not _goes_onto(one.goal))):
            raise unfit()
        if one.person is not None and one.person.sort != "me":
            raise trouble(f"picking up for {one.person.kind}: say to whom it shall be given", one.person.kind)
    bundles = [(_lifted(one),) for one in each]
    if any(word.meaning == "off" for word in words(parts, "OUT")):
        raise trouble("off what?", asks=True)  # "take the cup off"
    verbs = [word.said.split() for word in words(parts, "PICK", "OUT")]
    if any(said[0] in _EXTRACTS or ("out" in said and said[0] not in _CHOOSES) for said in verbs):
        bundles = [(one.with_slot("out", True),) if one.action == "pick" else (one,) for (one,) in bundles]
    if any(word.said.split()[0] in _LIFTS for word in words(parts, "PICK_UP", "PICK")):
        bundles = [(one.with_slot("lifts", True),) for (one,) in bundles]
    if any(word.said.split()[0] in _REACHES for word in words(parts, "PICK")):
        bundles = [(one.with_slot("reaches", True),) for (one,) in bundles]
    if any(word.said.startswith("hold") for word in words(parts, "PICK_UP", "PICK")):
        bundles = [(one.with_slot("holds", True),) for (one,) in bundles]
    return clause(parts, bundles)


def _gathers_where(parts: Parts) -> None:
    """Ask whether things are in a box, or are gathered there.

    Raises:
        TroubleError: It may be either.
    """
    if not any(word.said in _GATHERS for word in words(parts, "PICK_UP", "PICK")):
        return
    said = [one for part in parts if isinstance(part, Items) for item in part.each for one in item.details]
    for one in (*parts, *said):
        if (
            isinstance(one, Where)
            and (one.role, one.preposition) == ("either", "in")
            and one.of.sort != "room"
        ):
            kind = one.of.kind or "that"
            raise trouble(f"are they in the {kind}, or shall they be put there?", one.of.kind, asks=True)


def _clear(parts: Parts) -> Clause:
    """A thing that is named and is in the way somewhere: "clear the bowl off the table"."""
    said = [one for part in parts if isinstance(part, Items) for item in part.each for one in item.details]
    from_there = any(isinstance(one, Where) and one.role == "from" for one in (*parts, *said))
    if not from_there or any(one.object.sort != "thing" or not one.source for one in arranged(parts)):
        verb = words(parts, "CLEAR")[0].said
        told = f"housework ({verb!r}) is no skill of this robot yet; say what is taken from where"
        raise trouble(told, verb)
    return _pick(parts)


def _goes_onto(goal: Where) -> bool:
    """Whether "onto" or "into" says where a thing goes that is lifted, so that it is put there.

    To a room it is carried, and "in the trash" may be where it is.
    """
    put = goal.role == "to" and goal.relation is None and goal.preposition in ("on", "in")
    return put and goal.of.reference is None and goal.of.sort != "room" and goal.of != BIN


def _lifted(one: Arranged) -> Any:
    if one.goal is None or not _goes_onto(one.goal):
        return picked(one)
    return put_draft(thing(one, "moving"), one.goal, one.source, one.hand)


def _get_out(parts: Parts) -> Clause:
    if words(parts, "OUT")[0].said not in ("out", "down"):
        raise unfit()
    return _pick(parts)


def _fetch(parts: Parts) -> Clause:
    each = arranged(parts)
    bundles: list[Bundle] = []
    for one in each:
        person = one.person
        if one.goal is not None and _goes_onto(one.goal) and person is None:
            bundles.append((_lifted(one),))
            continue
        if one.goal is not None:
            if one.goal.relation is not None or not (
                one.goal.of.is_person or one.goal.of.reference == "here"
            ):
                raise unfit()
            person = one.goal.of
            only_for(one, person)
        has_clear_place(one)
        if one.object.sort == "door":
            raise trouble(f"shall the {one.object.kind} be opened, or closed?", asks=True)
        taken = picked(one)
        bundles.append((taken,) if person is None else handed(taken, person))
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


def handed(taken: Any, person: Nominal) -> Bundle:
    """What is picked up, handed to somebody."""
    return (taken, draft("hand_over", object=PREVIOUS, to=recipient(person)))


def _is_beside_somebody(relation: Relative) -> bool:
    return relation.to.is_person and relation.to.sort != "me" and relation.kind != "nearest"


def _transport(one: Arranged) -> Bundle:
    taken = picked(one, doing="taking away", fetched=True)
    goal, relation = one.goal, one.object.relation
    if goal is None and one.person is None and relation is not None and _is_beside_somebody(relation):
        where = f"{relation.kind.replace('_', ' ')} {relation.to.kind}"
        raise trouble(f"is it {where}, or shall it go there?", asks=True)
    if goal is None:
        return handed(taken, one.person or ASKER)
    only_for(one, goal.of)
    if goal.relation is None and (goal.of.is_person or goal.of.reference == "here"):
        return handed(taken, goal.of)
    if goal.of.reference == "there":
        return (taken, draft("place", object=PREVIOUS, there=goal))
    return (taken, put_draft(PREVIOUS, goal, None, None))


def _bring(parts: Parts) -> Clause:
    each = arranged(parts)
    if len({one.goal is None and one.person is None for one in each}) > 1:
        raise trouble("where shall each of them go?", asks=True)  # "the cup to the sink and the plate"
    return clause(parts, [_transport(one) for one in each])


def _bring_it_me(parts: Parts) -> Clause:
    """Bring me: what was taken before."""
    return clause(parts, [_transport(Arranged(IT, person=ME))])


def _give_it_me(parts: Parts) -> Clause:
    return clause(parts, [given(Arranged(IT), ME)])


def _carry(parts: Parts) -> Clause:
    each = arranged(parts)
    if any(one.goal is None for one in each):
        raise unfit()
    return clause(parts, [_transport(one) for one in each])


_PASSES = frozenset({"pass", "passing"})
"""Verbs that mean to whoever speaks, unless somebody else is named: "pass the salt"."""


def _give(parts: Parts) -> Clause:
    each = arranged(parts)
    over = bool(words(parts, "OVER")) or any("over" in part.said for part in parts if isinstance(part, Word))
    passes = any(word.said in _PASSES for word in words(parts, "GIVE"))
    bundles = []
    for one in each:
        if one.goal is not None and one.goal.relation is not None:
            raise unfit()
        person = one.goal.of if one.goal is not None else one.person
        if person is None:
            if all(each_one.object.is_person for each_one in each):
                raise trouble(f"what shall be given to {_whom(each)}?", asks=True)
            if not (over or passes or one.back):
                raise trouble("to whom?", asks=True)
            person = WHOEVER_IS_THERE if passes or one.back else WHO_IS_MET
        only_for(one, person)
        bundles.append(given(one, person))
    return clause(parts, bundles)


def _whom(each: Iterable[Arranged]) -> str:
    """People, as they are called in a question to who speaks."""
    return " and ".join("you" if one.object.sort == "me" else spoken(one.object) for one in each)


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


def _let_have(parts: Parts) -> Clause:
    """Let Ana have the cup: she gets it, unless it is somewhere that she would have to go."""
    person = next((part for part in parts if isinstance(part, Nominal)), ME)
    each = arranged(parts)
    if person.sort == "person" and person.kind == "person" and not person.determined:
        raise unfit()  # "can somebody have the cup?"
    if any(one.goal is not None or one.back or one.person is not None for one in each):
        raise unfit()
    return clause((), [given(one, person) for one in each])


def _wants_robot(parts: Parts) -> Clause:
    """I need you in the workshop: what for is not said, and going there would be the least of it."""
    where = next((part for part in parts if isinstance(part, Where)), None)
    if where is None:
        raise trouble("shall this robot come to you?", asks=True, rivals=True)
    if where.role not in ("either", "to") or (where.of.sort == "thing" and where.relation is None):
        raise unfit()
    raise trouble(f"shall this robot go to {spoken(where.of)}?", asks=True, rivals=True)


def _want(parts: Parts) -> Clause:
    each = arranged(parts)
    for one in each:
        thing(one, "wanting")
        if one.goal is not None:
            raise unfit()
    raise trouble("shall it be brought to you?", asks=True)


def _wants_for(parts: Parts) -> Clause:
    """The guest would like the menu."""
    somebody = next(part for part in parts if isinstance(part, Nominal))
    if not _is_somebody(somebody):
        raise unfit()
    who = somebody.kind if somebody.sort == "name" else f"the {somebody.kind}"
    if any(one.object.sort == "you" for one in arranged(parts)):
        raise trouble(f"shall this robot go to {who}?", asks=True)
    with contextlib.suppress(TroubleError):
        _want(parts)
    raise trouble(f"shall it be brought to {who}?", asks=True)


def _is_somebody(of: Nominal) -> bool:
    """Whether it is one person who is named, and not whoever speaks."""
    return of.sort in ("person", "name") and of.is_single and not of.reference


_COMMANDS: Mapping[str, Callable[[Parts], Any]] = {
    "pick": _pick,
    "clear": _clear,
    "fetch": _fetch,
    "get_out": _get_out,
    "bring": _bring,
    "carry": _carry,
    "bring_it_me": _bring_it_me,
    "give_it_me": _give_it_me,
    "give": _give,
    "can_i_have": _can_i_have,
    "let_have": _let_have,
    "want": _want,
    "wants_robot": _wants_robot,
    "wants_for": _wants_for,
}

MEANINGS: Mapping[str, Meaning] = MappingProxyType(
    {name: guarded(meaning) for name, meaning in _COMMANDS.items()}
)
