"""What "it", "them", "there", "back", "her" and "the other one" stand for, and the tasks that come of it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any

from executive.language.handling import PREVIOUS
from executive.language.phrases import Bundle, Clause, Draft, Mention, Nominal, Relative, Trouble, Where
from executive.meaning import Command, StopCommand
from trees import tasks
from trees.tasks import ObjectDescription, ObjectOf

_TYPES: dict[str, Any] = {
    "pick": tasks.PickTask,
    "place": tasks.PlaceTask,
    "put_in": tasks.PutInTask,
    "hand_over": tasks.HandOverTask,
    "open": tasks.OpenTask,
    "close": tasks.CloseTask,
    "walk_to": tasks.WalkToTask,
    "move": tasks.MoveTask,
    "wave": tasks.WaveTask,
    "point_at": tasks.PointAtTask,
    "look_at": tasks.LookAtTask,
    "find": tasks.FindTask,
    "count": tasks.CountTask,
    "describe": tasks.DescribeTask,
    "say": tasks.SayTask,
    "wait": tasks.WaitTask,
    "go_home": tasks.GoHomeTask,
    "stop": StopCommand,
}
_OPENED = ("container", "door")
_PUTS_DOWN = ("place", "put_in", "hand_over")
_MOVES = ("pick", *_PUTS_DOWN)
_NAMED = ("thing", "furniture", "container")
_AT_A_PLACE = frozenset({"pick", "place", "put_in", "hand_over", "find", "count", "describe"})


class UnresolvedError(Exception):
    """A word that stands for nothing, or for one of several things."""

    def __init__(self, trouble: Trouble) -> None:
        self.trouble = trouble
        super().__init__(trouble.message)


def _ask(message: str, choices: Iterable[str] = ()) -> UnresolvedError:
    return UnresolvedError(Trouble(message, asks=True, choices=tuple(choices)))


@dataclass(frozen=True, slots=True)
class _Entity:
    """Something that a task acts on; ``clause`` counts the clauses."""

    task: int
    clause: int
    of: Nominal


def _is_movable(place: Any) -> bool:
    """Whether something was put into or onto a thing that could be carried on with it."""
    return isinstance(place, Nominal) and place.sort in ("thing", "any") and place.reference is None


def _any(_entity: _Entity) -> bool:
    return True


class Resolver:
    """Turns clauses into commands, remembering what was named."""

    def __init__(self) -> None:
        self._commands: list[Command] = []
        self._entities: list[_Entity] = []
        self._places: list[Nominal] = []
        self._walks: list[Nominal] = []
        self._people: list[Nominal] = []
        self._sources: dict[int, Nominal] = {}
        self._held: list[int] = []
        self._given: set[int] = set()
        self._mentioned: list[Nominal] = []
        self._put_to: tuple[int, Nominal] | None = None
        self._kind: Nominal | None = None
        self._mention: Mention | None = None
        self._called: dict[str, str] = {}
        self._placed: dict[int, tuple[str, Any, Any]] = {}
        self._clause = 0

    def commands(self, clauses: Sequence[Clause]) -> tuple[Command, ...]:
        """The commands, in order.

        Raises:
            UnresolvedError: Something that is referred to is missing or not clear.
        """
        for self._clause, clause in enumerate(clauses):
            if clause.mention is not None and self._mention is not None:
                raise _ask("which of them is meant?")
            self._mention = clause.mention or self._mention
            for bundle in clause.bundles:
                for each in self._spread(self._with_mention(bundle)):
                    self._bundle(each, clause.text)
        if self._mention is not None:
            raise UnresolvedError(Trouble("something is stated that no task follows from"))
        return tuple(self._commands)

    def _with_mention(self, bundle: Bundle) -> Bundle:
        """With what a statement named in place of the first "it" or "them": "a cup is there; take it"."""
        first, *rest = bundle
        thing = first.get("object")
        if self._mention is None:
            return bundle
        stated, self._mention = self._mention, None
        of = stated.of
        pronoun = "it" if of.is_single else "them"
        takes_place = first.action in _AT_A_PLACE or stated.source is None
        if not isinstance(thing, Nominal) or thing.reference != pronoun or not takes_place:
            raise _ask("what has the statement to do with the task?")
        if self._commands or first.get("source") is not None:
            raise _ask(f"what does {pronoun!r} stand for?")
        first = _replaced(first, "object", of).with_slot("source", stated.source)
        return (first if of.count == 1 else first.with_slot("count", of.count), *rest)

    def description(self, nominal: Nominal) -> Any:
        """A nominal that refers to nothing else, as the value of a slot.

        Raises:
            UnresolvedError: It does.
        """
        return self._description(self._same_kind(nominal))

    def _spread(self, bundle: Bundle) -> Iterator[Bundle]:
        """One bundle for each thing that "them" stands for."""
        thing = bundle[0].get("object")
        if not isinstance(thing, Nominal) or thing.reference != "them":
            yield bundle
            return
        recent = self._recent(lambda entity: entity.of.sort in ("thing", "any"))
        roots = list(dict.fromkeys(entity.task for entity in recent))
        if not roots or (len(roots) == 1 and recent[0].of.is_single):
            raise _ask("what does 'them' stand for?")
        for root in roots:
            first, *rest = bundle
            yield (_replaced(first, "object", ObjectOf(root)), *rest)

    def _bundle(self, bundle: Bundle, text: str) -> None:
        last: Any = None
        for one in bundle:
            if one.get("fetched"):
                one = replace(one, slots=tuple(slot for slot in one.slots if slot[0] != "fetched"))
                thing = one.get("object")
                if isinstance(thing, ObjectOf) or thing.reference:
                    last = thing if isinstance(thing, ObjectOf) else self._it(thing, one.action)
                    if last.task in self._held and one.get("source") is None:
                        continue
                    one = _replaced(one, "object", last)
            if one.get("object") is PREVIOUS or one.get("object") == PREVIOUS:
                one = _replaced(one, "object", last)
            last = self._task(one, text)

    def _task(self, one: Draft, text: str) -> Any:
        index = len(self._commands)
        thing = one.get("object")
        resolved: Any = None
        named: Nominal | None = None
        if isinstance(thing, Nominal):
            if thing.reference:
                resolved = self._it(thing, one.action)
                named = resolved if isinstance(resolved, Nominal) else None
                resolved = resolved if named is None else self._description(named)
            else:
                named = self._same_kind(thing)
                self._kind = named if named.kind is not None else self._kind
                resolved = self._description(named)
        elif isinstance(thing, ObjectOf):
            resolved = thing
        root = resolved.task if isinstance(resolved, ObjectOf) else index
        if one.action == "pick" and root in self._held:
            raise UnresolvedError(Trouble("what is named is in the hand already", None))
        slots: dict[str, Any] = {}
        if one.get("there_are") and one.get("source") is None and self._places:
            raise _ask("only there, or in all that is in view?", [f"the {self._places[-1].kind}"])
        for name, value in one.slots:
            if name == "there_are":
                continue
            if name == "object":
                slots["object"] = resolved
            elif name == "there":
                slots.update(self._there(value, root))
            elif name == "source":
                place = self._only_place(value, root) if value.reference == "there" else value
                self._sources[root] = place
                slots["source"] = self._place(place, root)
                self._name_place(place)
            elif name in ("to", "on"):
                into = one.action == "put_in"
                slots[name] = (
                    self._walk(value)
                    if one.action == "walk_to"
                    else self._person(value)
                    if one.action == "hand_over" and _is_them(value)
                    else self._place(value, root, into=into)
                )
                self._name_place(value)
                if one.action in ("place", "put_in") and _is_movable(value):
                    self._put_to = (self._clause, value)
            elif name == "person":
                slots["person"] = self._person(value)
            elif name == "text":
                slots["words"] = value
            else:
                slots[name] = value
        action = slots.pop("action", one.action)
        if action in ("place", "put_in"):
            goal = (action, slots.get("on"), slots.get("to"))
            before = self._placed.get(root)
            if before is not None and root not in self._held and goal in (before, ("place", None, None)):
                return ObjectOf(root)  # "carry it to the hall and leave it there": it is there already
            self._placed[root] = goal
        if isinstance(slots.get("object"), str):
            raise UnresolvedError(
                Trouble(f"{slots['object']!r} is a person, and nothing to {action}", slots["object"])
            )
        self._commands.append(_TYPES[action](text, **slots))
        if named is not None:
            self._entities.append(_Entity(index, self._clause, named))
            if named.is_place:
                self._name_place(named)
        elif isinstance(resolved, ObjectOf):
            self._again(resolved.task)
        if action == "pick":
            self._held.append(root)
            self._given.discard(root)
        elif action in _PUTS_DOWN and root in self._held:
            self._held.remove(root)
        if action == "hand_over":
            self._given.add(root)
        return ObjectOf(root)

    def _again(self, root: int) -> None:
        entity = next((one for one in self._entities if one.task == root), None)
        if entity is not None:
            self._entities.append(replace(entity, clause=self._clause))

    # ---- things

    def _recent(self, fits: Any, excluded: int | None = None) -> list[_Entity]:
        """What fits among the things of the latest clause that has any."""
        fitting = [entity for entity in self._entities if fits(entity) and entity.task != excluded]
        if not fitting:
            return []
        latest = max(entity.clause for entity in fitting)
        unique = {entity.task: entity for entity in fitting if entity.clause == latest}
        return list(unique.values())

    def _it(self, nominal: Nominal, action: str) -> Any:
        if nominal.reference == "this":
            raise _ask("which one is meant?")
        if nominal.reference == "him" or nominal.is_person:
            raise _ask("who or what is meant?")
        if action in ("open", "close"):
            return self._opened()
        recent = self._recent(lambda entity: entity.of.sort in ("thing", "any"))
        if not recent and action in ("look_at", "point_at", "find", "describe"):
            recent = self._recent(_any)
        if not recent:
            raise _ask("what does 'it' stand for?")
        if nominal.reference == "them":
            raise _ask("what does 'them' stand for?")
        if len(recent) > 1:
            raise _ask("which of them does 'it' stand for?", [f"the {entity.of.kind}" for entity in recent])
        root = recent[0].task
        if self._put_to is not None and self._put_to[0] == recent[0].clause and action in _MOVES:
            names = [f"the {one.kind}" for one in (recent[0].of, self._put_to[1])]
            raise _ask("which of them does 'it' stand for?", names)
        if action in _PUTS_DOWN and self._held and root not in self._held:
            raise _ask("which of them does 'it' stand for?")
        if action in _PUTS_DOWN and root in self._given:
            raise _ask("it is given away by then: shall it be taken back first?")
        if recent[0].of.count != 1:
            raise _ask("which of them does 'it' stand for?")
        return ObjectOf(root)

    def _opened(self) -> Any:
        """What is opened or closed: a door that a task acts on, or the only one that was named."""
        recent = self._recent(lambda entity: entity.of.sort in _OPENED)
        places = list(dict.fromkeys(place for place in self._places if place.sort in _OPENED))
        named = [place for place in places if place not in [entity.of for entity in recent]]
        if len(recent) == 1 and not named:
            return ObjectOf(recent[0].task)
        if not recent and len(places) == 1:
            return places[0]
        raise _ask("what does 'it' stand for?")

    def _inner(self, excluded: int, *, into: bool) -> Any:
        """A reference inside a place: "in it", "next to it"."""

        def fits(entity: _Entity) -> bool:
            return (
                entity.of.sort in ("thing", "any")
                or (entity.of.sort == "container" and into)
                or entity.of.is_place
            )

        recent = self._recent(fits, excluded)
        places = [
            place
            for place in self._places
            if (place.sort == "container" if into else place.sort in ("furniture", "container"))
        ]
        if into:
            recent = [entity for entity in recent if entity.of.sort in ("container", "thing", "any")]
        roots = [entity.of for entity in recent]
        others = [place for place in dict.fromkeys(places) if place not in roots]
        if len(recent) != 1 or others or self._mentioned:
            if not recent and len(others) == 1:
                return self._destination(others[0])
            raise _ask("what does 'it' stand for?")
        if recent[0].task in self._held:
            raise _ask("what does 'it' stand for?")
        return ObjectOf(recent[0].task)

    def _same_kind(self, nominal: Nominal) -> Nominal:
        """With the kind of what was named before, for "the blue one"."""
        if not nominal.anaphoric:
            return nominal
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
        before = self._called.setdefault(nominal.kind, nominal.said)
        if not _is_one_name(before, nominal.said):
            raise _ask(f"{before!r} and {nominal.said!r} are both called {nominal.kind!r}: which is which?")

    def _description(self, nominal: Nominal) -> Any:
        self._note_name(nominal)
        if nominal.sort == "name":
            return nominal.kind
        relation = nominal.relation
        resolved = None
        if relation is not None:
            if nominal.kind is not None and not nominal.is_place:
                self._kind = nominal
            resolved = tasks.Relation(relation.kind, self._related(relation.to))
        return ObjectDescription(
            kind=nominal.kind,
            color=nominal.color,
            name=nominal.name,
            size=nominal.size,
            material=nominal.material,
            ordinal=nominal.ordinal,
            relation=resolved,
        )

    def _related(self, nominal: Nominal) -> Any:
        return self._beside(nominal, -1)

    def _beside(self, nominal: Nominal, root: int) -> Any:
        """What a relation is to: a thing rather than the furniture that it stands on."""
        if nominal.reference == "it":
            recent = self._recent(lambda entity: entity.of.sort in ("thing", "any"), root)
            if len(recent) == 1 and not self._mentioned:
                return ObjectOf(recent[0].task)
        return self._place(nominal, root)

    # ---- places

    def _destination(self, nominal: Nominal) -> Any:
        """A place, a person or a thing as the value of a slot."""
        named = self._same_kind(nominal)
        if named.sort in ("me", "you", "name"):
            return named.kind
        if named.count != 1 or (named.plural and not named.reference):
            raise UnresolvedError(Trouble(f"several places at once ({named.kind!r}): name one", named.kind))
        if named.is_place and named.is_plain:
            self._note_name(named)
            return named.kind
        if named.sort == "person" and named.relation is not None:
            plain = replace(named, relation=None).is_plain
            if (
                named.relation.kind == "in_front_of"
                and named.relation.to.sort == "you"
                and plain
                and named.kind == "person"
            ):
                return "in_front"
        if named.sort == "any" and named.kind is None and named.is_plain:
            raise _ask("which one is meant?")
        if named.sort in ("thing", "any"):
            self._mentioned.append(named)
        return self._description(named)

    def _place(self, value: Any, root: int, *, into: bool = False) -> Any:
        if isinstance(value, Relative):
            relation = tasks.Relation(value.kind, self._beside(value.to, root))
            return ObjectDescription(relation=relation)
        if value.reference == "him":
            return self._person(value)
        if value.reference == "asker":
            if self._people:
                raise _ask("to whom?", ["me", *(f"{person.kind}" for person in dict.fromkeys(self._people))])
            return value.kind
        if value.reference == "there":
            return self._there_place(value, root)
        if value.reference in ("it", "previous"):
            return self._inner(root, into=into)
        if value.reference:
            raise _ask("which place is meant?")
        return self._destination(value)

    def _name_place(self, value: Any) -> None:
        if isinstance(value, Nominal) and value.is_place and not value.reference:
            self._places.append(value)
        if isinstance(value, Nominal) and value.sort in ("person", "name") and not value.reference:
            self._people.append(value)

    def _there_place(self, value: Nominal, root: int) -> Any:
        if value.name == "back":
            source = self._sources.get(root)
            if source is None:
                raise _ask("where shall it be put back to?")
            return self._destination(source)
        return self._destination(self._only_place(value, root))

    def _only_place(self, value: Nominal, root: int) -> Nominal:
        """The one place that was named and that the thing is not at already."""
        if value.name == "back":
            raise _ask("which place is meant?")
        held_at = self._sources.get(root)
        places = [place for place in dict.fromkeys(self._places) if place != held_at]
        if len(places) != 1:
            raise _ask("which place does 'there' stand for?", [f"the {place.kind}" for place in places])
        return places[0]

    def _there(self, where: Where, root: int) -> dict[str, Any]:
        """Slots of a place task whose place was named before."""
        if where.of.name == "back":
            place = self._sources.get(root)
        else:
            known = [place for place in dict.fromkeys(self._places) if place != self._sources.get(root)]
            place = known[0] if len(known) == 1 else None
        value = self._there_place(where.of, root)
        if place is not None and place.sort in ("thing", "any"):
            raise _ask(f"into the {place.kind}, or on it?")
        if place is not None and place.sort == "container":
            return {"action": "put_in", "to": value}
        return {"to": value} if place is not None and place.sort == "room" else {"on": value}

    def _walk(self, value: Any) -> Any:
        if isinstance(value, Nominal) and value.reference == "there" and value.name == "back":
            if len(self._walks) != 1:
                raise _ask(
                    "back to where?", ["the start", *(f"the {place.kind}" for place in self._walks[:-1])]
                )
            self._walks.append(Nominal("room", "start"))
            return "start"
        if isinstance(value, Nominal) and value.reference in ("it", "them"):
            recent = self._recent(_any)
            if len(recent) != 1:
                raise _ask("what does 'it' stand for?")
            return ObjectOf(recent[0].task)
        resolved = self._place(value, -1)
        if isinstance(value, Nominal):
            self._walks.append(value)
        return resolved

    # ---- people

    def _is_several(self) -> bool:
        """Whether some things were named that "them" may stand for."""
        return any(not entity.of.is_single for entity in self._entities)

    def _person(self, value: Nominal) -> Any:
        if value.reference == "him" or _is_them(value):
            people = list(dict.fromkeys(self._people))
            if len(people) != 1 or (_is_them(value) and self._is_several()):
                raise _ask("who is meant?", [str(person.kind) for person in people])
            return self._destination(people[0])
        if value.reference in ("it", "this"):
            raise _ask("who is meant?")
        if value.sort in ("person", "name"):
            self._people.append(value)
        return self._destination(value)


def _is_one_name(first: str, second: str) -> bool:
    """Whether two phrases are one word in two forms, or one is the other with more said: "kitchen table"."""
    one, other = first.split(), second.split()
    if set(one) <= set(other) or set(other) <= set(one):
        return True
    stem = min(len(first), len(second)) - 2
    return first[: max(stem, 3)] == second[: max(stem, 3)]


def _is_them(value: Any) -> bool:
    """Whether it says "them", which may be one person of whom no more is known."""
    return isinstance(value, Nominal) and value.reference == "them"


def _replaced(one: Draft, name: str, value: Any) -> Draft:
    return replace(one, slots=tuple((key, value if key == name else old) for key, old in one.slots))
