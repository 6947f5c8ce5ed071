"""Finding, counting and describing."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from executive.language.commands import meanings, word_lists
from executive.language.commands.going import target
from executive.language.phrases.arranging import (
    TroubleError,
    arranged,
    clause,
    found_there,
    trouble,
    unfit,
)
from executive.language.phrases.features import SUPERLATIVES, described
from executive.language.phrases.looked_for import looked_for
from executive.language.phrases.parts import Parts, nominal_of, senses, words
from executive.language.phrases.values import (
    SEATS,
    Clause,
    Draft,
    Item,
    Items,
    Nominal,
    Where,
    draft,
    relation_kind,
    wears,
)
from executive.language.text.word import Word
from executive.vocabulary.inflection import plural


def _no_postures(parts: Parts, action: str) -> None:
    """Refuse to count people, or to look for somebody, by how they are in a room or on the floor.

    Raises:
        TroubleError: It is said; on a sofa they sit, and at a door they are, however it is.
    """
    items = [item for part in parts if isinstance(part, Items) for item in part.each if item.of.is_person]
    details = [*parts, *(detail for item in items for detail in item.details)]
    for one in details if items else ():
        if isinstance(one, Where) and one.posture and one.preposition != "at" and one.of.kind not in SEATS:
            told = f"to {action} people by how they are ({one.posture!r}) is no skill yet"
            raise trouble(told, one.posture)


def _asked(
    parts: Parts, action: str, source: Nominal | None = None, *, existing: bool = False
) -> list[Draft]:
    """What is asked about; ``existing`` is whether there is any such thing, be it one or several."""
    drafts: list[Draft] = []
    _no_postures(parts, action)
    for one in map(found_there, arranged(parts)):
        nominal = one.object
        if one.is_handled or (source is not None and one.source is not None):
            raise unfit()
        place = one.source or source
        if nominal.sort == "person" and place is not None and place.sort == "thing":
            raise TroubleError(wears(nominal, place))
        if nominal.sort == "you" or (nominal.sort == "me" and action != "find"):
            raise unfit()
        if nominal.reference == "this":
            raise trouble("which one is meant?", asks=True)
        if nominal.count == "many":
            raise trouble("whether there are many of them is not told; how many there are can be counted")
        if action == "find":
            if _is_nothing_named(nominal):
                raise trouble("which object is meant?", asks=True)
            drafts.append(looked_for(nominal, place, existing=existing))
            continue
        if nominal.is_vague:
            raise unfit()
        if nominal.counted and nominal.count != "all":
            raise trouble(f"how many to {action} cannot be chosen", str(nominal.count))
        several = nominal.plural and nominal.determined and not nominal.reference
        if several and action == "describe" and not _is_all_there(nominal):
            message = f"which one of the {plural(nominal.kind or 'thing')}? {action} is for one"
            raise trouble(message, asks=True, rivals=True)
        drafts.append(draft(action, object=replace(nominal, count=1), source=place))
    return drafts


def _is_nothing_named(nominal: Nominal) -> bool:
    """Whether a thing is told by nothing, so that it may be any."""
    return nominal.sort == "any" and nominal.kind is None and not nominal.reference and nominal.is_plain


def _there(drafts: list[Draft], parts: Parts, *classes: str) -> list[Draft]:
    """With a mark that it is asked what is "there", which may be the place that was named before."""
    there = "there" in senses(parts, *classes) or None
    return [one.with_slot("there_are", there) for one in drafts]


_QUESTIONS = (
    *("WHAT_IS", "SEE", "WHERE_IS", "IS_THERE", "IS_IT", "HOW_MANY", "COLOR_OF", "SUPERLATIVE_WHAT"),
)


def _alone(drafts: list[Draft], parts: Parts) -> Clause:
    """Each by itself, with a mark whether it begins as a question does."""
    asks = bool(words(parts[:1], *_QUESTIONS))
    return replace(clause(parts, [(one,) for one in drafts]), question=asks)


def _find(parts: Parts) -> Clause:
    if "show" in senses(parts, "TELL_ME") and words(parts, "WHERE"):
        raise unfit()  # which is to point at it
    items = [item for part in parts if isinstance(part, Items) for item in part.each]
    nameless = any(item.of.kind is None and not item.of.reference for item in items)
    if "identify" in senses(parts, "FIND") and nameless:
        raise unfit()  # "identify the object on the table": what is it?
    found = _asked(parts, "find", existing=bool(words(parts, "IS_THERE", "IF_THERE")))
    if words(parts, "IF_THERE"):
        return _alone([one.with_slot("there_are", "opened") for one in found], parts)
    return _alone(_there(found, parts, "IS_THERE", "LEFT_OVER"), parts)


def _find_for_me(parts: Parts) -> Clause:
    """Find me a pen: it is found; whether it is wanted too, is not said."""
    arranged(parts)
    raise trouble("shall it only be found, or be brought to you?", asks=True)


def _whether(parts: Parts) -> Clause:
    """Is the cup on the table? What is seen tells it, but of several not whether all of them are there."""
    details = tuple(part for part in parts if isinstance(part, Where))
    each = [Item(part, details) for part in parts if isinstance(part, Nominal)]
    items = [Items(tuple(each))] if each else [part for part in parts if isinstance(part, Items)]
    found = _find((*words(parts, "IS_IT", "LEFT_OVER"), *items))
    if any(one.get("count") is not None for bundle in found.bundles for one in bundle):
        raise trouble("which one of them? whether all are there is not told", asks=True)
    return found


def _search(parts: Parts) -> Clause:
    """Search the kitchen for the cup; look behind the sofa for the ball, one that is behind it."""
    place = target(next(part for part in parts if isinstance(part, Item)))
    items = next(part for part in parts if isinstance(part, Items))
    links = words(parts, "RELATION", "NEXT_TO")
    if not links:
        return _alone(_asked((items,), "find", place), parts)
    kind = relation_kind(links[0].meaning)
    if kind is None or any(item.details for item in items.each):
        raise unfit()
    beside = Where("is", place, None, kind)
    each = Items(tuple(replace(item, details=(beside,)) for item in items.each))
    return _alone(_asked((each,), "find"), parts)


def _count(parts: Parts) -> Clause:
    counted, collective = _asked(parts, "count"), word_lists()["collective"]
    for one in counted:
        nominal, source = one.get("object"), one.get("source")
        if words(parts, "HOW_MANY") and source is not None and source.reference == "there":
            raise unfit()  # "how many cups are there" may be asked of any place
        if nominal.reference:
            raise trouble("name what shall be counted", nominal.reference)
        if nominal.sort in ("me", "name") or not (
            nominal.plural or nominal.paired or nominal.kind in collective
        ):
            raise unfit()
    return _alone(_there(counted, parts, "THERE_ARE", "LEFT_OVER"), parts)


def _count_such(parts: Parts) -> Clause:
    """How many people in the kitchen are wearing red jackets?"""
    of = described(nominal_of(parts), parts)
    if not isinstance(of, Nominal):
        raise unfit() if of is None else TroubleError(of)
    details = tuple(part for part in parts if isinstance(part, Where))
    return _count((*words(parts, "TELL_ME", "HOW_MANY"), Items((Item(of, details),))))


def _describe_scene(parts: Parts) -> Clause:
    loose = tuple(_what_is_inside(part) for part in parts if not isinstance(part, Word))
    (one,) = arranged((Item(Nominal("any", plural=True), loose),))
    if one.is_handled:
        raise unfit()
    everything = one.object.relation is None or _is_before_the_robot(one.object)
    thing = None if everything else one.object
    return _alone([draft("describe", object=thing, source=one.source)], parts)


def _what_is_inside(part: Any) -> Any:
    """A place "inside" of what was named before, where something is, rather than goes."""
    inside = isinstance(part, Where) and part.of.reference == "it" and part.role == "to"
    return replace(part, role="is") if inside else part


def _describe(parts: Parts) -> Clause:
    described = []
    for one in _asked(parts, "describe"):
        nominal = one.get("object")
        if nominal.kind is not None and "identify" in senses(parts, "DESCRIBE"):
            raise unfit()  # which is to find it
        if nominal.is_person:
            told = "describing somebody is no skill of this robot yet: it tells the name, pose or gesture"
            raise trouble(told, nominal.kind)
        if _is_nothing_named(nominal) and one.get("source") is None:
            raise unfit()
        everything = _is_all_there(nominal) and not nominal.reference
        described.append(draft("describe", source=one.get("source")) if everything else one)
    return _alone(described, parts)


def _is_all_there(nominal: Nominal) -> bool:
    """Whether things are told by nothing, or by being in front of the robot, as all that it sees is."""
    if nominal.plural and _is_before_the_robot(nominal):
        nominal = replace(nominal, relation=None)
    return nominal.sort == "any" and nominal.kind is None and nominal.is_plain


def _is_before_the_robot(nominal: Nominal) -> bool:
    relation = nominal.relation
    return relation is not None and relation.kind == "in_front_of" and relation.to.sort == "you"


def _describe_superlative(parts: Parts) -> Clause:
    item = next((part for part in parts if isinstance(part, Item)), None)
    if item is None or (item.of.size not in SUPERLATIVES and not item.of.ordinal):
        raise unfit()
    return _describe(parts)


MEANINGS = meanings(
    {
        "find": _find,
        "find_for_me": _find_for_me,
        "whether": _whether,
        "search": _search,
        "count": _count,
        "count_such": _count_such,
        "describe_scene": _describe_scene,
        "describe": _describe,
        "describe_superlative": _describe_superlative,
    }
)
