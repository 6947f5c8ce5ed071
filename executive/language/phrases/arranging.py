"""What is said of each thing, sorted out: where it is, where it goes, with which hand, for whom."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
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
from trees.tasks import RelationKind

_PLACES: Mapping[str, RelationKind] = {"on": "on", "in": "in"}
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
    """A thing, and what is to become of it.

    Attributes:
        object: The thing, with where it is told from others.
        source: Where it is.
        goal: Where it goes.
        hand: Which hand.
        person: For whom.
        back: Whether it goes back.
    """

    object: Nominal
    source: Nominal | None = None
    goal: Where | None = None
    hand: str | None = None
    person: Nominal | None = None
    back: bool = False
    for_company: bool = False
    """Whether it is for people of whom none is told from others: "on the table for our guests"."""

    @property
    def is_for_another(self) -> bool:
        """Whether it is for somebody who is not the one who speaks."""
        return self.person is not None and self.person.sort != "me"

    @property
    def is_handled(self) -> bool:
        """Whether more is said than what and where it is: where it goes, with which hand, for whom else."""
        return self.goal is not None or self.back or self.hand is not None or self.is_for_another


def form_of(parts: Iterable[Any]) -> Any:
    """The form of the verb among the parts: "base", "ing" or "ed"."""
    for part in parts:
        if isinstance(part, Word):
            _, _, form = part.meaning.partition(":")
            if form in ("ing", "ed"):
                return form
    return "base"


def clause(parts: Parts, bundles: Iterable[Bundle]) -> Clause:
    """One command with the form of its verb."""
    return Clause(tuple(bundles), form_of(parts))


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
    items = [
        item
        for part in parts
        for item in (part.each if isinstance(part, Items) else (part,) if isinstance(part, Item) else ())
    ]
    loose = tuple(part for part in parts if isinstance(part, (Where, Hand, Benefit)) or part == "back")
    if not items:
        raise unfit()
    items[-1] = replace(items[-1], details=(*items[-1].details, *loose))
    each = [_arrange(item, goes=goes, has_source=has_source) for item in items]
    for index in reversed(range(len(items) - 1)):  # what is said of a thing holds for those before it
        one, following = each[index], each[index + 1]
        if not items[index].details:
            each[index] = replace(following, object=one.object)
        elif one.goal is None and following.goal is not None:
            each[index] = replace(one, goal=following.goal)
    for index in range(1, len(items)):
        before = each[index - 1]
        if items[index].too and each[index].goal is None and each[index].source is not None:
            each[index] = replace(each[index], goal=before.goal)  # "... and the plate from the shelf too"
        if items[index].too and not items[index].details:
            each[index] = replace(
                each[index], goal=before.goal, source=before.source if before.goal else None
            )
    return each


def found_there(one: Arranged) -> Arranged:
    """Read "there" of a thing that is looked for or picked up as the place that was named."""
    if one.goal is not None and one.goal.of.reference == "there" and one.source is None:
        return replace(one, goal=None, source=one.goal.of)
    return one


def _arrange(item: Item, *, goes: bool, has_source: bool) -> Arranged:
    result = Arranged(item.of)
    wheres = [detail for detail in item.details if isinstance(detail, Where)]
    result = replace(result, hand=_only([one.side for one in item.details if isinstance(one, Hand)]))
    people = [one.person for one in item.details if isinstance(one, Benefit)]
    result = replace(result, person=_only(people), back="back" in item.details)
    result = replace(result, for_company=bool(item.details) and _is_for_company(item.details[-1]))
    if not has_source and not goes:
        wheres = [_is_there(where) for where in wheres]
    goals = [where for where in wheres if where.role == "to"]
    if len(goals) > 1:
        raise unfit()
    open_ones = [where for where in wheres if where.role == "either"] if goes and not goals else []
    if not goals and not open_ones:
        return _at(result, wheres, has_source=has_source)
    if goals and goals[0].of.reference == "there" and any(where.role == "either" for where in wheres):
        raise trouble("which place is meant, the one that is named or the one before?", asks=True)
    goal = goals[0] if goals else _goal(item.of, wheres, open_ones)
    index = wheres.index(goals[0] if goals else open_ones[0])
    before, after = wheres[:index], [where for where in wheres[index + 1 :] if where not in open_ones]
    for where in after:
        if where.role == "from":
            _doubt_whose_source(item.of, goal.of, where)
            before.append(where)
        else:
            goal = _told(goal, where)
    return replace(_at(result, before, has_source=has_source), goal=goal)


def _is_for_company(detail: Any) -> bool:
    """Whether it says last for whom, and those are people of whom none is told from others."""
    if not isinstance(detail, Benefit):
        return False
    whom = detail.person
    unspecific = whom.sort == "person" and whom.determined and not whom.counted
    return unspecific and whom.plural and whom.relation is None and whom.is_plain


def _doubt_whose_source(thing: Nominal, goal: Nominal, where: Where) -> None:
    """Ask which of two comes from somewhere: "put the apple in the bowl from the fridge".

    Raises:
        TroubleError: It may be either.
    """
    if goal.sort == "thing" and goal.reference is None and where.of.kind is not None:
        named = f"the {thing.kind or 'thing'} or the {goal.kind}"
        raise trouble(f"which is from the {where.of.kind}, {named}?", asks=True)


def _is_there(where: Where) -> Where:
    """Read "there" of what goes nowhere as where it is: "open the cabinet there"."""
    there = where.of.reference == "there" and where.of.name != "back" and where.role == "to"
    return replace(where, role="is", preposition="in") if there else where


def _only(values: list[Any]) -> Any:
    distinct = list(dict.fromkeys(values))
    if len(distinct) > 1:
        first, second = (getattr(one, "kind", one) for one in distinct[:2])
        raise trouble(f"{first!r} and {second!r} contradict each other", str(second))
    return distinct[0] if distinct else None


def _goal(thing: Nominal, wheres: list[Where], open_ones: list[Where]) -> Where:
    """Where it goes, among places that may as well be where it is.

    Raises:
        TroubleError: Either may be where it goes.
    """
    first, *others = open_ones
    if not others:
        return first
    if len(others) == 1 and first.preposition and first.of.is_place and _is_in_a_room(others[0]):
        return replace(first, of=checked(first.of.placed(Relative("in", others[0].of))))
    if len(others) == 1 and (_is_placed(thing, wheres) or _goes_first(first, others[0])):
        told = _told_by_place(first, others[0])
        if told is not None:
            return told
    raise trouble("of these places, which is where it is, and which is where it goes?", asks=True)


def _is_in_a_room(where: Where) -> bool:
    return where.preposition == "in" and where.of.sort == "room"


def _is_placed(thing: Nominal, wheres: list[Where]) -> bool:
    """Whether no place can tell which thing is meant: "it", and "the cup from the sink"."""
    return bool(thing.reference) or any(where.role in ("is", "from") for where in wheres)


def _goes_first(first: Where, second: Where) -> bool:
    """Whether what is put goes to the first of two places, and the second one tells which that is.

    It does "in the bowl next to the stove", and "on the tray in front of me"; "on the table next to the
    sofa" the thing may be as well that is to be put next to the sofa.
    """
    into = first.preposition == "in" and first.of.sort in ("thing", "container")
    ahead = second.relation == "in_front_of" and second.of.sort in ("me", "you")
    return second.relation is not None and (into or (first.preposition == "on" and ahead))


def _told_by_place(first: Where, second: Where) -> Where | None:
    """The first of two places, told by the second one: "next to the box on the shelf"; None if it is not."""
    of = first.of
    if of.reference or second.of.reference or of.sort in ("me", "you", "name", "room", "any"):
        return None
    if second.relation is None and (of.is_place or second.preposition != "on" or not second.of.is_place):
        return None
    if first.relation is not None and second.relation is not None:
        return None
    if second.of.sort in ("thing", "any") and second.relation is not None and not _is_spot(first, second):
        if of.sort == "container":
            return None  # "in the sink next to the plate"
        if first.preposition == "on":
            beside = f"the {of.kind} {second.relation.replace('_', ' ')} the {second.of.kind or 'other'}"
            raise trouble(f"is {beside}, or shall it be put there on the {of.kind}?", asks=True)
    return _told(first, second)


def _told(goal: Where, where: Where) -> Where:
    """What is said after where the thing goes tells where that is: "to the man standing by the door".

    What else stands on a table tells of no table which one it is, but where on it: "next to the plate".
    """
    of = goal.of
    if of.sort == "me" and where.of.is_place:
        raise trouble(f"are you at the {where.of.kind}, or shall it be put there?", asks=True)
    if of.reference or of.sort in ("me", "you"):
        raise unfit()
    if where.relation is None and of.is_place and where.of.sort != "room":
        raise unfit()
    if _is_spot(goal, where):
        beside = checked(where.of.placed(Relative("on", of)))
        return replace(goal, of=beside, preposition=None, relation=where.relation)
    return replace(goal, of=checked(of.placed(Relative(_kind(where), where.of))))


def _is_spot(goal: Where, where: Where) -> bool:
    """Whether it says where on a piece of furniture something goes: next to another thing there."""
    beside = where.relation not in (None, "nearest") and where.of.sort in ("thing", "any")
    onto = goal.preposition == "on" and goal.relation is None and goal.of.sort == "furniture"
    return beside and onto and not where.of.reference and where.of.relation is None


def _kind(where: Where) -> RelationKind:
    """A place as a relation."""
    return where.relation or _PLACES.get(where.preposition or "", "next_to")


def _at(result: Arranged, said: list[Where], *, has_source: bool) -> Arranged:
    said = _nested(said)
    for where in said:
        if where.left_by is not None:
            result = replace(result, object=replace(result.object, owner=where.left_by))
        if (
            where.of.sort in ("me", "name", "you")
            and where.preposition in ("on", "in", "at")
            and where.role != "from"
        ):
            raise unfit()
        source = result.source
        told_by_place = source is not None and (source.is_place or _is_anything(result.object))
        if where.relation is not None and where.of.is_place and source is not None and told_by_place:
            result = replace(result, source=checked(source.placed(Relative(where.relation, where.of))))
        elif where.relation is not None:
            _doubt_what_is_beside(result, where)
            result = replace(result, object=checked(result.object.placed(Relative(where.relation, where.of))))
        elif not has_source:
            if where.role == "from":
                raise unfit()
            result = _told_apart(result, _kind(where), where.of)
        elif result.source is None:
            result = replace(result, source=where.of)
        elif (where.of.sort == "room" and result.source.sort != "room") or (
            result.source.sort == "thing" and where.of.is_place and where.preposition in ("on", "in")
        ):
            inner = Relative("in" if where.of.sort == "room" else _kind(where), where.of)
            result = replace(result, source=checked(result.source.placed(inner)))
        elif result.source != where.of:
            names = [str(one.kind) for one in (result.source, where.of) if one]
            raise trouble(f"two places are named: {names[0]!r} and {names[1]!r}", names[1])
    if result.object.reference and result.object.relation is not None:
        raise unfit()
    return result


def _is_anything(of: Nominal) -> bool:
    """Whether it is whatever there is: "what is in the box"."""
    return of.kind is None and of.is_plain and not (of.anaphoric or of.reference or of.said)


def _doubt_what_is_beside(result: Arranged, where: Where) -> None:
    """Ask which of two is beside something: "the cup in the box next to the door".

    Raises:
        TroubleError: It may be either.
    """
    place = result.source
    if place is not None and place.kind is not None and not place.is_place and where.relation is not None:
        beside = f"{where.relation.replace('_', ' ')} the {where.of.kind or 'that'}"
        thing = "what is there" if _is_anything(result.object) else f"the {result.object.kind or 'one'}"
        raise trouble(f"which is {beside}, {thing} or the {place.kind}?", asks=True)


def _nested(said: list[Where]) -> list[Where]:
    """With what a relative clause goes on with told of its end: "that is next to the can behind the box"."""
    match said:
        case [Where(role="is", relation=str()) as clause, Where(role="either", relation=str()) as end]:
            if clause.of.sort in ("thing", "any") and not clause.of.reference and clause.of.relation is None:
                return [replace(clause, of=checked(clause.of.placed(Relative(_kind(end), end.of))))]
    return said


def _told_apart(result: Arranged, kind: RelationKind, of: Nominal) -> Arranged:
    relation = result.object.relation
    if relation is not None and of.sort == "room" and relation.to.is_place:
        inner = checked(relation.to.placed(Relative(kind, of)))
        return replace(result, object=replace(result.object, relation=Relative(relation.kind, inner)))
    return replace(result, object=checked(result.object.placed(Relative(kind, of))))
