"""Who "him", "her" and "them" are, and to whom something goes or is said when nobody is named."""

from __future__ import annotations

from dataclasses import replace

from executive.language.phrases.values import SEATS, Nominal, Relative
from executive.language.resolve.antecedents import said_again
from executive.language.resolve.discourse import Discourse, ask, is_them
from executive.language.resolve.kinds import listed
from trees.tasks import RelationKind

_PRONOUNS = ("him", "her")
"""Lists of those of whom a pronoun is said."""

_MEETS = frozenset({"walk_to", "find", "follow", "guide", "greet"})
_ADDRESSES = frozenset({"wave", "say", "look_at", "point_at", "answer", "tell"})
"""What is done to somebody who stays in front of the robot."""


def may_be(pronoun: str, person: Nominal) -> bool:
    """Whether a pronoun, as it was said, may stand for somebody; of whom nothing is known it may."""
    words = (person.kind or "").lower().split()
    fitting = [one for one in _PRONOUNS if not listed(one).isdisjoint(words)]
    return not fitting or pronoun not in _PRONOUNS or pronoun in fitting


def person_meant(told: Discourse, of: Nominal, *, anew: bool = False) -> Nominal:
    """Who is meant; ``anew`` where it is said where that is: "find the guest in the hall".

    Raises:
        UnresolvedError: It may be one of several, or nobody.
    """
    if of.reference == "him" or is_them(of):
        named = list(dict.fromkeys(one.of for one in told.people))
        people = [one for one in named if may_be(of.said, one)] or named
        things = is_them(of) and any(not one.of.is_single for one in told.things)
        if len(people) != 1 or things or not may_be(of.said, people[0]) or people[0].count != 1:
            raise ask("who is meant?", [str(person.kind) for person in people])
        return replace(people[0], relation=None) if anew else people[0]
    if of.reference:
        raise ask("who is meant?")
    if anew or of.sort != "person":
        return of
    before = said_again(told, of)
    return before if isinstance(before, Nominal) else of


def all_of_them(told: Discourse, of: Nominal) -> tuple[Nominal, ...]:
    """All who were named, if "them" can be nobody else: in one breath, or two of whom it is "both".

    Who was named in words to say, or told by where he was found, is not among them. Whom "them" means alone is
    left to be asked or told.
    """
    people = dict.fromkeys(one.of for one in told.people)
    first = {one: next(each for each in told.people if each.of == one) for one in people}
    clauses = {one.clause for one in first.values()}
    named = len(people) > 1 and all(
        one.is_single and first[one].role not in ("found", "quoted") for one in people
    )
    two = of.said in listed("two")
    if named and (len(people) == 2 if two else len(clauses) == 1):
        return tuple(people)
    return () if two else (of,)


def where_found(told: Discourse, person: Nominal, place: Nominal) -> Discourse:
    """With somebody told by where he is found, if by nothing else: "a person in the kitchen", then "them"."""
    told_so = person.sort == "person" and person.count == 1 and person.relation is None
    if not told_so or place.reference or not place.is_place:
        return told.naming(person, "person")
    kind: RelationKind = "in" if place.sort == "room" else "on" if place.kind in SEATS else "next_to"
    found = replace(person, relation=Relative(kind, place))
    others = tuple(one for one in told.named if one.of != person)
    return replace(told, named=others).naming(found, "found")


def asker_or_met(told: Discourse, of: Nominal) -> Nominal:
    """Who gets a thing where nobody is said to: whom the robot walked to just before, else who speaks.

    Raises:
        UnresolvedError: Somebody else was named, who may be meant.
    """
    met = _walked_up_to(told) if of.name is not None else None
    if met is not None:
        return met
    if told.people:
        raise ask("to whom?", ["me", *dict.fromkeys(str(one.of.kind) for one in told.people)])
    if of.name == "met" and not (
        told.last_action == "walk_to" and told.walks and told.walks[-1].sort == "me"
    ):
        raise ask("to whom?")
    return Nominal("me", of.kind)


def _walked_up_to(told: Discourse) -> Nominal | None:
    """Whom the robot has gone to just before, when nobody else was named at all."""
    actions = [step.command.action for step in told.steps]
    while actions and actions[-1] in _ADDRESSES:
        actions.pop()
    if not actions or actions[-1] != "walk_to" or not told.walks:
        return None
    last = told.walks[-1]
    if last.relation is not None and last.relation.to.is_person and not last.is_person:
        raise ask("to whom?")  # "go to the chair next to Ana and hand over the cup"
    people = [replace(one.of, relation=None) for one in told.people]
    alone = len(set(people)) == 1 or len(actions) == len(told.steps)
    return last if people[-1:] == [replace(last, relation=None)] and alone else None


def spoken_to(told: Discourse) -> Nominal | None:
    """To whom something is said where nobody is said to hear it: who was met just before, else None.

    Raises:
        UnresolvedError: Several people were met one after the other.
    """
    since = len(told.steps)
    while since and told.steps[since - 1].command.action in (*_MEETS, *_ADDRESSES):
        since -= 1
    met = dict.fromkeys(
        one.of for one in told.people if one.task >= since and one.role in ("walk", "person", "found")
    )
    if len(met) > 1 or any(one.count != 1 for one in met):
        raise ask("to whom?", ["me", *(str(one.kind) for one in met)])
    return next(iter(met), None)
