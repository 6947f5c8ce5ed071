"""Finding, counting and describing."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from types import MappingProxyType
from typing import Any

from executive.language.commands.going import target
from executive.language.phrases.arranging import (
    TroubleError,
    arranged,
    clause,
    found_there,
    guarded,
    trouble,
    unfit,
)
from executive.language.phrases.features import SUPERLATIVES
from executive.language.phrases.handled_thing import looked_for
from executive.language.phrases.parts import Parts, words
from executive.language.phrases.values import (
    Bundle,
    Clause,
    Draft,
    Item,
    Items,
    Meaning,
    Nominal,
    Relative,
    Where,
    draft,
    relation_kind,
    wears,
)
from executive.language.text.word import Word
from executive.vocabulary.inflection import plural

_BESIDE = ("RELATION", "NEXT_TO")
_HERE = frozenset({"there", "room", "here"})
"""Words that may stand for the place that was named before, or for all that is in view."""


def _no_postures(parts: Parts, action: str) -> None:
    """Refuse to count people, or to look for somebody, by how they are in a room or on the floor.

    Raises:
        TroubleError: It is said; on a sofa they sit, and next to a door they are, however it is.
    """
    items = [item for part in parts if isinstance(part, Items) for item in part.each]
    items += [part for part in parts if isinstance(part, Item)]
    loose = [part for part in parts if isinstance(part, Where)]
    for item in items:
        for where in (*item.details, *(loose if item is items[-1] else ())):
            told = isinstance(where, Where) and where.posture and item.of.is_person
            if told and (where.of.sort == "room" or where.of.kind == "floor"):
                posture = where.posture
                raise trouble(f"to {action} people by how they are ({posture!r}) is no skill yet", posture)


def _asked(
    parts: Parts, action: str, source: Nominal | None = None, *, existing: bool = False
) -> list[Bundle]:
    """What is asked about; ``existing`` is whether there is any such thing, be it one or several."""
    bundles: list[Bundle] = []
    _no_postures(parts, action)
    for one in map(found_there, arranged(parts)):
        nominal = one.object
        if one.is_handled:
            raise unfit()
        if source is not None and one.source is not None:
            raise unfit()
        if nominal.sort == "person" and one.source is not None and one.source.sort == "thing":
            raise TroubleError(wears(nominal, one.source))
        whole = action == "describe" and _is_all_there(nominal)
        if nominal.sort in ("me", "you") and action != "find":
            raise unfit()
        if nominal.sort == "you" or nominal.reference == "this":
            raise unfit() if nominal.sort == "you" else trouble("which one is meant?", asks=True)
        if (
            nominal.sort == "any"
            and nominal.kind is None
            and not nominal.reference
            and nominal.is_plain
            and action == "find"
        ):
            raise trouble("which object is meant?", asks=True)
        if nominal.is_vague and action != "find":
            raise unfit()
        if nominal.count == "many":
            raise trouble("whether there are many of them is not told; how many there are can be counted")
        if action == "find":
            bundles.append((looked_for(nominal, one.source or source, existing=existing),))
            continue
        if nominal.counted and nominal.count != "all":
            raise trouble(f"how many to {action} cannot be chosen", str(nominal.count))
        several = nominal.plural and nominal.determined and not nominal.reference
        if several and action != "count" and not whole:
            message = f"which one of the {plural(nominal.kind or 'thing')}? {action} is for one"
            raise trouble(message, asks=True, rivals=True)
        bundles.append((draft(action, object=replace(nominal, count=1), source=one.source or source),))
    return bundles


def _identifies(parts: Parts, verb: str) -> bool:
    return any(word.said in ("identify", "identifying", "identified") for word in words(parts, verb))


def _find(parts: Parts) -> Clause:
    if words(parts, "WHERE") and any(word.said == "show me" for word in words(parts, "TELL_ME")):
        raise unfit()  # which is to point at it
    if _identifies(parts, "FIND") and any(
        item.of.kind is None and not item.of.reference
        for part in parts
        if isinstance(part, Items)
        for item in part.each
    ):
        raise unfit()  # "identify the object on the table": what is it?
    bundles = _asked(parts, "find", existing=bool(words(parts, "IS_THERE", "IF_THERE")))
    if any(_HERE & set(word.said.split()) for word in words(parts, "IS_THERE", "LEFT_OVER")):
        bundles = [(one.with_slot("there_are", True),) for (one,) in bundles]
    elif words(parts, "IF_THERE"):
        bundles = [(one.with_slot("there_are", "opened"),) for (one,) in bundles]
    return clause(parts, bundles)


def _find_for_me(parts: Parts) -> Clause:
    """Find me a pen: it is found; whether it is wanted too, is not said."""
    arranged(parts)
    raise trouble("shall it only be found, or be brought to you?", asks=True)


def _find_him(parts: Parts) -> Clause:
    """Tell me where she is: who was named before."""
    (said,) = words(parts, "WHERE_IS_HE")
    person = Nominal("person", reference="him", determined=True, said=said.meaning)
    return clause(parts, [(draft("find", person=person),)])


def _is_it(parts: Parts) -> Clause:
    item = parts[-1]
    if not item.details:
        raise unfit()
    return _whether_there(parts)


def _is_still(parts: Parts) -> Clause:
    """Is the cup still on the table? What is seen tells it, whatever was there before."""
    nominal, *details = (part for part in parts if not isinstance(part, Word))
    return _find((Items((Item(nominal, tuple(details)),)),))


def _whether_at(parts: Parts) -> Clause:
    """Check whether the cup is on the table."""
    nominal, where = (part for part in parts if not isinstance(part, Word))
    return _whether_there((Items((Item(nominal, (where,)),)),))


def _whether_there(parts: Parts) -> Clause:
    """Is the cup on the table? Of several it is not told whether all of them are."""
    found = _find(parts)
    if any(one.get("count") is not None for bundle in found.bundles for one in bundle):
        raise trouble("which one of them? whether all are there is not told", asks=True)
    return found


def _search(parts: Parts) -> Clause:
    place = next(part for part in parts if isinstance(part, Item))
    nominal = target(place)
    return clause(parts, _asked(tuple(part for part in parts if isinstance(part, Items)), "find", nominal))


def _search_beside(parts: Parts) -> Clause:
    """Look behind the sofa for the ball: a ball that is behind it."""
    of = next(part for part in parts if isinstance(part, Nominal))
    said = next(part for part in parts if isinstance(part, Word) and part.word_class in _BESIDE)
    kind = relation_kind(said.meaning)
    if kind is None:
        raise unfit()
    found = []
    for (one,) in _asked(tuple(part for part in parts if isinstance(part, Items)), "find"):
        thing = one.get("object")
        if thing is None or one.get("source") is not None or thing.relation is not None:
            raise unfit()
        found.append((one.replacing("object", replace(thing, relation=Relative(kind, of))),))
    return clause(parts, found)


def _count(parts: Parts) -> Clause:
    if any(mark.meaning != "," for mark in words(parts, "PAUSE")):
        raise unfit()
    bundles = _asked(parts, "count")
    for (one,) in bundles:
        nominal = one.get("object")
        source = one.get("source")
        if words(parts, "HOW_MANY") and source is not None and source.reference == "there":
            raise unfit()  # "how many cups are there" may be asked of any place
        if nominal.reference:
            raise trouble("name what shall be counted", nominal.reference)
        if not (nominal.plural or nominal.paired or nominal.kind in ("fruit", "food")):
            raise unfit()
        if nominal.sort in ("me", "name"):
            raise unfit()
    if any(_HERE & set(word.said.split()) for word in words(parts, "THERE_ARE", "LEFT_OVER")):
        bundles = [(one.with_slot("there_are", True),) for (one,) in bundles]
    return clause(parts, bundles)


def _what_is_inside(part: Any) -> Any:
    """A place "inside" of what was named before, where something is, rather than goes."""
    inside = isinstance(part, Where) and part.of.reference == "it" and part.role == "to"
    return replace(part, role="is") if inside else part


def _describe_scene(parts: Parts) -> Clause:
    nothing = Nominal("any", plural=True)
    loose = tuple(_what_is_inside(part) for part in parts if not isinstance(part, Word))
    (one,) = arranged((Item(nothing, loose),))
    if one.is_handled:
        raise unfit()
    everything = one.object.relation is None or _is_before_the_robot(one.object)
    thing = None if everything else one.object
    if not loose and words(parts, "WHAT_IS", "WHAT"):
        raise unfit()
    return clause(parts, [(draft("describe", object=thing, source=one.source),)])


def _describe(parts: Parts) -> Clause:
    bundles = _asked(parts, "describe")
    for (one,) in bundles:
        nominal = one.get("object")
        if nominal.kind is not None and _identifies(parts, "DESCRIBE"):
            raise unfit()  # which is to find it
        if nominal.is_person:
            told = "describing somebody is no skill of this robot yet: it describes things and what is there"
            raise trouble(told, nominal.kind)
        if (
            nominal.sort == "any"
            and nominal.kind is None
            and not nominal.reference
            and nominal.is_plain
            and one.get("source") is None
        ):
            raise unfit()
    return clause(parts, [(_everything(one),) for (one,) in bundles])


def _everything(one: Draft) -> Draft:
    """The objects on the table: all that is there."""
    nominal = one.get("object")
    if _is_all_there(nominal) and not nominal.reference:
        return draft("describe", source=one.get("source"))
    return one


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


_QUESTIONS = frozenset(
    {
        "WHAT_IS",
        "SEE",
        "WHERE_IS",
        "IS_THERE",
        "IS_IT",
        "HOW_MANY",
        "COLOR_OF",
        "SUPERLATIVE_WHAT",
    }
)


def _asking(meaning: Callable[[Parts], Clause]) -> Callable[[Parts], Clause]:
    """With a mark whether it begins as a question does."""

    def run(parts: Parts) -> Clause:
        first = parts[0]
        asks = isinstance(first, Word) and first.word_class in _QUESTIONS
        return replace(meaning(parts), question=asks)

    return run


_COMMANDS: Mapping[str, Callable[[Parts], Any]] = {
    "find": _asking(_find),
    "find_for_me": _find_for_me,
    "find_him": _find_him,
    "is_it": _asking(_is_it),
    "whether_here": _asking(_whether_there),
    "is_still": _asking(_is_still),
    "whether_at": _whether_at,
    "search": _search,
    "search_beside": _search_beside,
    "count": _asking(_count),
    "describe_scene": _asking(_describe_scene),
    "describe": _asking(_describe),
    "describe_superlative": _asking(_describe_superlative),
}

MEANINGS: Mapping[str, Meaning] = MappingProxyType(
    {name: guarded(meaning) for name, meaning in _COMMANDS.items()}
)
