"""Finding, counting and describing."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from executive.language.commands import meanings
from executive.language.commands.going import target
from executive.language.phrases.arranging import arranged, checked, clause, found_there, trouble, unfit
from executive.language.phrases.features import SUPERLATIVES
from executive.language.phrases.handled_thing import looked_for
from executive.language.phrases.nominals import COLLECTIVE
from executive.language.phrases.parts import Parts, always, senses, words
from executive.language.phrases.values import (
    Clause,
    Draft,
    Item,
    Items,
    Nominal,
    Relative,
    Trouble,
    Where,
    draft,
    relation_kind,
)
from executive.language.text.word import Word


def _asked(
    parts: Parts, action: str, source: Nominal | None = None, *, existing: bool = False
) -> list[Draft]:
    """What is asked about; ``existing`` is whether there is any such thing, be it one or several."""
    drafts: list[Draft] = []
    for one in map(found_there, arranged(parts)):
        nominal = one.object
        if one.is_handled or (source is not None and one.source is not None):
            raise unfit()
        place = one.source or source
        if nominal.sort == "person" and place is not None and place.sort == "thing":
            checked(nominal.placed(Relative("in", place)))
        if nominal.sort == "you" or (nominal.sort == "me" and action != "find"):
            raise unfit()
        if nominal.reference == "this":
            raise trouble("which one is meant?", asks=True)
        if action == "find":
            if _is_nothing_named(nominal):
                raise trouble("which object is meant?", asks=True)
            drafts.append(looked_for(nominal, place, existing=existing))
            continue
        if nominal.is_vague or (nominal.counted and nominal.count != "all"):
            raise unfit()
        several = nominal.plural and nominal.determined and not nominal.reference
        if several and action == "describe" and not _is_all_there(nominal):
            raise trouble("which one of them shall be described?", asks=True, rivals=True)
        drafts.append(draft(action, object=replace(nominal, count=1), source=place))
    return drafts


def _is_nothing_named(nominal: Nominal) -> bool:
    """Whether a thing is told by nothing, so that it may be any."""
    return nominal.sort == "any" and nominal.kind is None and not nominal.reference and nominal.is_plain


_QUESTIONS = ("WHAT_IS", "SEE", "WHERE_IS", "IS_THERE", "IS_IT", "HOW_MANY", "COLOR_OF", "SUPERLATIVE_WHAT")


def _alone(drafts: list[Draft], parts: Parts, there: bool | tuple[str, ...] = False) -> Clause:
    """Each by itself, with a mark whether it begins as a question does."""
    asks = bool(words(parts[:1], *_QUESTIONS))
    each = [(one.with_slot("there_are", there or None),) for one in drafts]
    return replace(clause(parts, each), question=asks)


def _find(parts: Parts) -> Clause:
    found = _asked(parts, "find", existing=bool(words(parts, "IS_THERE", "IF_THERE")))
    return _alone(found, parts, ("object",) if words(parts, "IF_THERE") else _there(parts))


def _there(parts: Parts) -> bool:
    """Whether it is asked what is "there", which may be the place that was named before."""
    return "there" in senses(parts, "IS_THERE", "THERE_ARE", "LEFT_OVER")


def _whether(parts: Parts) -> Clause:
    """Is the cup on the table? What is seen tells it, but of several not whether all of them are there."""
    details = tuple(part for part in parts if isinstance(part, Where))
    each = [Item(part, details) for part in parts if isinstance(part, Nominal)]
    if any(item.of.sort == "name" and one.posture for item in each for one in details):
        raise unfit()  # "is Ana sitting in the kitchen?" asks for more than where she is
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
    counted = _asked(parts, "count")
    for one in counted:
        nominal, source = one.get("object"), one.get("source")
        if words(parts, "HOW_MANY") and source is not None and source.reference == "there":
            raise unfit()  # "how many cups are there" may be asked of any place
        if nominal.reference:
            raise trouble("name what shall be counted", nominal.reference)
        if nominal.sort in ("me", "name") or not (
            nominal.plural or nominal.paired or nominal.kind in COLLECTIVE
        ):
            raise unfit()
    return _alone(counted, parts, _there(parts))


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
    ranked = words(parts, "SUPERLATIVE_WHAT", "WHICH_ONE")
    for one in _asked(parts, "describe"):
        nominal = one.get("object")
        if ranked and nominal.size not in SUPERLATIVES and not nominal.ordinal:
            raise unfit()
        if nominal.is_person:
            told = "describing somebody is no skill of this robot yet: it tells the name, pose or gesture"
            raise trouble(told, nominal.kind)
        if _is_nothing_named(nominal) and one.get("source") is None:
            raise unfit()
        if nominal.sort == "room" and one.get("source") is None:
            described.append(draft("describe", source=nominal))
            continue
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


MEANINGS = meanings(
    {
        "find": _find,
        "find_for_me": always(Trouble("shall it only be found, or be brought to you?", asks=True)),
        "whether": _whether,
        "search": _search,
        "count": _count,
        "describe_scene": _describe_scene,
        "describe": _describe,
    }
)
