"""What has to be done before a command of an errand, that nobody said: to walk, to open, to see who speaks.

"Bring me the bottle from the fridge" means a pick and a hand-over. Between them and before them a robot that
can walk goes to the fridge, opens it, comes within reach of the bottle, and walks back to who spoke; each of
these is a task of its own, so that what fails is told as what it is. Where the map has rooms, what is spoken
of may be anywhere in them: it is walked to as well when it is not at hand, and what is to be brought
somewhere is picked up before the robot walks there. What is asked about a table is seen from before it. What
is taken to a room and then put somewhere is only carried to the room.
"""

from __future__ import annotations

import itertools
from collections.abc import Container, Iterator, Sequence
from dataclasses import replace

from executive.errands.nearness import Nearness
from executive.errands.opened_first import (
    behind_of,
    door_for,
    inside_of,
    open_it,
    opening,
    put_down,
    shut_drawer,
)
from executive.errands.prepared import NOTHING_KNOWN, Known, Prepared
from executive.errands.required import (
    brings_about,
    goal,
    goes_away,
    handles,
    puts_in,
    puts_on,
    requires,
    strays,
    takes,
    walk,
    whom,
)
from executive.meaning import Command
from robots.scenes.articulated import DRAWER
from robots.scenes.furniture import FURNITURE_KINDS
from robots.scenes.furniture_names import kind_called
from trees.beliefs.openings.handles import BODY_OF, MEANT_BY
from trees.registry import task_that
from trees.skill import After, Before
from trees.tasks import WHERE_IT_WAS, Destination, ObjectDescription, ObjectOf, Relation

SPEAKER, IN_FRONT = "me", "in_front"
_SEE_WHO = {SPEAKER: "see who speaks", IN_FRONT: "see who is in front"}
"""Whom words mean that others would be meant by once the robot has gone away."""


def prepared(
    commands: Sequence[Command], can_walk: bool, known: Known = NOTHING_KNOWN
) -> tuple[Prepared, ...]:
    """The commands with what has to be done before them.

    Nothing is added for a robot that stands where it stands. Without rooms everything is taken to be at
    hand: only what has a door, and is taken from or put into, makes it walk, and furniture that it does not
    stand before, when it is to put there what it holds. From then on it has left the place where it was,
    and goes to whom or to where it is told to bring things. With rooms it does so from the start, and so it
    does after it was told to turn around or to go somewhere, and once something was not to be seen from
    where it stands (``looked_for``). A door or drawer into which something goes is opened first, with empty
    hands: what is held is put down.

    Args:
        commands: What was said, in order.
        can_walk: Whether the robot walks.
        known: What is believed.
    """
    said = [Prepared(command, index) for index, command in enumerate(commands)]
    if not can_walk:
        return tuple(said)
    steps = tuple(_steps(commands, known))
    return (*(find for word in _SEE_WHO if (find := _finding(word, steps)) is not None), *steps)


def _finding(word: str, steps: Sequence[Prepared]) -> Prepared | None:
    """What tells who "me" or the person in front is before the robot goes away; None where that can wait.

    Who was told to go somewhere first means who is in front of it there.
    """
    to_them = [step.command for step in steps if step.said is not None and whom(step.command) == word]
    before = list(itertools.takewhile(lambda step: whom(step.command) != word, steps))
    if not to_them or not any(map(_goes_away, before)):
        return None
    if word == IN_FRONT and any(step.said is not None and _goes_away(step) for step in before):
        return None
    goes_back = all(map(_arrives, to_them))
    find = task_that(After.PERSON_KNOWN, _SEE_WHO[word], person=word)
    return Prepared(find, finds_who=word, may_fail=goes_back and word == SPEAKER)


def _goes_away(step: Prepared) -> bool:
    """Whether the robot is elsewhere after a step, where "me" would be somebody else."""
    return goes_away(step.command)


def _arrives(command: Command) -> bool:
    """Whether the robot stands before what a command says after it."""
    return brings_about(command, After.AT_GOAL)


def looked_for(
    commands: Sequence[Command], index: int, known: Known, who_is_known: Container[str] = ()
) -> tuple[Prepared, ...]:
    """From one command on, with what has to be done where it is not to be seen from here: it is walked to."""
    steps = prepared(commands, True, replace(known, is_away=True))
    done = [place for place, step in enumerate(steps) if step.said is not None and step.said < index]
    begins = done[-1] + 1 if done else 0
    finding = [step for step in steps if step.finds_who and step.finds_who not in who_is_known]
    return (*finding, *(step for step in steps[begins:] if not step.finds_who))


def _steps(commands: Sequence[Command], known: Known) -> Iterator[Prepared]:
    opened: set[str] = set()
    roams = away = bool(known.rooms) or known.is_away
    for index, command in enumerate(commands):
        if brings_about(command, After.THING_OPEN):
            opened.add(str(getattr(command, "object", "")))
        if strays(command):
            yield Prepared(command, index)
            roams = away = True
            continue
        if (room := _carried_to(index, commands, known)) is not None:
            yield room
            continue
        inside = inside_of(command)
        before: list[Prepared] = []
        thing = _to_be_picked(command, commands)
        held = puts_in(command) and known.in_hand(command)
        if inside is not None and handles(command):
            if inside not in opened and not known.in_view(command):
                before += opening(inside)
            opened.add(inside)
            away = True
        elif (door := door_for(index, commands)) is not None:
            if door not in opened and not known.is_open:
                if held and thing is not None:
                    before.append(put_down(thing, door))
                    held = False
                before += opening(door)
                opened.add(door)
            away = away or door in opened
        elif (drawer := shut_drawer(index, commands, known, opened)) is not None:
            if held and puts_in(command) and isinstance(command.object, ObjectDescription):
                before.append(put_down(command.object, str(drawer)))
            before.append(Prepared(open_it(drawer)))
            opened.add(str(drawer))
        walked = index > 0 and _arrives(commands[index - 1])
        if roams and inside is None and behind_of(command, commands) is None:
            before += _fetching(index, commands, known)
        elif away and thing is not None and not held:
            said_where = inside or (command.source if handles(command) else None)
            reach = walk(f"come within reach of the {thing}", _at_its_source(thing, said_where))
            before.append(Prepared(reach, unless_held=command if puts_in(command) else None))
        seen_from = seen_from_where(command) if roams and not walked else None
        if requires(command, Before.PERSON_KNOWN) and seen_from in known.rooms:
            seen_from = None  # it goes as far into the room as people leave a way
        if seen_from is not None:
            beside = Nearness(_described(seen_from))
            before.append(Prepared(walk(f"walk to the {seen_from}", seen_from), unless_near=beside))
        there = _there(command, commands, known)
        if not away and not walked and isinstance(there, str) and _is_carried(command, known):
            before.append(
                Prepared(walk(f"walk to the {there}", there), unless_near=Nearness(_described(there)))
            )
        if away and there is not None and not walked:
            near = Nearness(_described(there)) if roams and not _is_person(there) else None
            before.append(Prepared(walk(f"walk to {_named(there)}", there), unless_near=near))
        yield from before
        yield Prepared(command, index, is_reached=any(_arrives(one.command) for one in before))


def _is_carried(command: Command, known: Known) -> bool:
    """Whether a command puts down what a hand holds by then: it may be meant for another table."""
    return puts_on(command) and (isinstance(command.object, ObjectOf) or known.in_hand(command))


def _carried_to(index: int, commands: Sequence[Command], known: Known) -> Prepared | None:
    """Walking to a room with what the next command puts somewhere there: "and put it on the counter"."""
    command, after = commands[index], commands[index + 1] if index + 1 < len(commands) else None
    if not puts_on(command) or not isinstance(command.object, ObjectOf):
        return None
    room = goal(command)
    if not isinstance(room, str) or room not in known.rooms:
        return None
    if after is None or not handles(after) or not requires(after, Before.THING_HELD):
        return None
    if after.object not in (None, command.object, ObjectOf(index)):
        return None
    return Prepared(walk(command.text, room), index, carries=command.object.task)


def _fetching(index: int, commands: Sequence[Command], known: Known) -> Iterator[Prepared]:
    """What brings an object into a hand that may be anywhere in some rooms; nothing for several at once."""
    command = commands[index]
    if not handles(command) or command.count != 1 or known.in_hand(command):
        return
    thing, source = command.object, command.source
    if isinstance(thing, ObjectOf) and takes(command) and _was_only_seen(thing, commands[:index]):
        yield Prepared(walk("come within reach of it", thing))
    if not isinstance(thing, ObjectDescription):
        return
    before = commands[index - 1] if index > 0 else None
    walked_to = goal(before) if before is not None and _arrives(before) else None
    if walked_to is None or walked_to in known.rooms or source not in (None, walked_to):
        there = _at_its_source(thing, source)
        if isinstance(source, str | ObjectDescription):
            yield Prepared(
                walk(f"walk to the {source}", source), unless_near=Nearness(there, within_reach=False)
            )
        reach = walk(f"come within reach of the {there}", there)
        yield Prepared(reach, unless_near=Nearness(there, within_reach=True), finds_for=index)
    if requires(command, Before.THING_HELD):
        said = f"pick up the {thing}"
        pick = task_that(After.THING_HELD, said, object=thing, source=source, hand=command.hand)
        yield Prepared(pick, finds_for=index)


def _was_only_seen(thing: ObjectOf, before: Sequence[Command]) -> bool:
    """Whether no hand had what an earlier command was about: "find the cup and take it"."""
    if not 0 <= thing.task < len(before):
        return False
    command = before[thing.task]
    return isinstance(getattr(command, "object", None), ObjectDescription) and not handles(command)


def _at_its_source(thing: ObjectDescription, source: Destination | None) -> ObjectDescription:
    """A thing with where it is said to be, for who walks to it: "the cup on the other table"."""
    if thing.relation is not None or not isinstance(source, str | ObjectDescription):
        return thing
    holds_it = isinstance(source, ObjectDescription) and not _is_furniture(source)
    return replace(thing, relation=Relation("in" if holds_it else "on", source))


def _is_furniture(there: ObjectDescription) -> bool:
    return there.kind is not None and kind_called(there.kind) in FURNITURE_KINDS


def _to_be_picked(command: Command, commands: Sequence[Command]) -> ObjectDescription | None:
    """The object that a command is going to pick up, or that was put down for it."""
    if puts_in(command) and behind_of(command, commands) is None:
        return None
    thing = command.object if takes(command) or puts_in(command) else None
    return thing if isinstance(thing, ObjectDescription) else None


def _there(command: Command, commands: Sequence[Command], known: Known) -> Destination | None:
    """Where what is held is to go; what puts things behind a door, or into a drawer, goes there by itself."""
    if not requires(command, Before.AT_GOAL):
        return None
    there = goal(command)
    if puts_on(command):
        if there == WHERE_IT_WAS:
            before = known.stood_on(command)
            return None if before is None else ObjectDescription(name=before)
        beside = there.relation if isinstance(there, ObjectDescription) and there.kind is None else None
        return there if beside is None else beside.to
    if behind_of(command, commands) is not None:
        return None
    return _of_drawer(there, known) if requires(command, Before.GOAL_OPEN) and _is_drawer(there) else there


def _of_drawer(there: Destination | None, known: Known) -> Destination:
    """What a drawer is said to be part of: "cabinet" of "the top drawer of the cabinet"; else a chest."""
    relation = there.relation if isinstance(there, ObjectDescription) else None
    of_chest = relation is None or relation.kind != "in" or relation.to in known.rooms
    return BODY_OF[DRAWER] if relation is None or of_chest else relation.to


def _is_drawer(there: Destination | None) -> bool:
    return isinstance(there, str | ObjectDescription) and _described(there).kind == DRAWER


def seen_from_where(command: Command) -> str | ObjectDescription | None:
    """From where one sees what a command asks about; what is behind a door nobody sees."""
    source = getattr(command, "source", None) if requires(command, Before.SOURCE_IN_VIEW) else None
    if isinstance(source, ObjectDescription):
        return source if _is_furniture(source) and source.kind not in MEANT_BY else None
    return source if isinstance(source, str) and source not in MEANT_BY else None


def _is_person(there: Destination) -> bool:
    return isinstance(there, str) and (there == SPEAKER or there.istitle())


def _described(there: Destination) -> ObjectDescription:
    return there if isinstance(there, ObjectDescription) else ObjectDescription(str(there))


def _named(there: Destination) -> str:
    if there == IN_FRONT:
        return "the person in front"
    return str(there) if _is_person(there) else f"the {there}"
