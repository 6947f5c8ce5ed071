"""What a sentence has named and done up to some word: a frozen value, which each task returns anew."""

from __future__ import annotations

from collections.abc import Collection, Iterable
from dataclasses import dataclass, replace
from typing import Any, Literal

from executive.language.phrases.arranging import TroubleError
from executive.language.phrases.values import Draft, Nominal, Relative, Trouble
from executive.meaning import Command

Role = Literal[
    "object", "goal", "by", "again", "source", "taken", "walk", "beside", "person", "found", "quoted", "about"
]
"""What something was named as.

A task is done to its "object"; things go to a "goal" or "by" something, and come from a "source". What a task
before acts on already is named "again", or "taken" from. The robot walks to a "walk"; what is "beside"
something tells where that is. A "person" is met, or "found" at a place; who is "quoted" is named in words to
say, and what is "about" in a statement.
"""

THINGS = frozenset({"thing", "any"})
PUTS_DOWN = frozenset({"place", "put_in", "hand_over"})
MOVES = frozenset({"pick", *PUTS_DOWN})
LEAVES = frozenset({"walk_to", "move", "go_home", "follow", "guide"})
"""Tasks after which the robot is elsewhere."""

_PLACES = frozenset({"furniture", "container", "door", "room"})
_PEOPLE = frozenset({"person", "name"})
_TOLD_APART = frozenset({"thing", "furniture", "container"})


class UnresolvedError(TroubleError):
    """A word that stands for nothing, or for one of several things."""


def ask(message: str, choices: Iterable[str] = ()) -> UnresolvedError:
    """A question about what a word stands for."""
    return UnresolvedError(Trouble(message, asks=True, choices=tuple(choices)))


def is_them(value: Any) -> bool:
    """Whether it says "them", which may be one person of whom no more is known."""
    return isinstance(value, Nominal) and value.reference == "them"


@dataclass(frozen=True, slots=True)
class Named:
    """Something that was named: as what, in which clause, and for which task."""

    of: Nominal
    role: Role
    clause: int
    task: int

    @property
    def is_several(self) -> bool:
        """Whether nobody would call it "it": "the cups", "both cups", but not "the scissors", "all fruit"."""
        all_of_it = self.of.mass and self.of.count == "all"
        return not all_of_it and (self.of.count != 1 or (self.of.plural and not self.of.paired))


@dataclass(frozen=True, slots=True)
class Step:
    """A task that was ordered, how it was said, and the task that first acts on the same thing."""

    command: Command
    said: Draft
    root: int
    clause: int


@dataclass(frozen=True, slots=True)
class Discourse:
    """What was named and ordered so far.

    Attributes:
        steps: The tasks, in order.
        named: What was named, in order.
        clause: Which clause is read.
        kind: What was handled last, of whose kind "the blue one" is.
        ahead: What another clause names that is said before this one and done after it.
        backwards: Whether this clause is said before what is done first.
        remembers: Whether "back" may be where a thing was before it was picked up, wherever that was.
    """

    steps: tuple[Step, ...] = ()
    named: tuple[Named, ...] = ()
    clause: int = 0
    kind: Nominal | None = None
    ahead: tuple[Nominal, ...] = ()
    backwards: bool = False
    remembers: bool = False

    @property
    def last_action(self) -> str:
        """The action of the task before, or nothing."""
        return self.steps[-1].command.action if self.steps else ""

    def actions(self, since: int = 0) -> frozenset[str]:
        """The actions of a task and those after it."""
        return frozenset(step.command.action for step in self.steps[since:])

    def moved(self, *actions: str) -> frozenset[int]:
        """The first tasks of the things that were moved so last: put, taken or given away."""
        last = {step.root: step.command.action for step in self.steps if step.command.action in MOVES}
        return frozenset(root for root, action in last.items() if action in actions)

    @property
    def held(self) -> frozenset[int]:
        """The first tasks of the things in the hands."""
        return self.moved("pick")

    def as_named(self, *roles: Role, sorts: Collection[str] = ()) -> tuple[Named, ...]:
        """What was named so, of some sorts or of any."""
        return tuple(one for one in self.named if one.role in roles and (not sorts or one.of.sort in sorts))

    @property
    def things(self) -> tuple[Named, ...]:
        """What tasks act on, also those that act on it again."""
        return self.as_named("object")

    def recent(self, sorts: Collection[str] = (), but: int | None = None) -> list[Named]:
        """The things of some sorts, or of any, in the latest clause that has any; not those of one task."""
        fitting = [one for one in self.as_named("object", sorts=sorts) if one.task != but]
        latest = max((one.clause for one in fitting), default=-1)
        return list({one.task: one for one in fitting if one.clause == latest}.values())

    @property
    def places(self) -> tuple[Named, ...]:
        """Furniture, containers, doors and rooms that are gone to, put to, taken from or spoken of."""
        return self.as_named("object", "goal", "source", "walk", "about", sorts=_PLACES)

    @property
    def mentioned(self) -> tuple[Named, ...]:
        """Things that nothing is done to: where others go, come from and are."""
        return self.as_named("goal", "by", "source", "walk", "beside", sorts=THINGS)

    @property
    def people(self) -> tuple[Named, ...]:
        """Who was named; where somebody of a name was, does not tell who it is."""
        people = self.as_named("goal", "source", "walk", "person", "found", "quoted", "about", sorts=_PEOPLE)
        return tuple(
            replace(one, of=replace(one.of, relation=None)) if one.of.sort == "name" else one
            for one in people
        )

    @property
    def walks(self) -> list[Nominal]:
        """Where the robot walked to."""
        return [one.of for one in self.as_named("walk")]

    def source_of(self, root: int) -> Nominal | None:
        """Where a thing was taken from."""
        sources = [one.of for one in self.as_named("source", "taken") if one.task == root]
        return sources[-1] if sources else None

    def standing_open(self) -> dict[Nominal, int]:
        """What was opened and not closed since, by the task that opened it."""
        found: dict[Nominal, int] = {}
        for index, step in enumerate(self.steps):
            for one in self.things:
                if one.task == step.root and step.command.action == "close":
                    found.pop(one.of, None)
                elif one.task == step.root and step.command.action == "open":
                    found[one.of] = index
        return found

    def same_kind(self, of: Nominal) -> Nominal:
        """With the kind of what was handled before, for "the blue one"."""
        if not of.anaphoric:
            return of
        if self.kind is None and (self.places or self.people):
            raise ask("which one is meant?")  # "point at the table and at the white one"
        return of if self.kind is None else replace(of, kind=self.kind.kind, sort=self.kind.sort)

    def naming(self, of: Any, role: Role, task: int | None = None) -> Discourse:
        """With something named, to whom it belongs and where it is.

        Args:
            of: What was named; anything but a noun and a relation to one changes nothing.
            role: As what.
            task: The task that first acts on the same thing; the next one by default.

        Raises:
            UnresolvedError: It is called as something else was before: "the blocks", "the box".
        """
        if isinstance(of, Relative):
            return self.naming(of.to, role, task)
        if not isinstance(of, Nominal) or (of.reference and role != "taken"):
            return self
        of = self.same_kind(of)
        self._called_apart(of)
        placed = of.kind is not None and of.relation is not None and not of.is_place
        named = Named(of, role, self.clause, len(self.steps) if task is None else task)
        told = replace(self, named=(*self.named, named), kind=of if placed else self.kind)
        told = told if role == "about" else told.naming(of.owner, "about", task)
        return told.naming(of.relation, "beside", task)

    def acting_on(self, of: Nominal | None, root: int) -> Discourse:
        """With the thing of a task, which is named anew, or which a task acted on before."""
        if of is not None:
            return replace(self.naming(of, "object"), kind=of if of.kind is not None else self.kind)
        again = [replace(one, clause=self.clause) for one in self.things if one.task == root]
        return replace(self, named=(*self.named, *again[:1]))

    def walking(self, to: Nominal | Relative | None) -> Discourse:
        """With where the robot goes; a thing there is "it" when nothing was handled before."""
        if isinstance(to, Relative):
            return self.naming(to, "beside")
        first = all(self.steps[one.task].command.action == "walk_to" for one in self.things)
        is_it = to is not None and to.sort == "thing" and to.is_single and first
        return (self.naming(to, "object") if is_it else self).naming(to, "walk")

    def _called_apart(self, of: Nominal) -> None:
        for one in self.named:
            if one.of.kind != of.kind or of.sort not in _TOLD_APART or one.of.anaphoric or of.anaphoric:
                continue
            if of.is_place and one.clause != self.clause:
                continue  # "go to the bin, ... throw it in the trash"
            first, second = one.of.said, of.said
            words, others = set(first.split()), set(second.split())
            stem = max(min(len(first), len(second)) - 2, 3)
            if not (words <= others or others <= words or first[:stem] == second[:stem]):
                raise ask(f"{first!r} and {second!r} are both called {of.kind!r}: which is which?")
