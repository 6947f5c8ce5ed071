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
_SLOTS = frozenset(one.name for one in fields(ObjectDescription))
_TOLD = tuple(one.name for one in fields(Nominal) if one.name in _SLOTS)


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
    goals = told.as_named("goal", "again", "walk" if action == "pick" else "goal", sorts=THINGS)[-1:]
    if action in MOVES:  # "put the ball in the box and bring it to me"
        others += [goal for goal in goals if goal.clause >= one.clause and goal.of != one.of]
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
    taken = not told.mentioned and all(one.of.is_single and one.task in told.held for one in told.things)
    apart = len({one.clause for one in told.things}) == len({one.task for one in told.things})
    if taken and apart and action in PUTS_DOWN:  # "take the cup. Take the plate. Put them on the table"
        recent = list({one.task: one for one in told.things}.values())
    is_one = len(recent) == 1 and recent[0].of.is_single
    if not recent or is_one or any(one.of.sort == "animal" for one in recent):
        raise ask("what does 'them' stand for?")
    if of.said in listed("two") and [one.of.count for one in recent] not in ([1, 1], [2], ["both"]):
        raise ask("which two are meant?")
    return [one.task for one in recent]


def said_again(told: Discourse, of: Nominal) -> Nominal | ObjectOf | None:
    """What a noun is said of again, with less than before: "the drawer" after "the left drawer"."""
    pointed = of.whose in listed("pointing")
    if of.kind is None or not (pointed or may_be_said_again(of)):
        return None
    people = told.people if of.sort == "person" else ()
    named = [*told.things, *told.places, *told.mentioned, *people]
    before = named if pointed else [one for one in named if one.clause < told.clause or one.of.is_person]
    kinds = {one.of.sort for one in before}
    if not pointed and any(one.of == of for one in before):
        return None
    if of.kind in listed("door") and "container" in kinds:
        return None  # it may be that of the container
    held = told.held
    if pointed:
        found = [one for one in before if one.of.kind == of.kind]
    else:
        found = [
            one for one in before if says_more(one.of, of) or (one.task in held and _is_compound(one.of, of))
        ]
        found = [one for one in found if of.is_single or (one.role == "object" and not one.of.is_single)]
    in_the_hand = {one.task: one for one in found if one.role == "object" and one.task in held}
    if len(in_the_hand) == 1 and all(one.role == "object" for one in found) and not pointed:
        found = list(in_the_hand.values())
    meant = {one.of: ObjectOf(one.task) if one.role == "object" else one.of for one in reversed(found)}
    doubt = any(one.clause == told.clause or one.of.whose for one in found) if pointed else False
    if len(meant) > 1 or doubt or (of.is_single and any(not one.is_single for one in meant)):
        raise ask(f"which {of.kind} is meant?")
    return next(iter(meant.values()), None)


def may_be_said_again(of: Nominal) -> bool:
    """Whether it is "the cup", and neither "a cup", "my cup" nor "three cups"."""
    definite = of.determined or (of.is_single and not of.mass)
    plain = not (of.reference or of.anaphoric or of.indefinite or of.whose or of.counted)
    return plain and definite and of.ordinal != "other" and of.owner is None


def says_more(before: Nominal, of: Nominal) -> bool:
    """Whether what was named before is the same in more words: "the red cup"."""
    if before.kind is None or (of.kind is not None and before.kind != of.kind):
        return False
    said, less = told_of(before), told_of(of)
    if any(said.get(name) != value for name, value in less.items()):
        return False
    return len(said) > len(less) or (not before.is_single and before.count != "all")


def told_of(of: Nominal) -> dict[str, Any]:
    """What a noun tells of a thing, as the slots of its description."""
    told = {name: getattr(of, name) for name in _TOLD}
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
    left = told.actions(standing.get(near[0], 0) if near else 0) & LEAVES
    if not any(one.of.kind in doors for one in told.places) or (left and not near):
        return of
    doubt = "close" in told.actions() or (left and near[0] not in lately)
    if len(near) != 1 or doubt or any(one.of.kind in listed("door") for one in told.things):
        raise ask("which door?", [f"the door of the {one.kind}" for one in near])
    return ObjectOf(standing[near[0]]) if near[0] in standing else near[0]
