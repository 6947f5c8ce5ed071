"""Going to places and people, waiting there, going home, stopping."""

from __future__ import annotations

import itertools
from dataclasses import replace

from executive.language.commands import meanings
from executive.language.commands.moving import bounded
from executive.language.phrases.arranging import ME, arranged, clause, trouble, unfit
from executive.language.phrases.lists import Joined, said_again, spoken
from executive.language.phrases.parts import Parts, senses, words
from executive.language.phrases.values import Clause, Item, Measure, Nominal, Relative, draft, relation_kind
from executive.language.resolve.kinds import listed

MAX_WAIT_S = 3600.0
"""A robot that waits stands; beyond it the number is taken for a mistake."""


def target(item: Item) -> Nominal:
    """Where an item says to go, point or look: a place or person with what tells it from others."""
    (one,) = arranged((item,), has_source=False)
    nominal = one.object
    pointed_out = one.goal is not None and one.goal.of.reference == "here" and not nominal.is_person
    if nominal.reference == "this" or pointed_out:
        raise trouble("which one is meant?", asks=True)  # "look at the cup here": where the speaker points
    if one.is_handled or nominal.sort == "you":
        raise unfit()
    if nominal.count != 1 or (nominal.plural and not nominal.reference):
        raise trouble("several at once: name one", nominal.kind)
    if nominal.sort == "any" and nominal.kind is None and not nominal.reference and nominal.is_plain:
        raise trouble("which one is meant?", asks=True)
    return nominal


def one_of_them(of: Nominal) -> Nominal:
    """A single piece of furniture as a place: "to the chairs" is to one of them."""
    several = of.sort == "furniture" and of.plural and of.determined and not of.counted
    return replace(of, plural=False) if several else of


def _toward(parts: Parts) -> Nominal:
    """Where to; an animal is not followed, and into something that is no room would be a collision."""
    to_it = not words(parts, "RELATION", "NEXT_TO", "APPROACH", "MEET")
    goal = target(replace(parts[-1], of=one_of_them(parts[-1].of)) if to_it else parts[-1])
    if goal.sort == "animal":
        raise trouble(f"walking after an animal ({goal.kind!r}) is no skill of this robot", goal.kind)
    links = words(parts, "TO_ALSO", "TO", "IN", "INTO")
    if links and goal.kind in listed("beds") and not goal.determined:
        raise trouble("to the bed? it is nothing for this robot to sleep in", goal.kind, asks=True)
    if "in" in senses(links, "TO_ALSO", "IN", "INTO") and goal.sort not in ("room", "any"):
        raise trouble(f"walking {links[0].said} {spoken(goal)} is no skill of this robot", links[0].said)
    return goal


def _toward_relation(parts: Parts) -> Relative:
    (link,) = words(parts, "RELATION")
    kind = relation_kind(link.meaning)
    if kind is None or kind == "under":
        raise trouble(f"walking {link.said} something is no skill of this robot", link.said)
    return Relative(kind, _toward(parts))


def _walk(parts: Parts) -> Clause:
    goals = [part for part in parts if isinstance(part, (Nominal, Relative))]
    for before, after in itertools.pairwise(one for one in goals if isinstance(one, Nominal)):
        again = said_again(before, after, parts)
        if again is not None:
            raise trouble(again.message, asks=True)
    *earlier, last = (draft("walk_to", to=goal) for goal in goals)
    if any(isinstance(part, Joined) and not part.then for part in parts):  # "there" may be each of them
        also = tuple(goal for goal in goals[:-1] if isinstance(goal, Nominal) and goal.is_place)
        last = last.with_slot("together", also or None)
    return clause(parts, [(one,) for one in (*earlier, last)])


def _approach(parts: Parts) -> Clause:
    goal = _toward(parts)
    if "reach" in senses(parts, "APPROACH") and not (goal.is_place and goal.is_plain):
        raise unfit()  # with a hand, or on foot?
    return clause(parts, [(draft("walk_to", to=goal),)])


def _come(parts: Parts) -> Clause:
    """To whoever speaks, perhaps to tell what was counted or found, which the references know."""
    return clause(parts, [(draft("walk_to", to=ME, tells=bool(words(parts, "COME_TO_TELL")) or None),)])


def _go_there(parts: Parts) -> Clause:
    back = "back" if "back" in senses(parts, "GO_BACK") else None
    return clause(parts, [(draft("walk_to", to=Nominal("any", reference="there", name=back)),)])


def _wait(parts: Parts) -> Clause:
    """To stand for a while; to walk to where that is, though the robot may have been sent there before."""
    measures = [part for part in parts if isinstance(part, Measure)]
    goals = [part for part in parts if isinstance(part, Nominal)]
    if goals and "linger" not in senses(parts, "WAIT"):
        raise unfit()  # nobody is to sleep in the kitchen
    if not measures:
        raise trouble("for how long?", asks=True)
    if measures[0].of != "duration":
        raise unfit()
    waits = draft("wait", duration_s=round(bounded(measures[0], MAX_WAIT_S), 3))
    return clause(parts, [*((draft("walk_to", to=goal),) for goal in goals), (waits,)])


def _waiting_at(parts: Parts) -> Nominal:
    goal = target(parts[-1])
    if not goal.is_place or (words(parts, "IN") and goal.sort != "room"):
        raise unfit()
    return goal


def _go_home(parts: Parts) -> Clause:
    return replace(clause(parts, [(draft("go_home"),)]), terse="home" in senses(parts, "GO_HOME"))


def _stop(parts: Parts) -> Clause:
    revokes = next((word.said for word in words(parts, "REVOKE")), None)
    return replace(clause(parts, [(draft("stop"),)]), revokes=revokes)


MEANINGS = meanings(
    {
        "toward": _toward,
        "toward_relation": _toward_relation,
        "walk": _walk,
        "approach": _approach,
        "come": _come,
        "go_there": _go_there,
        "wait": _wait,
        "waiting_at": _waiting_at,
        "go_home": _go_home,
        "stop": _stop,
        "revoke": _stop,
    }
)
