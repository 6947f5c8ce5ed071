"""What was named so far in a sentence, and what is held, given and put down by its tasks."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import Any

from executive.language.phrases.values import Draft, Mention, Nominal, Trouble
from executive.meaning import Command
from trees.tasks import FindTask

_NAMED = ("thing", "furniture", "container")


class UnresolvedError(Exception):
    """A word that stands for nothing, or for one of several things."""

    def __init__(self, trouble: Trouble) -> None:
        self.trouble = trouble
        super().__init__(trouble.message)


def ask(message: str, choices: Iterable[str] = ()) -> UnresolvedError:
    """A question about what a word stands for."""
    return UnresolvedError(Trouble(message, asks=True, choices=tuple(choices)))


@dataclass(frozen=True, slots=True)
class Entity:
    """Something that a task acts on; ``clause`` counts the clauses."""

    task: int
    clause: int
    of: Nominal

    @property
    def is_several(self) -> bool:
        """Whether nobody would call it "it": "the cups", "both cups", but not "the scissors", "all fruit"."""
        if self.of.mass and self.of.count == "all":
            return False
        return self.of.count != 1 or (self.of.plural and not self.of.paired)


class Discourse:
    """What a sentence has named and done up to some word."""

    def __init__(self) -> None:
        self._commands: list[Command] = []
        self._did: list[tuple[Draft, int]] = []
        self._entities: list[Entity] = []
        self._places: list[Nominal] = []
        self._named_in: list[tuple[int, Nominal]] = []
        self._beside_places: list[Nominal] = []
        self._walks: list[Nominal] = []
        self._walked_together: tuple[Nominal, ...] = ()
        self._thing_walked_to: Nominal | None = None
        self._people: list[Nominal] = []
        self._people_named_in: dict[Nominal, int] = {}
        self._sources: dict[int, Nominal] = {}
        self._held: list[int] = []
        self._given: set[int] = set()
        self._unsaid_giving: tuple[int, int] | None = None
        self._mentioned: list[Nominal] = []
        self._mentioned_in: list[tuple[int, Nominal]] = []
        self._put_to: tuple[int, Nominal] | None = None
        self._kind: Nominal | None = None
        self._mention: Mention | None = None
        self._stated_at: Nominal | None = None
        self._it_beside: tuple[int, int] | None = None
        self._called: dict[str, tuple[int, str]] = {}
        self._whose: dict[Nominal, str] = {}
        self._placed: dict[int, tuple[str, Any, Any]] = {}
        self._said_before: tuple[Nominal, ...] = ()
        self._said_first = False
        self._said_late: set[int] = set()
        self._stated: list[Nominal] = []
        self._stated_to_go: dict[int, int] = {}
        self._clause = 0
        self._remembers = False

    def _again(self, root: int) -> None:
        entity = next((one for one in self._entities if one.task == root), None)
        if entity is not None:
            self._entities.append(replace(entity, clause=self._clause))

    def _recent(self, fits: Any, excluded: int | None = None) -> list[Entity]:
        """What fits among the things of the latest clause that has any."""
        fitting = [entity for entity in self._entities if fits(entity) and entity.task != excluded]
        if not fitting:
            return []
        latest = max(entity.clause for entity in fitting)
        unique = {entity.task: entity for entity in fitting if entity.clause == latest}
        return list(unique.values())

    def _same_kind(self, nominal: Nominal) -> Nominal:
        """With the kind of what was named before, for "the blue one"."""
        if not nominal.anaphoric:
            return nominal
        if self._kind is None and (self._places or self._people):
            raise ask("which one is meant?")  # "point at the table and at the white one"
        if self._kind is None:
            return nominal
        return replace(nominal, kind=self._kind.kind, sort=self._kind.sort)

    def _note_name(self, nominal: Nominal) -> None:
        """Ask when two words that mean the same are used as if they told things apart: "the cube", "the box".

        Raises:
            UnresolvedError: They are.
        """
        if nominal.kind is None or nominal.anaphoric or nominal.sort not in _NAMED or not nominal.said:
            return
        if nominal.whose:
            whose = self._whose.setdefault(nominal, nominal.whose)
            if whose != nominal.whose:
                raise ask(f"'{whose} {nominal.said}' and '{nominal.whose} {nominal.said}': which is which?")
        clause, before = self._called.setdefault(nominal.kind, (self._clause, nominal.said))
        one_place = nominal.is_place and clause != self._clause  # "go to the bin, throw it in the trash"
        if not one_place and not _is_one_name(before, nominal.said):
            raise ask(f"{before!r} and {nominal.said!r} are both called {nominal.kind!r}: which is which?")

    def _name_place(self, value: Any) -> None:
        if isinstance(value, Nominal) and value.is_place and not value.reference:
            self._places.append(value)
            self._named_in.append((self._clause, value))
        if isinstance(value, Nominal) and value.sort in ("person", "name") and not value.reference:
            person = replace(value, relation=None) if value.sort == "name" else value
            self._people.append(person)
            self._people_named_in.setdefault(person, self._clause)

    def _together(self, said: str) -> tuple[Nominal, ...]:
        """All who were named, if "them" can be nobody else: in one breath, or two of whom it is "both".

        Who was named in words to say, or told by where he was found, is not among them.
        """
        people = tuple(dict.fromkeys(self._people))
        clauses = {self._people_named_in.get(one) for one in people}
        alone = None not in clauses and len(people) > 1 and all(one.is_single for one in people)
        together = len(people) == 2 if said == "both" else len(clauses) == 1
        return people if alone and together else ()

    def _was_search_for_several(self, task: int) -> bool:
        """Whether a task only looks for several things, so that none of them is chosen by it."""
        command = self._commands[task]
        return isinstance(command, FindTask) and command.count != 1

    def _is_several(self) -> bool:
        """Whether some things were named that "them" may stand for."""
        return any(not entity.of.is_single for entity in self._entities)


def _is_one_name(first: str, second: str) -> bool:
    """Whether two phrases are one word in two forms, or one is the other with more said: "kitchen table"."""
    one, other = first.split(), second.split()
    if set(one) <= set(other) or set(other) <= set(one):
        return True
    stem = min(len(first), len(second)) - 2
    return first[: max(stem, 3)] == second[: max(stem, 3)]


def is_them(value: Any) -> bool:
    """Whether it says "them", which may be one person of whom no more is known."""
    return isinstance(value, Nominal) and value.reference == "them"
