"""What has to stand open before a command: a door or a drawer that its object goes into, or comes out of."""

from __future__ import annotations

from collections.abc import Sequence

from executive.errands.prepared import Known, Prepared
from executive.errands.required import brings_about, goal, handles, puts_in, requires, walk
from executive.meaning import Command
from robots.scenes.articulated import DRAWER
from trees.beliefs.openings.fridge_inside import is_behind_door
from trees.beliefs.openings.handles import MEANT_BY
from trees.registry import task_that
from trees.skill import After, Before
from trees.tasks import Bringing, ObjectDescription, ObjectOf


def open_it(there: ObjectDescription) -> Command:
    """The opening of something that another command needs."""
    command: Command = task_that(After.THING_OPEN, f"open the {there}", object=there)
    return command


def opening(word: str) -> list[Prepared]:
    """Going to what has a door, by its word, and opening it unless it turns out to be open."""
    there = walk(f"walk to the {word}", word)
    return [Prepared(there), Prepared(open_it(ObjectDescription(word)), unless_open=True)]


def door_for(index: int, commands: Sequence[Command]) -> str | None:
    """What has to be open before a command: it puts something there, or picks up what goes there later."""
    put = _put_of(index, commands)
    return None if put is None else _behind(put, commands)


def _put_of(index: int, commands: Sequence[Command]) -> Bringing | None:
    """The command itself where it puts something in, or the first one that puts in what it picks up."""
    command = commands[index]
    if puts_in(command):
        return command
    later = commands[index + 1 :] if brings_about(command, After.THING_HELD) else ()
    return next((put for put in later if puts_in(put) and put.object == ObjectOf(index)), None)


def put_down(thing: ObjectDescription, until_open: str) -> Prepared:
    """What is held is put down until both hands are free for a door or a drawer."""
    said = f"put the {thing} down until the {until_open} is open"
    down = task_that(After.THING_LEFT, said, object=thing)
    return Prepared(down, may_fail=True)


def shut_drawer(
    index: int, commands: Sequence[Command], known: Known, opened: set[str]
) -> ObjectDescription | None:
    """The drawer that has to be opened before a command: as for doors, but it is not walked to."""
    if known.drawer_is_open or any(DRAWER in one.split() for one in opened):
        return None
    put = _put_of(index, commands)
    to = None if put is None else goal(put)
    if not isinstance(to, str | ObjectDescription):
        return None  # what opened or found it has named it
    there = to if isinstance(to, ObjectDescription) else ObjectDescription(to)
    return there if there.kind == DRAWER else None


def _behind(put: Bringing, commands: Sequence[Command]) -> str | None:
    to = goal(put)
    if isinstance(to, ObjectOf):
        to = getattr(commands[to.task], "object", None)
    word = to.kind if isinstance(to, ObjectDescription) else to
    return word if isinstance(word, str) and is_behind_door(word) else None


def behind_of(command: Command, commands: Sequence[Command]) -> str | None:
    """What has a door and takes the object of a command, as one word."""
    return _behind(command, commands) if puts_in(command) else None


def inside_of(command: Command) -> str | None:
    """What has a door and holds the object of a pick, as one word."""
    source = command.source if handles(command) and requires(command, Before.SOURCE_OPEN) else None
    word = source.kind if isinstance(source, ObjectDescription) else source
    return word if isinstance(word, str) and word in MEANT_BY else None
