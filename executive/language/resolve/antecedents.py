"""Which thing "it", "them", "the cup" and "the door" stand for among those that were named.

Each function raises ``UnresolvedError`` with a question where nothing fits, or several things do.
"""

from __future__ import annotations

from dataclasses import fields, replace
from typing import Any

from executive.language.phrases.values import Nominal
from executive.language.resolve.discourse import LEAVES, MOVES, PUTS_DOWN, THINGS, Discourse, ask
from executive.language.resolve.kinds import listed
from trees.tasks import ObjectDescription, ObjectOf

LOOKS = frozenset({"look_at", "point_at", "find", "describe"})
OPENS = frozenset({"open", "close"})
OPENED = frozenset({"container", "door"})
_TOLD = frozenset(one.name for one in fields(ObjectDescription))


def it(told: Discourse, of: Nominal, action: str) -> Nominal | ObjectOf:
    """What "it" is that something is done to: one thing, never a person."""
    if of.reference == "this":
        raise ask("which one is meant?")
    if action in OPENS:
        return _opened(told)
    recent = told.recent(THINGS)
    animals = [one.clause for one in told.things if one.of.sort == "animal"]
    if not recent and action in LOOKS:
        recent = told.recent()
    elif animals and any(max(animals) >= one.clause for one in recent):
        raise ask("which of them does 'it' stand for?")
    if not recent or any(one.sort in THINGS for one in told.ahead):
        raise ask("what does 'it' stand for?")
    (one, *others) = recent
    puts = [each for each in told.as_named("goal", "again") if each.of.sort in THINGS]
    if puts and puts[-1].clause == one.clause and action in MOVES:
        others.append(puts[-1])  # "put the ball in the box and bring it to me"
    if others or one.is_several or (action in PUTS_DOWN and told.held and one.task not in told.held):
        raise ask("which of them does 'it' stand for?", [f"the {each.of.kind}" for each in (one, *others)])
    return ObjectOf(one.task)


def _opened(told: Discourse) -> Nominal | ObjectOf:
    """What is opened or closed: a door that a task acts on, or the only one that was named."""
    recent = told.recent(OPENED)
    acted = [one.of for one in recent]
    named = [one.of for one in told.places if one.of.sort in OPENED and one.of not in acted]
    if not recent and not named:  # "walk in front of the fridge and open it"
        named = [one.of for one in told.as_named("beside") if one.of.sort in OPENED]
    acted_on = [ObjectOf(one.task) for one in recent]
    meant: list[Nominal | ObjectOf] = [*acted_on, *dict.fromkeys(named)]
    if len(meant) != 1:
        raise ask("what does 'it' stand for?")
    return meant[0]


def several(told: Discourse, of: Nominal, action: str) -> list[int]:
    """The tasks of the things that "them" stands for."""
    recent = told.recent((*THINGS, "animal"))
    singles = {one.task: one for one in told.things if one.of.sort in THINGS and one.of.is_single}
    apart = len({one.clause for one in singles.values()}) == len(told.held) and not told.mentioned
    if (
        action in PUTS_DOWN
        and apart
        and set(singles) == set(told.held)
        and all(one.of.is_single for one in recent)
    ):
        recent = list(singles.values())  # "take the cup. Take the plate. Put them on the table"
    is_one = len(recent) == 1 and recent[0].of.is_single
    if not recent or is_one or any(one.of.sort == "animal" for one in recent):
        raise ask("what does 'them' stand for?")
    if of.said in listed("two") and [one.of.count for one in recent] not in ([1, 1], [2], ["both"]):
        raise ask("which two are meant?")
    return [one.task for one in recent]


def said_again(told: Discourse, of: Nominal) -> Nominal | ObjectOf | None:
    """What a noun is said of again, with less than before: "the drawer" after "the left drawer"."""
    if of.whose in listed("pointing"):
        same = {one.of: one for one in told.named if one.of.kind == of.kind}
        if len(same) > 1 or any(
            one.clause == told.clause or one.is_several or one.of.whose for one in same.values()
        ):
            raise ask(f"which {of.kind} is meant by {of.whose!r}?")
        return next((ObjectOf(one.task) if one.role == "object" else one.of for one in same.values()), None)
    if of.kind is None or not may_be_said_again(of):
        return None
    before = [one for one in told.named if one.clause < told.clause]
    acted = [one for one in (told.things if of.is_person else before) if one.role == "object"]
    people = told.people if of.sort == "person" else ()
    others = [one.of for one in (*told.places, *told.mentioned) if one in before] + [one.of for one in people]
    named = [*others, *(one.of for one in acted)]
    if of in named or (of.kind in listed("door") and any(one.sort == "container" for one in named)):
        return None
    held = told.held
    tasks = {
        one.task: one.of
        for one in acted
        if says_more(one.of, of) or (one.task in held and _is_compound(one.of, of))
    }
    tasks = {task: one for task, one in tasks.items() if of.is_single or not one.is_single}
    others = [
        one
        for one in dict.fromkeys(others)
        if says_more(one, of) and one.is_single and one not in tasks.values()
    ]
    others = others if of.is_single else []
    in_the_hand = [task for task in tasks if task in held]
    if len(in_the_hand) == 1 and not others:
        tasks = {in_the_hand[0]: tasks[in_the_hand[0]]}
    if len(tasks) + len(others) > 1 or (of.is_single and any(not one.is_single for one in tasks.values())):
        raise ask(f"which {of.kind} is meant?")
    return others[0] if others else ObjectOf(next(iter(tasks))) if tasks else None


def may_be_said_again(of: Nominal) -> bool:
    """Whether it is "the cup", and neither "a cup", "my cup" nor "three cups"."""
    definite = of.determined or (of.is_single and not of.mass)
    plain = not (of.reference or of.anaphoric or of.indefinite or of.whose or of.counted)
    return plain and definite and of.ordinal != "other" and of.owner is None


def says_more(before: Nominal, of: Nominal) -> bool:
    """Whether what was named before is the same in more words: "the red cup"."""
    said, less = told_of(before), told_of(of)
    if "kind" not in said or any(said.get(name) != value for name, value in less.items()):
        return False
    return len(said) > len(less) or (not before.is_single and before.count != "all")


def told_of(of: Nominal) -> dict[str, Any]:
    """What a noun tells of a thing, as the slots of its description."""
    told = {one.name: getattr(of, one.name) for one in fields(of) if one.name in _TOLD}
    return {name: value for name, value in told.items() if value not in (None, ())}


def _is_compound(before: Nominal, of: Nominal) -> bool:
    """Whether the word is the last one of what is in the hand: "cranberry juice", "juice"."""
    if before.sort != "thing" or before.kind == of.kind or not of.is_plain:
        return False
    return any(said.endswith(f" {of.kind}") for said in (before.kind or "", before.said))


def in_hand(told: Discourse, of: Nominal, source: Nominal | None = None) -> ObjectOf | None:
    """What a task before picks up that is described in the very same words, or None."""
    of = told.same_kind(of)
    fitting = {
        one.task
        for one in told.things
        if one.task in told.held
        and one.of == replace(of, anaphoric=one.of.anaphoric)
        and source in (None, told.source_of(one.task))
    }
    elsewhere = source is None and of.indefinite and any(told.source_of(task) for task in fitting)
    if len(fitting) > 1 or elsewhere:
        raise ask(f"which {of.kind or 'one'} is meant?")
    return ObjectOf(fitting.pop()) if fitting else None


def of_one_kind(told: Discourse, *named: Nominal) -> None:
    """Ask where "the blue one" may be of another kind than what is handled."""
    kinds = dict.fromkeys(one.kind for one in (told.kind, *named) if one is not None and one.kind)
    if len(kinds) > 1:
        raise ask("which one is meant?", [f"the {kind}" for kind in kinds])


def door_of(told: Discourse, of: Nominal, action: str) -> Nominal | ObjectOf:
    """The container whose door "the door" is: that of the fridge after "put the milk in the fridge"."""
    plain = of.is_plain and of.is_single and not (of.indefinite or of.whose or of.owner or of.anaphoric)
    if of.kind not in listed("door") or not plain:
        return of
    lately = [one.of for one in told.places if one.clause == told.clause - 1]
    doors = listed("with_a_door")
    if action == "open":
        reached = told.last_action == "walk_to" and lately and lately[-1].kind in doors
        return lately[-1] if reached else of
    here = any(one.clause == told.clause for one in told.places)
    if here or any(one.sort == "door" for one in lately):
        return of  # "close the fridge and the door"
    standing = {one: task for one, task in told.standing_open().items() if one.kind in doors}
    near = list(dict.fromkeys((*(one for one in lately if one.kind in doors), *standing)))
    moved = told.actions() & {*OPENS, *LEAVES}
    if not near and (moved or not any(one.of.kind in doors for one in told.places)):
        return of
    closed = "close" in moved and not standing
    left = bool(near) and near[0] not in lately and told.actions(standing.get(near[0], 0)) & LEAVES
    if len(near) != 1 or closed or left or any(one.of.kind in listed("door") for one in told.things):
        raise ask("which door?", [f"the door of the {one.kind}" for one in near])
    return ObjectOf(standing[near[0]]) if near[0] in standing else near[0]
