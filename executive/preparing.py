"""What has to be done before a command of an errand, that nobody said: to walk, to open, to see who speaks.

"Bring me the bottle from the fridge" means a pick and a hand-over. Between them and before them a robot that
can walk goes to the fridge, opens it, comes within reach of the bottle, and walks back to who spoke; each of
these is a task of its own, so that what fails is told as what it is.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace

from executive.meaning import Command
from trees.fridge_inside import is_behind_door
from trees.handles import MEANT_BY
from trees.tasks import (
    Destination,
    FindTask,
    HandOverTask,
    ObjectDescription,
    ObjectOf,
    OpenTask,
    PickTask,
    PlaceTask,
    PutInTask,
    WalkToTask,
)

SPEAKER = "me"


@dataclass(frozen=True, slots=True)
class Prepared:
    """One task of an errand.

    Attributes:
        command: What to do.
        said: Index of the command that was said; None for what has to be done before it.
        finds_speaker: Whether it tells who "me" is, for all that follows.
        unless_open: Whether it is left out when the door turns out to stand open.
        unless_held: Left out while a hand holds what this is about.
        may_fail: Whether the errand goes on without it.
    """

    command: Command
    said: int | None = None
    finds_speaker: bool = False
    unless_open: bool = False
    unless_held: PutInTask | None = None
    may_fail: bool = False


@dataclass(frozen=True, slots=True)
class Known:
    """What the robot believes when an errand begins.

    Attributes:
        in_view: Tells of a pick whether its object was seen inside already: then nothing has to be opened.
        in_hand: Tells of what is to be put somewhere whether a hand holds it already.
        is_open: Whether the door that is known stands open.
    """

    in_view: Callable[[PickTask], bool] = lambda _pick: False
    in_hand: Callable[[PutInTask], bool] = lambda _put: False
    is_open: bool = False


NOTHING_KNOWN = Known()


def prepared(
    commands: Sequence[Command], can_walk: bool, known: Known = NOTHING_KNOWN
) -> tuple[Prepared, ...]:
    """The commands with what has to be done before them.

    Nothing is added for a robot that stands where it stands, nor where everything is told to be at hand: only
    what has a door, and is taken from or put into, makes it walk. From then on it has left the place where it
    was, and goes to whom or to where it is told to bring things. A door behind which something goes is opened
    first, with empty hands: what is held is put down for it.

    Args:
        commands: What was said, in order.
        can_walk: Whether the robot walks.
        known: What is believed.
    """
    said = [Prepared(command, index) for index, command in enumerate(commands)]
    if not can_walk:
        return tuple(said)
    steps = list(_steps(commands, known))
    walks = any(isinstance(step.command, WalkToTask) for step in steps if step.said is None)
    if walks and any(_who(command) == SPEAKER for command in commands):
        find = FindTask("see who speaks", person=SPEAKER)
        steps.insert(0, Prepared(find, finds_speaker=True))
    return tuple(steps)


def spoken_by(command: Command, name: str) -> Command:
    """The same command with "me" replaced by a name."""
    if _who(command) == SPEAKER and isinstance(command, HandOverTask | WalkToTask):
        return replace(command, to=name)
    return command


def _steps(commands: Sequence[Command], known: Known) -> Iterator[Prepared]:
    opened: set[str] = set()
    away = False
    for index, command in enumerate(commands):
        if isinstance(command, OpenTask):
            opened.add(str(command.object))
        inside = _inside(command)
        before: list[Prepared] = []
        thing = _to_be_picked(command, commands)
        held = isinstance(command, PutInTask) and known.in_hand(command)
        if isinstance(command, PickTask) and inside is not None:
            if inside not in opened and not known.in_view(command):
                before += _opening(inside)
            opened.add(inside)
            away = True
        elif (door := _door_for(index, commands)) is not None:
            if door not in opened and not known.is_open:
                if held and thing is not None:
                    down = PlaceTask(f"put the {thing} down until the {door} is open", thing)
                    before.append(Prepared(down, may_fail=True))
                    held = False
                before += _opening(door)
                opened.add(door)
            away = away or door in opened
        if away and thing is not None and not held:
            reach = WalkToTask(f"come within reach of the {thing}", thing)
            before.append(Prepared(reach, unless_held=command if isinstance(command, PutInTask) else None))
        there = _there(command, commands)
        walked = index > 0 and isinstance(commands[index - 1], WalkToTask)
        if away and there is not None and not walked:
            before.append(Prepared(WalkToTask(f"walk to {_named(there)}", there)))
        yield from before
        yield Prepared(command, index)


def _opening(word: str) -> list[Prepared]:
    walk = WalkToTask(f"walk to the {word}", word)
    return [Prepared(walk), Prepared(OpenTask(f"open the {word}", ObjectDescription(word)), unless_open=True)]


def _door_for(index: int, commands: Sequence[Command]) -> str | None:
    """What has to be open before a command: it puts something there, or picks up what goes there later."""
    command = commands[index]
    if isinstance(command, PutInTask):
        return _behind(command, commands)
    if not isinstance(command, PickTask):
        return None
    for later in commands[index + 1 :]:
        if isinstance(later, PutInTask) and isinstance(later.object, ObjectOf) and later.object.task == index:
            return _behind(later, commands)
    return None


def _behind(put: PutInTask, commands: Sequence[Command]) -> str | None:
    to = getattr(commands[put.to.task], "object", None) if isinstance(put.to, ObjectOf) else put.to
    word = to.kind if isinstance(to, ObjectDescription) else to
    return word if isinstance(word, str) and is_behind_door(word) else None


def _to_be_picked(command: Command, commands: Sequence[Command]) -> ObjectDescription | None:
    """The object that a command is going to pick up, or that was put down for it."""
    if isinstance(command, PutInTask) and _behind(command, commands) is None:
        return None
    thing = command.object if isinstance(command, PickTask | PutInTask) else None
    return thing if isinstance(thing, ObjectDescription) else None


def _inside(command: Command) -> str | None:
    """What has a door and holds the object of a pick, as one word."""
    source = command.source if isinstance(command, PickTask) else None
    word = source.kind if isinstance(source, ObjectDescription) else source
    return word if isinstance(word, str) and word in MEANT_BY else None


def _there(command: Command, commands: Sequence[Command]) -> Destination | None:
    """Where what is held is to go; what puts things behind a door comes within reach of it by itself."""
    if isinstance(command, HandOverTask):
        return command.to
    if isinstance(command, PlaceTask):
        return command.on or command.to
    return command.to if isinstance(command, PutInTask) and _behind(command, commands) is None else None


def _who(command: Command) -> str | None:
    to = getattr(command, "to", None)
    return to if isinstance(to, str) else None


def _named(there: Destination) -> str:
    return there if isinstance(there, str) and (there == SPEAKER or there.istitle()) else f"the {there}"
