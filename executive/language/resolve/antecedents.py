"""Which thing "it", "the cup" and "the other one" stand for among those that were named."""

from __future__ import annotations

from dataclasses import replace

from executive.language.phrases.lists import another_of
from executive.language.phrases.values import Nominal, Trouble
from executive.language.resolve.discourse import (
    LEAVES,
    PUTS_DOWN,
    THINGS,
    Discourse,
    Named,
    UnresolvedError,
    ask,
)
from executive.language.resolve.kinds import listed
from trees.beliefs.grounding.articles import with_article
from trees.tasks import ObjectOf

Meant = Nominal | ObjectOf | None
"""What is meant: told by words, or what a task acts on; None where it was not named before."""

LOOKS = frozenset({"look_at", "point_at", "find", "describe"})
OPENS = frozenset({"open", "close"})
TOLD = ("kind", "color", "size", "material", "ordinal", "name", "relation")
_OPENED = frozenset({"container", "door"})


def it(told: Discourse, of: Nominal, action: str) -> Nominal | ObjectOf:
    """What "it" is that something is done to: one thing, never a person.

    Raises:
        UnresolvedError: It stands for nothing, or for one of several things.
    """
    if of.reference == "this":
        raise ask("which one is meant?")
    if action in OPENS:
        return _opened(told)
    recent = told.recent(THINGS)
    animals = [one.clause for one in told.things if one.of.sort == "animal"]
    if animals and any(max(animals) >= one.clause for one in recent):
        raise ask("which of them does 'it' stand for?")
    if not recent and action in LOOKS:
        recent = told.recent()
    if not recent or any(one.sort in THINGS for one in told.ahead):
        raise ask("what does 'it' stand for?")
    (one, *others) = recent
    put_to = told.put_to
    if put_to is not None and put_to.clause == one.clause and action in ("pick", *PUTS_DOWN):
        others.append(put_to)  # "put the ball in the box and bring it to me"
    if others or one.is_several or (action in PUTS_DOWN and told.held and one.task not in told.held):
        raise ask("which of them does 'it' stand for?", [f"the {each.of.kind}" for each in (one, *others)])
    return ObjectOf(one.task)


def _opened(told: Discourse) -> Nominal | ObjectOf:
    """What is opened or closed: a door that a task acts on, or the only one that was named."""
    recent = told.recent(_OPENED)
    acted = [one.of for one in recent]
    places = dict.fromkeys(one.of for one in told.places if one.of.sort in _OPENED)
    named = [place for place in places if place not in acted]
    if len(recent) == 1 and not named:
        return ObjectOf(recent[0].task)
    if not recent and not named:  # "walk in front of the fridge and open it"
        named = [one for one in told.beside if one.sort in _OPENED]
    if recent or len(named) != 1:
        raise ask("what does 'it' stand for?")
    return named[0]


def several(told: Discourse, of: Nominal, action: str) -> list[int]:
    """The tasks of the things that "them" stands for.

    Raises:
        UnresolvedError: It stands for none, or may be an animal.
    """
    recent = told.recent((*THINGS, "animal"))
    everything = {one.task: one for one in told.things if one.of.sort in THINGS}
    apart = len({one.clause for one in everything.values()}) == len(everything) and not told.mentioned
    if (
        apart
        and action in PUTS_DOWN
        and all(task in told.held and one.of.is_single for task, one in everything.items())
    ):
        recent = list(everything.values())  # "take the cup. Take the plate. Put them on the table"
    roots = [one.task for one in recent]
    if (
        not recent
        or any(one.of.sort == "animal" for one in recent)
        or (len(recent) == 1 and recent[0].of.is_single)
    ):
        raise ask("what does 'them' stand for?")
    counts = [one.of.count for one in recent]
    if of.said in listed("two") and counts not in ([1, 1], [2], ["both"]):
        raise ask("which two are meant?")
    return roots


def said_again(told: Discourse, of: Nominal) -> Meant:
    """What a noun is said of again, with less than before: "the drawer" after "the left drawer".

    Raises:
        UnresolvedError: It may be one of several.
    """
    pointed = of.whose in listed("pointing")
    if not (may_be_said_again(of) or (pointed and of.kind is not None and of.is_plain and not of.plural)):
        return None
    clause = told.clause + 1 if pointed or of.is_person else told.clause
    acted = [one for one in told.things if one.clause < clause]
    others = [one.of for one in (*told.places, *told.mentioned, *people_of(told, of)) if one.clause < clause]
    if not pointed and (of in others or any(one.of == of for one in acted)):
        return None
    if of.kind in listed("door") and any(
        one.sort == "container" for one in (*others, *(one.of for one in acted))
    ):
        return None
    held = told.held
    tasks = {
        one.task: one.of
        for one in acted
        if _says_more(one.of, of, pointed) or (one.task in held and _is_compound(one.of, of))
    }
    if not of.is_single:
        tasks = {task: one for task, one in tasks.items() if not one.is_single}
    others = [
        one
        for one in dict.fromkeys(others)
        if _says_more(one, of, pointed) and one.is_single and of.is_single and one not in tasks.values()
    ]
    if pointed and (
        any(one.of in tasks.values() and one.clause == told.clause for one in acted)
        or any(one.whose not in ("", of.whose) for one in (*tasks.values(), *others))
    ):
        raise ask(f"which {of.kind} is meant?")
    in_hand = [task for task in tasks if task in held and not pointed]
    if len(in_hand) == 1 and not others:
        tasks = {in_hand[0]: tasks[in_hand[0]]}
    if len(tasks) + len(others) > 1 or (of.is_single and any(not one.is_single for one in tasks.values())):
        raise ask(f"which {of.kind} is meant?")
    if others:
        return others[0]
    return ObjectOf(next(iter(tasks))) if tasks else None


def people_of(told: Discourse, of: Nominal) -> tuple[Named, ...]:
    """The people who were named, where the noun is one for people."""
    return told.people if of.sort == "person" else ()


def may_be_said_again(of: Nominal) -> bool:
    """Whether it is "the cup", and neither "a cup", "my cup" nor "three cups"."""
    definite = of.determined or (of.is_single and not of.mass)
    plain = not (of.reference or of.anaphoric or of.indefinite or of.whose or of.counted)
    return plain and definite and of.ordinal != "other" and of.owner is None


def says_more(before: Nominal, of: Nominal) -> bool:
    """Whether what was named before is the same in more words: "the red cup"."""
    return _says_more(before, of, False)


def _says_more(before: Nominal, of: Nominal, pointed: bool) -> bool:
    if before.kind is None or before.kind != of.kind:
        return False
    told = [name for name in TOLD if getattr(of, name) is not None]
    if any(getattr(before, name) != getattr(of, name) for name in told):
        return False
    more = any(getattr(before, name) is not None and getattr(of, name) is None for name in TOLD)
    return pointed or more or (not before.is_single and before.count != "all")


def _is_compound(before: Nominal, of: Nominal) -> bool:
    """Whether the word is the last one of what is in the hand: "cranberry juice", "juice"."""
    if before.sort != "thing" or before.kind == of.kind or of.kind is None or not of.is_plain:
        return False
    return any(said.endswith(f" {of.kind}") for said in (before.kind or "", before.said))


def in_hand(told: Discourse, of: Nominal, source: Nominal | None = None) -> ObjectOf | None:
    """What a task before picks up that is described in the very same words, or None.

    Raises:
        UnresolvedError: It may be one of several, or another that is not in the hand.
    """
    of = told.same_kind(of)
    fitting = {
        one.task
        for one in told.things
        if one.task in told.held
        and one.of == replace(of, anaphoric=one.of.anaphoric)
        and source in (None, told.source_of(one.task))
    }
    elsewhere = source is None and any(told.source_of(task) is not None for task in fitting)
    if len(fitting) > 1 or (fitting and elsewhere and of.indefinite):
        raise ask(f"which {of.kind or 'one'} is meant?")
    return ObjectOf(fitting.pop()) if fitting else None


def of_one_kind(told: Discourse, *named: Nominal) -> None:
    """Check that "the blue one" can be of no other kind than what is handled.

    Raises:
        UnresolvedError: It may: "pick up the cup, look at the box and take the red one".
    """
    handled = (told.kind,) if told.kind is not None else ()
    kinds = dict.fromkeys(one.kind for one in (*handled, *named) if one.kind)
    if len(kinds) > 1:
        raise ask("which one is meant?", [f"the {kind}" for kind in kinds])


def standing_open(told: Discourse) -> dict[Nominal, int]:
    """What was opened and not closed since, by the task that opened it."""
    found: dict[Nominal, int] = {}
    for index, step in enumerate(told.steps):
        of = next((one.of for one in told.things if one.task == step.root), None)
        if of is not None and step.command.action == "close":
            found.pop(of, None)
        elif of is not None and step.command.action == "open":
            found[of] = index
    return found


def door_of(told: Discourse, of: Nominal, action: str) -> Nominal | ObjectOf:
    """The container whose door "the door" is: that of the fridge after "put the milk in the fridge".

    Raises:
        UnresolvedError: It may be one of several.
    """
    if (
        of.kind not in listed("door")
        or not of.is_plain
        or not of.is_single
        or of.indefinite
        or of.whose
        or of.owner
    ):
        return of
    here = [one.of for one in told.places if one.clause == told.clause]
    before = [one.of for one in told.places if one.clause == told.clause - 1]
    if action == "open":
        walked = told.last_action == "walk_to" and before[-1:]
        return walked[0] if walked and walked[0].kind in listed("with_a_door") else of
    if here or any(one.sort == "door" for one in before):
        return of  # "close the fridge and the door"
    standing = {one: task for one, task in standing_open(told).items() if one.kind in listed("with_a_door")}
    beside = [one for one in before if one.kind in listed("with_a_door")]
    near = list(dict.fromkeys((*beside, *standing)))
    handled = {step.command.action for step in told.steps} & {"open", "close", *LEAVES}
    if not near and not handled and any(one.of.kind in listed("with_a_door") for one in told.places):
        raise ask("which door?")
    if not near:
        return of
    closed = "close" in told.actions_since(0) and not standing
    left = bool(standing) and not beside and told.actions_since(standing[near[0]]) & LEAVES
    if len(near) > 1 or closed or left or any(one.of.kind in listed("door") for one in told.things):
        raise ask("which door?", [f"the door of the {one.kind}" for one in near])
    return ObjectOf(standing[near[0]]) if near[0] in standing else near[0]


def other_door(told: Discourse, of: Nominal, action: str) -> Nominal:
    """What "the bottom one" is after "the top drawer" of a task before, if nothing else can be opened.

    Raises:
        UnresolvedError: Nothing was named that opens, or several sorts of it.
    """
    opened = [one.of for one in told.things if one.of.sort in _OPENED]
    named = [*opened, *(one.of for one in told.places if one.of.sort in _OPENED)]
    meant = another_of(of, opened[-1:])
    what = told.kind.kind if told.kind is not None and told.kind.kind else "thing"
    if meant.kind == what and all(one.kind == what for one in named):
        return meant
    if named or of.ordinal == "other":
        raise ask("which one is meant?")
    message = f"to {action} {with_article(what)} ({what!r}) is nothing that this robot can do"
    raise UnresolvedError(Trouble(message, what))
