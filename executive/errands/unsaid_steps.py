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
from collections.abc import Callable, Container, Iterator, Sequence
from dataclasses import dataclass, replace

from executive.errands.nearness import Nearness, leads_away
from executive.errands.required import goes_away, handles, requires, takes, whom
from executive.meaning import Command
from robots.scenes.articulated import DRAWER
from robots.scenes.furniture import FURNITURE_KINDS
from robots.scenes.furniture_names import kind_called
from trees.beliefs.openings.fridge_inside import is_behind_door
from trees.beliefs.openings.handles import BODY_OF, MEANT_BY
from trees.skill import Before
from trees.tasks import (
    WHERE_IT_WAS,
    Bringing,
    Destination,
    FindTask,
    HandOverTask,
    MoveTask,
    ObjectDescription,
    ObjectOf,
    OpenTask,
    PickTask,
    PlaceTask,
    PutInTask,
    Relation,
    WalkToTask,
)

SPEAKER, IN_FRONT = "me", "in_front"
_SEE_WHO = {SPEAKER: "see who speaks", IN_FRONT: "see who is in front"}
"""Whom words mean that others would be meant by once the robot has gone away."""


@dataclass(frozen=True, slots=True)
class Prepared:
    """One task of an errand: a command that was said, or a step that nobody said but that one needs.

    Attributes:
        command: What to do.
        said: Index of the command that was said; None for what has to be done before it.
        finds_who: The word of which it tells who that is, for all that follows: "me". Where it may fail,
            nobody has to be there: "come back" is to where the robot began then.
        unless_open: Whether it is left out when the door turns out to stand open.
        unless_held: Left out while a hand holds what this is about.
        unless_near: Left out while this is known.
        finds_for: Index of the said command whose object is the one that this task was about.
        may_fail: Whether the errand goes on without it.
        carries: Index of the said command whose object this one only takes along.
        is_reached: Whether a walk to what it is about comes before it.
    """

    command: Command
    said: int | None = None
    finds_who: str = ""
    unless_open: bool = False
    unless_held: Bringing | None = None
    unless_near: Nearness | None = None
    finds_for: int | None = None
    may_fail: bool = False
    carries: int | None = None
    is_reached: bool = False


@dataclass(frozen=True, slots=True)
class Known:
    """What the robot believes when an errand begins.

    Attributes:
        in_view: Tells of what is to be taken whether it was seen inside already: then nothing is opened.
        in_hand: Tells of what is to be put somewhere whether a hand holds it already.
        is_open: Whether the door that is known stands open.
        is_near: Tells whether a walk is needless.
        stood_on: Tells of what is to be put back what it stood on, by its name in the planning scene.
        rooms: Names of the rooms on the map; where there are any, not all that is spoken of is at hand.
        drawer_is_open: Whether the inside of a drawer is known, and open to above.
        is_away: Whether the robot has left the place where it began: nor is all at hand then.
    """

    in_view: Callable[[Bringing], bool] = lambda _task: False
    in_hand: Callable[[Bringing], bool] = lambda _task: False
    is_open: bool = False
    is_near: Callable[[Nearness], bool] = lambda _nearness: False
    rooms: frozenset[str] = frozenset()
    stood_on: Callable[[PlaceTask], str | None] = lambda _task: None
    is_away: bool = False
    drawer_is_open: bool = False


NOTHING_KNOWN = Known()


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
    goes_back = all(isinstance(command, WalkToTask) for command in to_them)
    find = FindTask(_SEE_WHO[word], person=word)
    return Prepared(find, finds_who=word, may_fail=goes_back and word == SPEAKER)


def _goes_away(step: Prepared) -> bool:
    """Whether the robot is elsewhere after a step, where "me" would be somebody else."""
    command = step.command
    return leads_away(command) if isinstance(command, MoveTask) else goes_away(command)


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
        if isinstance(command, OpenTask):
            opened.add(str(command.object))
        if isinstance(command, MoveTask) and leads_away(command):
            yield Prepared(command, index)
            roams = away = True
            continue
        if (room := _carried_to(index, commands, known)) is not None:
            yield room
            continue
        inside = _inside(command)
        before: list[Prepared] = []
        thing = _to_be_picked(command, commands)
        held = isinstance(command, PutInTask) and known.in_hand(command)
        if inside is not None and handles(command):
            if inside not in opened and not known.in_view(command):
                before += _opening(inside)
            opened.add(inside)
            away = True
        elif (door := _door_for(index, commands)) is not None:
            if door not in opened and not known.is_open:
                if held and thing is not None:
                    before.append(_put_down(thing, door))
                    held = False
                before += _opening(door)
                opened.add(door)
            away = away or door in opened
        elif (drawer := _shut_drawer(index, commands, known, opened)) is not None:
            if held and isinstance(command, PutInTask) and isinstance(command.object, ObjectDescription):
                before.append(_put_down(command.object, str(drawer)))
            before.append(Prepared(OpenTask(f"open the {drawer}", drawer)))
            opened.add(str(drawer))
        walked = index > 0 and isinstance(commands[index - 1], WalkToTask)
        if roams and inside is None and _behind_of(command, commands) is None:
            before += _fetching(index, commands, known)
        elif away and thing is not None and not held:
            said_where = inside or (command.source if handles(command) else None)
            reach = WalkToTask(f"come within reach of the {thing}", _at_its_source(thing, said_where))
            before.append(Prepared(reach, unless_held=command if isinstance(command, PutInTask) else None))
        seen_from = seen_from_where(command) if roams and not walked else None
        if requires(command, Before.PERSON_KNOWN) and seen_from in known.rooms:
            seen_from = None  # it goes as far into the room as people leave a way
        if seen_from is not None:
            beside = Nearness(_described(seen_from))
            before.append(Prepared(WalkToTask(f"walk to the {seen_from}", seen_from), unless_near=beside))
        there = _there(command, commands, known)
        if not away and not walked and isinstance(there, str) and _is_carried(command, known):
            before.append(
                Prepared(WalkToTask(f"walk to the {there}", there), unless_near=Nearness(_described(there)))
            )
        if away and there is not None and not walked:
            near = Nearness(_described(there)) if roams and not _is_person(there) else None
            before.append(Prepared(WalkToTask(f"walk to {_named(there)}", there), unless_near=near))
        yield from before
        yield Prepared(command, index, is_reached=any(isinstance(one.command, WalkToTask) for one in before))


def _is_carried(command: Command, known: Known) -> bool:
    """Whether a command puts down what a hand holds by then: it may be meant for another table."""
    return isinstance(command, PlaceTask) and (isinstance(command.object, ObjectOf) or known.in_hand(command))


def _carried_to(index: int, commands: Sequence[Command], known: Known) -> Prepared | None:
    """Walking to a room with what the next command puts somewhere there: "and put it on the counter"."""
    command, after = commands[index], commands[index + 1] if index + 1 < len(commands) else None
    if not isinstance(command, PlaceTask) or not isinstance(command.object, ObjectOf):
        return None
    if command.on is not None or not isinstance(command.to, str) or command.to not in known.rooms:
        return None
    if not isinstance(after, HandOverTask | PlaceTask | PutInTask):
        return None
    if after.object not in (None, command.object, ObjectOf(index)):
        return None
    return Prepared(WalkToTask(command.text, command.to), index, carries=command.object.task)


def _fetching(index: int, commands: Sequence[Command], known: Known) -> Iterator[Prepared]:
    """What brings an object into a hand that may be anywhere in some rooms; nothing for several at once."""
    command = commands[index]
    if not handles(command) or command.count != 1 or known.in_hand(command):
        return
    thing, source = command.object, command.source
    if not isinstance(thing, ObjectDescription):
        return
    before = commands[index - 1] if index > 0 else None
    walked_to = before.to if isinstance(before, WalkToTask) else None
    if walked_to is None or walked_to in known.rooms or source not in (None, walked_to):
        there = _at_its_source(thing, source)
        if isinstance(source, str | ObjectDescription):
            yield Prepared(
                WalkToTask(f"walk to the {source}", source), unless_near=Nearness(there, within_reach=False)
            )
        reach = WalkToTask(f"come within reach of the {there}", there)
        yield Prepared(reach, unless_near=Nearness(there, within_reach=True), finds_for=index)
    if requires(command, Before.THING_HELD):
        pick = PickTask(f"pick up the {thing}", thing, source, command.hand)
        yield Prepared(pick, finds_for=index)


def _at_its_source(thing: ObjectDescription, source: Destination | None) -> ObjectDescription:
    """A thing with where it is said to be, for who walks to it: "the cup on the other table"."""
    if thing.relation is not None or not isinstance(source, str | ObjectDescription):
        return thing
    holds_it = isinstance(source, ObjectDescription) and not _is_furniture(source)
    return replace(thing, relation=Relation("in" if holds_it else "on", source))


def _is_furniture(there: ObjectDescription) -> bool:
    return there.kind is not None and kind_called(there.kind) in FURNITURE_KINDS


def _opening(word: str) -> list[Prepared]:
    walk = WalkToTask(f"walk to the {word}", word)
    return [Prepared(walk), Prepared(OpenTask(f"open the {word}", ObjectDescription(word)), unless_open=True)]


def _door_for(index: int, commands: Sequence[Command]) -> str | None:
    """What has to be open before a command: it puts something there, or picks up what goes there later."""
    put = _put_of(index, commands)
    return None if put is None else _behind(put, commands)


def _put_of(index: int, commands: Sequence[Command]) -> PutInTask | None:
    """The command itself where it puts something in, or the first one that puts in what it picks up."""
    command = commands[index]
    if isinstance(command, PutInTask):
        return command
    later = commands[index + 1 :] if isinstance(command, PickTask) else ()
    return next((put for put in later if isinstance(put, PutInTask) and put.object == ObjectOf(index)), None)


def _put_down(thing: ObjectDescription, until_open: str) -> Prepared:
    """What is held is put down until both hands are free for a door or a drawer."""
    down = PlaceTask(f"put the {thing} down until the {until_open} is open", thing)
    return Prepared(down, may_fail=True)


def _shut_drawer(
    index: int, commands: Sequence[Command], known: Known, opened: set[str]
) -> ObjectDescription | None:
    """The drawer that has to be opened before a command: as for doors, but it is not walked to."""
    if known.drawer_is_open or any(DRAWER in one.split() for one in opened):
        return None
    put = _put_of(index, commands)
    if put is None or not isinstance(put.to, str | ObjectDescription):
        return None  # what opened or found it has named it
    there = _described(put.to)
    return there if there.kind == DRAWER else None


def _behind(put: PutInTask, commands: Sequence[Command]) -> str | None:
    to = getattr(commands[put.to.task], "object", None) if isinstance(put.to, ObjectOf) else put.to
    word = to.kind if isinstance(to, ObjectDescription) else to
    return word if isinstance(word, str) and is_behind_door(word) else None


def _behind_of(command: Command, commands: Sequence[Command]) -> str | None:
    return _behind(command, commands) if isinstance(command, PutInTask) else None


def _to_be_picked(command: Command, commands: Sequence[Command]) -> ObjectDescription | None:
    """The object that a command is going to pick up, or that was put down for it."""
    if isinstance(command, PutInTask) and _behind(command, commands) is None:
        return None
    thing = command.object if takes(command) or isinstance(command, PutInTask) else None
    return thing if isinstance(thing, ObjectDescription) else None


def _inside(command: Command) -> str | None:
    """What has a door and holds the object of a pick, as one word."""
    source = command.source if handles(command) and requires(command, Before.SOURCE_OPEN) else None
    word = source.kind if isinstance(source, ObjectDescription) else source
    return word if isinstance(word, str) and word in MEANT_BY else None


def _there(command: Command, commands: Sequence[Command], known: Known) -> Destination | None:
    """Where what is held is to go; what puts things behind a door, or into a drawer, goes there by itself."""
    if not requires(command, Before.AT_GOAL):
        return None
    if isinstance(command, PlaceTask) and command.to == WHERE_IT_WAS:
        before = known.stood_on(command)
        return None if before is None else ObjectDescription(name=before)
    if isinstance(command, PlaceTask):
        to = command.on or command.to
        beside = to.relation if isinstance(to, ObjectDescription) and to.kind is None else None
        return to if beside is None else beside.to
    if _behind_of(command, commands) is not None:
        return None
    there: Destination | None = getattr(command, "to", None) or getattr(command, "person", None)
    return BODY_OF[DRAWER] if requires(command, Before.GOAL_OPEN) and _is_drawer(there) else there


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
