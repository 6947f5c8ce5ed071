"""Who "him", "her" and "them" are, and to whom something goes or is said when nobody is named.

Each function raises ``UnresolvedError`` with a question where it may be nobody, or one of several.
"""

from __future__ import annotations

from dataclasses import replace

from executive.language.phrases.values import SEATS, Nominal, Relative
from executive.language.resolve.antecedents import said_again
from executive.language.resolve.discourse import Discourse, ask, is_them
from executive.language.resolve.kinds import listed
from trees.tasks import RelationKind

_FACES = frozenset(
    {"walk_to", "find", "follow", "guide", "greet", "wave", "say", "look_at", "point_at", "answer", "tell"}
)
"""Tasks after which the robot is with somebody."""


def may_be(pronoun: str, person: Nominal) -> bool:
    """Whether a pronoun, as it was said, may stand for somebody; of whom nothing is known it may."""
    words, pronouns = (person.kind or "").lower().split(), listed("pronouns")
    fitting = [one for one in pronouns if not listed(one).isdisjoint(words)]
    return not fitting or pronoun not in pronouns or pronoun in fitting


def person_meant(told: Discourse, of: Nominal, *, anew: bool = False) -> Nominal:
    """Who is meant; ``anew`` where it is said where that is: "find the guest in the hall"."""
    if of.reference == "him" or is_them(of):
        named = list(dict.fromkeys(one.of for one in told.people))
        people = [one for one in named if may_be(of.said, one)] or named
        things = is_them(of) and any(not one.of.is_single for one in told.things)
        if len(people) != 1 or things or not may_be(of.said, people[0]) or people[0].count != 1:
            raise ask("who is meant?", [str(person.kind) for person in people])
        return replace(people[0], relation=None) if anew else people[0]
    if of.reference:
        raise ask("who is meant?")
    before = said_again(told, of) if of.sort == "person" and not anew else None
    return before if isinstance(before, Nominal) else of


def all_of_them(told: Discourse, of: Nominal) -> list[Nominal]:
    """All who were named, if "them" can be nobody else: in one breath, or two of whom it is "both".

    Who was named in words to say, or told by where he was found, is not among them.
    """
    people = list(dict.fromkeys(one.of for one in told.people))
    first = [next(one for one in told.people if one.of == person) for person in people]
    alone = all(one.of.is_single and one.role not in ("found", "quoted") for one in first)
    two = of.said in listed("two")
    together = len(people) == 2 if two else len({one.clause for one in first}) == 1
    return people if len(people) > 1 and alone and together else []


def where_found(told: Discourse, person: Nominal, place: Nominal) -> Discourse:
    """With somebody told by where he is found, if by nothing else: "a person in the kitchen", then "them"."""
    told_so = person.sort == "person" and person.count == 1 and person.relation is None
    if not told_so or place.reference or not place.is_place:
        return told.naming(person, "person")
    kind: RelationKind = "in" if place.sort == "room" else "on" if place.kind in SEATS else "next_to"
    found = replace(person, relation=Relative(kind, place))
    return replace(told, named=tuple(one for one in told.named if one.of != person)).naming(found, "found")


def met(told: Discourse) -> Nominal | None:
    """Whom the robot met by its last tasks, or None."""
    since = len(told.steps)
    while since and told.steps[since - 1].command.action in _FACES:
        since -= 1
    named = [one for one in told.people if one.role in ("walk", "person", "found")]
    people = dict.fromkeys(one.of for one in named if one.task >= since)
    if len(people) > 1 or any(one.count != 1 for one in people):
        raise ask("to whom?", ["me", *(str(one.kind) for one in people)])
    return next(iter(people), None)


def asker_or_met(told: Discourse, of: Nominal) -> Nominal:
    """Who gets a thing where nobody is said to: whom the robot walked to just before, else who speaks."""
    person = met(told) if of.name is not None else None
    named = dict.fromkeys(str(one.of.kind) for one in told.named if one.of.sort in ("person", "name"))
    last = told.walks[-1:]
    if person is not None and last and replace(last[0], relation=None) == replace(person, relation=None):
        return last[0]
    if named or (of.name == "met" and (told.last_action != "walk_to" or not last or last[0].sort != "me")):
        raise ask("to whom?", ["me", *named])
    return Nominal("me", of.kind)
