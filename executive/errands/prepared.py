"""Tasks of an errand in the order in which they are done, and what is believed when that order is made."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from executive.errands.nearness import Nearness
from executive.meaning import Command
from trees.tasks import Bringing


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
    stood_on: Callable[[Bringing], str | None] = lambda _task: None
    is_away: bool = False
    drawer_is_open: bool = False


NOTHING_KNOWN = Known()
