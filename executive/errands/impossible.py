"""What no search would help with, told before anything moves: a room off the map, the floor, below things."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass

from executive.errands.beyond_the_eyes import cannot_be_told, what_can_be_found
from executive.errands.required import handles, puts_on
from executive.meaning import Command
from executive.understanding.canonical_words import vocabulary
from kinematics.model.robot_description import RobotDescription
from trees.beliefs.grounding.articles import with_article
from trees.beliefs.grounding.report_words import listed
from trees.readiness import lacking
from trees.registry import skill_of
from trees.tasks import Bringing, ObjectDescription
from trees.toolbox import Toolbox


def missing_room(commands: Sequence[Command], rooms: Collection[str]) -> tuple[Command, str] | None:
    """The first command that speaks of a room which is not on the map, with that word; None without one.

    Args:
        commands: What was said.
        rooms: Names of the rooms on the map.
    """
    for command in commands:
        for slot in _SLOTS:
            said = getattr(command, slot, None)
            if isinstance(said, str) and said not in rooms and _is_room(said):
                return command, said
    return None


def _is_room(word: str) -> bool:
    """Whether it is the name of nothing but a room."""
    words = word.lower().split()
    length, readings = vocabulary().match(words)
    return length == len(words) > 0 and bool(readings) and all(one.word_class == "ROOM" for one in readings)


_FLOOR = "floor"
_SLOTS = ("source", "on", "to")


@dataclass(frozen=True, slots=True)
class Impossible:
    """A command that cannot be done, why, and the word that says so."""

    command: Command
    message: str
    word: str


def beyond(commands: Sequence[Command], toolbox: Toolbox) -> Impossible | None:
    """The first command that cannot be done here, or for which the robot lacks something; None without one.

    Args:
        commands: What was said.
        toolbox: Knows the robot, and the rooms on the map.
    """
    found = impossible(commands, toolbox.places, toolbox.detector.labels, toolbox.detector.fronts)
    return _lacks_for(commands, toolbox) if found is None else found


def _lacks_for(commands: Sequence[Command], toolbox: Toolbox) -> Impossible | None:
    """The first command for which the robot lacks something."""
    for command in commands:
        skill = skill_of(command)
        lacks = None if skill is None else lacking(skill, toolbox)
        if lacks is not None:
            told = f"{command.action} needs {lacks.need.value}; {lacks.why}"
            return Impossible(command, told, command.action)
        if (unknown := no_such_hand(command, toolbox.model.description)) is not None:
            return unknown
    return None


def no_such_hand(command: Command, robot: RobotDescription) -> Impossible | None:
    """That a command names a hand which the robot does not have; None where it names none, or one it has.

    Args:
        command: What was said.
        robot: Its data.
    """
    hand = getattr(command, "hand", None)
    if hand is None or hand in robot.hands:
        return None
    others = f", but its {' and '.join(robot.hands)} hand" if robot.hands else ""
    return Impossible(command, f"{robot.name} has no {hand} hand{others}", hand)


def impossible(
    commands: Sequence[Command],
    rooms: Collection[str],
    labels: Collection[str] | None = None,
    fronts: Collection[str] = (),
) -> Impossible | None:
    """The first command that cannot be done here, whatever is seen; None without one.

    Args:
        commands: What was said.
        rooms: Names of the rooms on the map.
        labels: The words that perception can tell; None: any. None at all where the body brings no eyes.
        fronts: The doors and drawers that it tells apart by the piece that they are of.
    """
    missing = missing_room(commands, rooms)
    if missing is not None:
        command, room = missing
        known = f"it has {listed([f'the {name}' for name in sorted(rooms)])}" if rooms else "it has no rooms"
        return Impossible(command, f"there is no {room} on the map; {known}", room)
    for command in commands:
        if handles(command) and any(map(_is_floor, _places(command))):
            return Impossible(command, "the floor is too low for the hands of this robot", _FLOOR)
        if puts_on(command) and (below := _below(command)) is not None:
            return Impossible(command, f"this robot puts nothing below something else, as {below}", "under")
    if labels is not None and (untold := cannot_be_told(commands, labels)) is not None:
        command, word = untold
        if not labels:
            return Impossible(command, f"the robot has no eyes here to find {with_article(word)} by", word)
        known = f"I do not know what {with_article(word)} looks like; I can find"
        return Impossible(command, f"{known} {what_can_be_found(word, labels)}", word)
    return next(filter(None, (_refused(command, fronts) for command in commands)), None)


def _refused(command: Command, fronts: Collection[str]) -> Impossible | None:
    """What its skill says that nobody could do."""
    skill = skill_of(command)
    told = "" if skill is None else skill.refuses(command, fronts)
    return Impossible(command, told, command.action) if told else None


def _places(command: Bringing) -> list[object]:
    """Where its thing is said to be, and where it goes."""
    own = command.object.relation if isinstance(command.object, ObjectDescription) else None
    is_on = [own.to] if own is not None and own.kind == "on" else []
    return [*(getattr(command, slot, None) for slot in _SLOTS), *is_on]


def _below(command: Bringing) -> str | None:
    """What it would have to be put below: "under the table"."""
    to = getattr(command, "to", None)
    relation = to.relation if isinstance(to, ObjectDescription) and to.kind is None else None
    return str(relation) if relation is not None and relation.kind == "under" else None


def _is_floor(place: object) -> bool:
    kind = place.kind if isinstance(place, ObjectDescription) else place
    return kind == _FLOOR
