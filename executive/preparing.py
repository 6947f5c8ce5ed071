"""What has to be done before a command of an errand, that nobody said: to walk, to open, to see who speaks.

"Bring me the bottle from the fridge" means a pick and a hand-over. Between them and before them a robot that
can walk goes to the fridge, opens it, comes within reach of the bottle, and walks back to who spoke; each of
these is a task of its own, so that what fails is told as what it is.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace

from executive.meaning import Command
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
    Task,
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
    """

    command: Command
    said: int | None = None
    finds_speaker: bool = False


def prepared(
    commands: Sequence[Command], can_walk: bool, in_view: Callable[[PickTask], bool] = lambda _pick: False
) -> tuple[Prepared, ...]:
    """The commands with what has to be done before them.

    Nothing is added for a robot that stands where it stands, nor where everything is told to be at hand: only
    a pick out of something that has a door makes it walk. From then on it has left the place where it was,
    and goes to whom or to where it is told to bring things.

    Args:
        commands: What was said, in order.
        can_walk: Whether the robot walks.
        in_view: Tells of a pick whether its object was seen inside already: then nothing has to be opened.
    """
    said = [Prepared(command, index) for index, command in enumerate(commands)]
    if not can_walk:
        return tuple(said)
    steps = list(_steps(commands, in_view))
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


def _steps(commands: Sequence[Command], in_view: Callable[[PickTask], bool]) -> Iterator[Prepared]:
    opened: set[str] = set()
    away = False
    for index, command in enumerate(commands):
        if isinstance(command, OpenTask):
            opened.add(str(command.object))
        inside = _inside(command)
        before: list[Task] = []
        if isinstance(command, PickTask) and inside is not None:
            if inside not in opened and not in_view(command):
                before += [
                    WalkToTask(f"walk to the {inside}", inside),
                    OpenTask(f"open the {inside}", ObjectDescription(inside)),
                ]
            opened.add(inside)
            away = True
            if not isinstance(command.object, ObjectOf):
                before.append(WalkToTask(f"come within reach of the {command.object}", command.object))
        there = _there(command)
        walked = index > 0 and isinstance(commands[index - 1], WalkToTask)
        if away and there is not None and not walked:
            before.append(WalkToTask(f"walk to {_named(there)}", there))
        yield from (Prepared(task) for task in before)
        yield Prepared(command, index)


def _inside(command: Command) -> str | None:
    """What has a door and holds the object of a pick, as one word."""
    source = command.source if isinstance(command, PickTask) else None
    word = source.kind if isinstance(source, ObjectDescription) else source
    return word if isinstance(word, str) and word in MEANT_BY else None


def _there(command: Command) -> Destination | None:
    """Where what is held is to go."""
    if isinstance(command, HandOverTask):
        return command.to
    if isinstance(command, PlaceTask):
        return command.on or command.to
    return command.to if isinstance(command, PutInTask) else None


def _who(command: Command) -> str | None:
    to = getattr(command, "to", None)
    return to if isinstance(to, str) else None


def _named(there: Destination) -> str:
    return there if isinstance(there, str) and (there == SPEAKER or there.istitle()) else f"the {there}"
