"""What is known of one skill, in one record; the robot's own skills and installed ones are such records.

Records are read by whoever only parses a sentence, so that this module, and the ``__init__`` of a skill's
folder, import nothing that acts: a record's tree imports its nodes when it is asked for one.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass
from enum import Enum
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from py_trees.behaviour import Behaviour

    from trees.toolbox import Toolbox

Evidence = Mapping[str, bool | float | int | str]
"""What the robot measured that proves a success, by name."""


class Before(Enum):
    """Something that has to be true before a skill begins; the value says it in words.

    An errand brings it about by tasks of their own: it walks, opens, picks up. It reads the slots that are
    named here, of whichever task has them.
    """

    THING_AT_HAND = "its ``object``, said to be at ``source``, is within reach of where the robot stands"
    THING_HELD = "its ``object`` is in a hand"
    SOURCE_OPEN = "where its ``object`` is said to be, ``source``, stands open"
    GOAL_OPEN = "what its ``object`` goes into, the task's goal, stands open"
    AT_GOAL = "the robot stands before the task's goal: where its ``object`` goes, or whom it is for"
    AT_SURFACE = "the robot stands before the furniture that its ``object`` is put on, the task's goal"
    SOURCE_IN_VIEW = "the robot stands before the furniture that it is asked about, ``source``"
    PERSON_KNOWN = "it is known who its ``person`` is, where a word as me means others elsewhere"


class After(Enum):
    """Something that is true once a task of a skill was done; the value says it in words.

    Whoever needs it, and has not been told how, has it brought about by the skill whose record names it:
    ``trees.registry.task_that`` makes the task.
    """

    THING_HELD = "its ``object`` is in a hand"
    THING_LEFT = "its ``object`` stands somewhere, and the hand that held it is empty"
    THING_OPEN = "its ``object`` stands open"
    AT_GOAL = "the robot stands before ``to``"
    PERSON_KNOWN = "it is known who the ``person`` is that a word stands for"


class Need(Enum):
    """Something that a robot has to have; the value names it."""

    HAND = "a hand that grips"
    BARS = "a hand that grips handles"
    TIPS = "a hand whose fingertips meet"
    ARM = "an arm"
    LEGS = "feet"
    EYES = "eyes that aim"


def as_asked(text: str, _subject: str, _evidence: Evidence) -> str:
    """The claim of a skill whose sentence says what was done: "wave to Ana"."""
    return text


def as_answered(text: str, _subject: str, evidence: Evidence) -> str:
    """The claim of a skill that answers a question: what it said."""
    return str(evidence.get("said", text))


def to_or_person(task: Any) -> Any:
    """The goal of a task that says it in its slot ``to`` or ``person``; None where it has none."""
    return getattr(task, "to", None) or getattr(task, "person", None)


def never(_task: Any) -> bool:
    """No task does it, whatever it says."""
    return False


def nothing(_task: Any, _fronts: Collection[str]) -> str:
    """Nothing speaks against it, whatever it says."""
    return ""


def no_longer(_task: Any) -> float:
    """What a task lasts of which nobody says how long."""
    return 0.0


Written = Callable[[str], Any]
"""Gives what the leaves of a task's tree wrote to a port, by the port's name; None where none wrote."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Skill:
    """One skill.

    A folder ``trees/skills/NAME`` hands on its record as ``SKILL``, or as ``SKILLS`` where several skills
    share their leaves; an installed package names its record in an entry point of the group
    ``humanoid_executive.skills``. Nothing else has to be told of a skill.

    Attributes:
        task: Type of the tasks that it carries out: a frozen dataclass with a field ``text``, the sentence
            that it came from, and a class attribute ``action``, the skill's name. Further fields are its
            slots.
        tree: Makes the tree that carries one task out. Its leaves read the task at the port "task" and write
            "evidence".
        example: A sentence for it, as it is listed.
        phrases: Whole sentences that mean a task without further slots, lower-case. Words of a vocabulary
            file do more: they are understood in any sentence (``docs/extend/a-skill.md``).
        make: Makes the task of a phrase that was said; ``task(text)`` when left out.
        verb: What it is called where people are told of it, "pick up"; the name of its action when left out.
        toward: The word between its verb and whom or what it is aimed at: "wave *to* Ana".
        claim: Says what was done, from the sentence, the noun of its object and the evidence.
        needs: What a robot has to have for it. Where something is missing nothing begins to move.
        before: What has to be true before it begins; what is not so is brought about first.
        after: What is true once a task was done; by this others find the skill that brings it about.
        goal: Where its object goes, or whom it is for, out of the task's slots.
        about: Names what a task that was done was about, as the planning scene has it, from what its leaves
            wrote. What was picked up is known without it.
        hands_stay: Whether the hands stay where a cancelled task left them: about a thing, at a handle, or
            low over furniture. Otherwise they are taken from there first.
        lasts_s: How long a task goes on because that was said, beyond the time that any task may take.
        goes_away: Whether the robot may be elsewhere afterwards, where "me" and "here" mean something else.
        strays: Whether a task leads the robot away to no place that anything is known of: what was at hand
            is not at hand afterwards either.
        refuses: Says what in a task's words nobody could do, whatever is seen; empty where there is nothing.
            It is told the doors and drawers that perception tells apart by their piece.
    """

    task: type[Any]
    tree: Callable[[Any, Toolbox], Behaviour]
    example: str
    phrases: tuple[str, ...] = ()
    make: Callable[[str], Any] | None = None
    verb: str = ""
    toward: str = ""
    claim: Callable[[str, str, Evidence], str] = as_asked
    needs: frozenset[Need] = frozenset()
    before: frozenset[Before] = frozenset()
    after: frozenset[After] = frozenset()
    goal: Callable[[Any], Any] = to_or_person
    about: Callable[[Written], str | None] | None = None
    hands_stay: bool = False
    lasts_s: Callable[[Any], float] = no_longer
    goes_away: bool = False
    strays: Callable[[Any], bool] = never
    refuses: Callable[[Any, Collection[str]], str] = nothing

    @property
    def action(self) -> str:
        """Its name: that of the action of its tasks."""
        return str(self.task.action)

    @property
    def words(self) -> str:
        """Its verb, or else its name in words: "go home"."""
        return self.verb or self.action.replace("_", " ")

    def task_of(self, text: str) -> Any:
        """The task that a phrase means.

        Args:
            text: What was said.
        """
        return (self.make or self.task)(text)
