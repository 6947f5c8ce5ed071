"""What is said of each thing, sorted out: where it is, where it goes, with which hand, for whom."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from typing import Any

from executive.language.phrases.parts import Parts
from executive.language.phrases.values import (
    Benefit,
    Bundle,
    Clause,
    Hand,
    Item,
    Items,
    Meaning,
    Nominal,
    Relative,
    Trouble,
    Where,
)
from executive.language.text.word import Word
from executive.vocabulary.inflection import plural

ME = Nominal("me", "me", determined=True)


class _UnfitError(Exception):
    """The parts do not go together in this way."""


class TroubleError(Exception):
    """They do, and it cannot be acted on."""

    def __init__(self, trouble: Trouble) -> None:
        self.trouble = trouble
        super().__init__(trouble.message)


@dataclass(frozen=True, slots=True)
class Arranged:
    """A thing with where it is told from others, where it is and goes, which hand takes it, and for whom."""

    object: Nominal
    source: Nominal | None = None
    goal: Where | None = None
    hand: str | None = None
    person: Nominal | None = None
    back: bool = False

    @property
    def is_for_another(self) -> bool:
        """Whether it is for somebody who is not the one who speaks."""
        return self.person is not None and self.person.sort != "me"

    @property
    def is_handled(self) -> bool:
        """Whether more is said than what and where it is: where it goes, with which hand, for whom else."""
        return self.goal is not None or self.back or self.hand is not None or self.is_for_another


def clause(parts: Parts, bundles: Iterable[Bundle]) -> Clause:
    """One command with the form of its verb: "base", "ing" or "ed"."""
    ends = (part.meaning.partition(":")[2] for part in parts if isinstance(part, Word))
    form: Any = next((end for end in ends if end in ("ing", "ed")), "base")
    return Clause(tuple(bundles), form)


def guarded(meaning: Callable[[Parts], Any]) -> Meaning:
    """Turn what goes wrong into None or trouble."""

    def run(parts: Parts) -> Any:
        try:
            return meaning(parts)
        except _UnfitError:
            return None
        except TroubleError as error:
            return error.trouble

    return run


def unfit() -> _UnfitError:
    """The parts do not go together."""
    return _UnfitError()


def trouble(
    message: str, word: str | None = None, *, asks: bool = False, rivals: bool = False
) -> TroubleError:
    """They do, and cannot be acted on."""
    return TroubleError(Trouble(message, word, asks, rivals=rivals))


def checked(value: Nominal | Trouble) -> Nominal:
    """The nominal, unless it is trouble."""
    if isinstance(value, Trouble):
        raise TroubleError(value)
    return value


def arranged(parts: Parts, *, goes: bool = False, has_source: bool = True) -> list[Arranged]:
    """Every item among the parts with its details sorted out.

    Args:
        parts: Of the command: items, and details that belong to the last of them.
        goes: Whether a bare place says where things go, instead of where they are.
        has_source: Whether the task has a slot for where things are; else it tells them apart.
    """
    named = [part for part in parts if isinstance(part, (Items, Item))]
    items = [item for part in named for item in (part.each if isinstance(part, Items) else (part,))]
    loose = tuple(part for part in parts if isinstance(part, (Where, Hand, Benefit)) or part == "back")
    items[-1] = replace(items[-1], details=(*items[-1].details, *loose))
    each = [_arrange(item, goes=goes, has_source=has_source) for item in items]
    for index in reversed(range(len(items) - 1)):  # what is said of a thing holds for those before it
        one, following = each[index], each[index + 1]
        if not items[index].details:
            each[index] = replace(following, object=one.object)
        elif one.goal is None and following.goal is not None:
            each[index] = replace(one, goal=following.goal)
    return each


def found_there(one: Arranged) -> Arranged:
    """Read "there" of a thing that is looked for or picked up as the place that was named."""
    if one.goal is not None and one.goal.of.reference == "there" and one.source is None:
        return replace(one, goal=None, source=one.goal.of)
    return one


def _arrange(item: Item, *, goes: bool, has_source: bool) -> Arranged:
    wheres = [detail for detail in item.details if isinstance(detail, Where)]
    result = Arranged(
        item.of,
        hand=_only([one.side for one in item.details if isinstance(one, Hand)]),
        person=_only([one.person for one in item.details if isinstance(one, Benefit)]),
        back="back" in item.details,
    )
    goals = [where for where in wheres if where.role == "to"]
    if len(goals) > 1:
        raise unfit()
    open_ones = [where for where in wheres if where.role == "either"] if goes and not goals else []
    if not goals and not open_ones:
        return _at(result, wheres, has_source=has_source)
    if goals and goals[0].of.reference == "there" and any(where.role == "either" for where in wheres):
        raise trouble("which place is meant, the one that is named or the one before?", asks=True)
    goal = goals[0] if goals else _goal(item.of, wheres, open_ones)
    if result.is_for_another and goal.of != result.person:
        raise trouble("for whom is it, or where shall it go?", asks=True)  # "hand the cup for Ana to Ben"
    index = wheres.index(goals[0] if goals else open_ones[0])
    before, after = wheres[:index], [where for where in wheres[index + 1 :] if where not in open_ones]
    for where in after:
        if where.role != "from":
            goal = _told(goal, where)
        elif goal.of.sort == "thing" and not goal.of.reference and where.of.kind:
            told = f"the {item.of.kind or 'thing'} or the {goal.of.kind}"
            raise trouble(f"which is from the {where.of.kind}, {told}?", asks=True)
        else:
            before.append(where)
    return _at(replace(result, goal=goal), before, has_source=has_source)


def _only(values: list[Any]) -> Any:
    distinct = list(dict.fromkeys(values))
    if len(distinct) > 1:
        first, second = (str(getattr(one, "kind", one)) for one in distinct[:2])
        raise trouble(f"{first!r} and {second!r} contradict each other", second)
    return distinct[0] if distinct else None


def _goal(thing: Nominal, wheres: list[Where], open_ones: list[Where]) -> Where:
    """Where it goes, among places that may as well be where it is.

    No place tells which thing is meant by "it", or what comes from somewhere; and things go into a bowl.
    """
    first = open_ones[0]
    if len(open_ones) == 1:
        return first
    second = open_ones[1]
    placed = bool(thing.reference) or any(where.role in ("is", "from") for where in wheres)
    into = first.preposition == "in" and first.of.sort in ("thing", "container")
    known = placed or (into and second.relation is not None)
    if len(open_ones) > 2 or not _tells(second, first, known=known):
        raise trouble("of these places, which is where it is, and which is where it goes?", asks=True)
    return _told(first, second)


def _tells(second: Where, first: Where, *, known: bool) -> bool:
    """Whether the second of two places can only tell the first: "next to the box on the shelf"."""
    of = first.of
    if second.preposition == "in" and second.of.sort == "room":
        return first.preposition is not None and of.is_place
    if not known or of.reference or second.of.reference or of.sort in ("me", "you", "name", "room", "any"):
        return False
    if second.relation is None:
        return second.preposition == "on" and second.of.is_place and not of.is_place
    among = second.of.sort in ("thing", "any") and not _is_spot(first, second)
    return first.relation is None and not (among and (of.sort == "container" or first.preposition == "on"))


def _told(goal: Where, where: Where) -> Where:
    """Where the thing goes, told by what is said after it: "to the man by the door".

    What else stands on a table tells where on it: "next to the plate".
    """
    of = goal.of
    if of.sort == "me" and where.of.is_place:
        raise trouble(f"are you at the {where.of.kind}, or shall it be put there?", asks=True)
    if of.reference or of.sort in ("me", "you") or (where.posture and of.sort == "person"):
        raise unfit()
    if where.relation is None and of.is_place and where.of.sort != "room":
        raise unfit()
    if _is_spot(goal, where):
        beside = checked(where.of.placed(Relative("on", of)))
        return replace(goal, of=beside, preposition=None, relation=where.relation)
    return replace(goal, of=checked(of.placed(where.told)))


def _is_spot(goal: Where, where: Where) -> bool:
    """Whether it says where on a piece of furniture something goes: next to another thing there."""
    beside = where.relation not in (None, "nearest") and where.of.sort in ("thing", "any")
    onto = goal.preposition == "on" and goal.relation is None and goal.of.sort == "furniture"
    return beside and onto and not where.of.reference and where.of.relation is None


def _at(result: Arranged, said: list[Where], *, has_source: bool) -> Arranged:
    """With where it is."""
    for where in said:
        is_trait = bool(where.posture) and result.object.sort == "person"
        somebody = where.of.sort in ("me", "name", "you") and where.relation is None and where.role != "from"
        if somebody or is_trait:
            raise unfit()
        if where.relation is not None:
            result = _beside(result, where)
        elif has_source:
            source = where.of if result.source is None else _inside(result.source, where)
            result = replace(result, source=source)
        elif where.role == "from":
            raise unfit()
        else:
            result = replace(result, object=checked(result.object.placed(where.told)))
    if result.object.reference and result.object.relation is not None:
        raise unfit()
    for place in (result.source, result.goal.of if result.goal else None):
        if place is not None and place.is_place and place.plural and not place.counted:
            raise trouble(f"which one of the {plural(str(place.kind))}?", asks=True)
    return result


def _beside(result: Arranged, where: Where) -> Arranged:
    """With what a thing is beside, or the place where it is: "the cup in the box next to the door"."""
    source, relation = result.source, where.told
    anything = result.object.kind is None and result.object.is_plain and not result.object.said
    if source is not None and (source.is_place or anything) and where.of.is_place:
        return replace(result, source=checked(source.placed(relation)))
    if source is not None and source.kind is not None and not source.is_place:
        beside = f"{relation.kind.replace('_', ' ')} the {where.of.kind or 'that'}"
        raise trouble(f"which is {beside}, the thing or the {source.kind} that it is in?", asks=True)
    return replace(result, object=checked(result.object.placed(relation)))


def _inside(source: Nominal, where: Where) -> Nominal:
    """A place that another one tells: "on the table in the kitchen", "in the bowl on the table"."""
    in_a_room = where.of.sort == "room" and source.sort != "room"
    if in_a_room or (source.sort == "thing" and where.of.is_place and where.preposition in ("on", "in")):
        return checked(source.placed(Relative("in", where.of) if in_a_room else where.told))
    told = f"two places are named: {str(source.kind)!r} and {str(where.of.kind)!r}"
    raise trouble(told, str(where.of.kind))
