"""From clauses to commands: what every word stands for, and the tasks that come of it."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import fields, replace
from typing import Any

from executive.language.phrases.handled_thing import PREVIOUS
from executive.language.phrases.values import SEATS, Bundle, Clause, Draft, Nominal, Relative, Trouble
from executive.language.resolve.discourse import Entity, UnresolvedError, ask, is_them
from executive.language.resolve.done_already import DoneAlready
from executive.language.resolve.its_door import ItsDoor
from executive.language.resolve.ranked import Ranked
from executive.language.resolve.repeated_nouns import PUTS_DOWN
from executive.language.resolve.stated_things import StatedThings
from executive.language.resolve.task_types import TYPES, task_type
from executive.meaning import Command
from trees.tasks import ObjectOf, RelationKind, WalkToTask

__all__ = ["Resolver", "UnresolvedError"]

_TAKES_SEVERAL = frozenset(
    name for name, kind in TYPES.items() if any(field.name == "count" for field in fields(kind))
)
"""Actions that may be done to several things at once."""

_ASIDE = frozenset(
    {"there_are", "again", "stays", "holds", "out", "tells", "watches", "inside", "looks_in", "together"}
    | {
        "done",
        "condition",
        "late",
        "lifts",
        "reaches",
        "reports",
        "one_of",
        "stated",
        "sets_speed",
        "by_anyone",
    }
)
"""Slots of a draft that are no slots of a task: how it was said."""


def _is_movable(place: Any) -> bool:
    """Whether something was put into or onto a thing that could be carried on with it."""
    return isinstance(place, Nominal) and place.sort in ("thing", "any") and place.reference is None


def _is_unsaid(person: Any) -> bool:
    """Whether nobody is said to get it: "bring the cup"."""
    return isinstance(person, Nominal) and person.reference == "asker"


def _is_everything(one: Draft) -> bool:
    """Whether it is done to "everything", and nobody says where that is."""
    thing = one.get("object")
    bare = isinstance(thing, Nominal) and thing.sort == "any" and thing.kind is None and thing.is_plain
    return bare and thing.count == "all" and one.get("source") is None


def _is_only_lifted(one: Draft) -> bool:
    """Whether nothing is said of picking a thing up that may not be so once it is held."""
    return all(one.get(slot) is None for slot in ("hand", "source", "holds"))


class Resolver(StatedThings, Ranked, ItsDoor, DoneAlready):
    """Turns clauses into commands, remembering what was named.

    Args:
        people_in: Who is named in words that are to be said.
        remembers: Whether "back" may be where a thing was before it was picked up, wherever that was.
    """

    def __init__(
        self, people_in: Callable[[str], Sequence[Nominal]] = lambda _text: (), remembers: bool = False
    ) -> None:
        super().__init__()
        self._people_in, self._remembers = people_in, remembers

    def commands(self, clauses: Sequence[Clause]) -> tuple[Command, ...]:
        """The commands, in order.

        Raises:
            UnresolvedError: Something that is referred to is missing or not clear.
        """
        for self._clause, clause in enumerate(clauses):
            if clause.mention is not None and self._mention is not None:
                raise ask("which of them is meant?")
            self._mention = clause.mention or self._mention
            self._said_before, self._said_first = clause.said_before, clause.said_first
            self._said_late |= {self._clause} if clause.said_before else set()
            for named in (*clause.about, *clause.said_before):
                self._name_place(named)
            self._stated += clause.about if not clause.bundles else ()
            self._doubt_for_whom(clause.about if not clause.bundles else ())
            for bundle in clause.bundles:
                for each in self._spread(self._with_mention(bundle)):
                    self._bundle(each, clause.text)
        if self._mention is not None or not self._commands:
            raise UnresolvedError(Trouble("something is stated that no task follows from"))
        self._doubt_another()
        self._doubt_several_found()
        return tuple(self._commands)

    def description(self, nominal: Nominal) -> Any:
        """A nominal that refers to nothing else, as the value of a slot.

        Raises:
            UnresolvedError: It does.
        """
        return self._description(self._same_kind(nominal))

    def _spread(self, bundle: Bundle) -> Iterator[Bundle]:
        """One bundle for each thing or person that "them" stands for."""
        person = bundle[0].get("person")
        if is_them(person) and bundle[0].action in ("wave", "say"):
            people = self._together(person.said)
            yield from ((bundle[0].replacing("person", one),) for one in people or (person,))
            return
        thing = bundle[0].get("object")
        if not isinstance(thing, Nominal) or thing.reference != "them":
            yield bundle
            return
        recent = self._recent(lambda entity: entity.of.sort in ("thing", "any"))
        self._no_animal(recent)
        first = bundle[0]
        people = self._together(thing.said) or (() if thing.said == "both" else (thing,))
        if not recent and self._people and people and first.action in ("look_at", "point_at"):
            slots = tuple(("person" if name == "object" else name, value) for name, value in first.slots)
            for one in people:  # "find a person and look at them"
                yield (replace(first, slots=slots).replacing("person", one), *bundle[1:])
            return
        roots = list(dict.fromkeys(entity.task for entity in recent))
        if len(roots) == 1 and recent[0].of.is_single and first.action in PUTS_DOWN:
            recent = self._all_in_the_hands()
            roots = [entity.task for entity in recent]
        if not roots or (len(roots) == 1 and recent[0].of.is_single):
            raise ask("what does 'them' stand for?")
        if thing.said == "both":
            counts = {entity.task: entity.of.count for entity in recent}
            if list(counts.values()) not in ([1, 1], [2], ["both"]):
                raise ask("which two are meant?")
        if first.action == "find" and any(self._commands[root].action == "count" for root in roots):
            raise ask("which of them shall be found?")  # "count the cups and find them"
        for root in roots:
            first, *rest = bundle
            yield (first.replacing("object", ObjectOf(root)), *rest)

    def _bundle(self, bundle: Bundle, text: str) -> None:
        if self._is_given_just_now(bundle):
            return  # "give me the cup and bring it to me"
        last: Any = None
        for each in self._ranked_alike(bundle):
            one = each
            if one.get("fetched"):
                one, held = self._fetched(one)
                if held is not None and held.task in self._given and one.get("source") is None:
                    self._take_back(held.task)  # "give me the cup and bring it to Ana"
                if held is not None and held.task in self._held and one.get("source") is None:
                    last = held
                    continue
            if one.get("object") == PREVIOUS:
                one = one.replacing("object", last)
            last = self._task(one, text)

    def _fetched(self, one: Draft) -> tuple[Draft, ObjectOf | None]:
        """A thing that is brought somewhere, and what it is if it was named before."""
        one = replace(one, slots=tuple(slot for slot in one.slots if slot[0] != "fetched"))
        thing = one.get("object")
        meant = self._held_as(thing, one.get("source")) if isinstance(thing, Nominal) else thing
        if meant is None and thing.reference:
            meant = self._carried(thing)
        if meant is None:
            meant = self._same_thing(one, thing)
        return (one, None) if meant is None else (one.replacing("object", meant), meant)

    def _carried(self, thing: Nominal) -> Any:
        """What "it" is that is brought somewhere: not another one than what is in the hand.

        Raises:
            UnresolvedError: It may be.
        """
        meant = self._it(thing, "pick")
        if isinstance(meant, Nominal):
            raise ask("what does 'it' stand for?")  # "pick up the cup after bringing me"
        if self._held and isinstance(meant, ObjectOf) and meant.task not in self._held:
            raise ask("which of them does 'it' stand for?")
        return meant

    def _task(self, one: Draft, text: str) -> ObjectOf:
        """Make a command of a draft, unless it is done already; returns what it is done to."""
        if one.get("one_of") is not None:  # "find some cups", which only counting them makes clear
            raise UnresolvedError(Trouble(one.get("one_of"), asks=True, rivals=True))
        if one.get("done") and (before := self._ordered_before(one)) is not None:
            return before
        named, resolved = self._object_of(one)
        root = resolved.task if isinstance(resolved, ObjectOf) else len(self._commands)
        if one.action == "pick" and root in self._held and named is None and _is_only_lifted(one):
            if self._thing_walked_to is not None:
                raise ask("which of them does 'it' stand for?")
            return ObjectOf(root)  # "grasp it and lift it"
        if one.get("lets_go"):
            return self._let_go(root)
        if one.action in PUTS_DOWN and root in self._given:
            self._take_back(root)
        if one.action == "pick" and named is not None and (held := self._in_the_hand(one, named)) is not None:
            return held  # "grasp the cup, lift the cup"
        self._doubt(one, named, resolved, root)
        action, slots = self._slots(one, resolved, root)
        if one.get("out") and "source" not in slots and named is not None:
            slots.update(self._out_of(root))  # "open the fridge, take out the can"
        if "source" not in slots and named is not None:
            slots.update(self._seen_in(named, root, action))  # "look in the drawer and take the pen"
        if action == "count" and "source" not in slots and named is not None:
            slots.update(self._counted_in(named))  # "open the fridge and tell me how many eggs are left"
        if self._was_put_there(action, slots, root, stays=bool(one.get("stays"))):
            return ObjectOf(root)  # "carry it to the hall and leave it there"
        if isinstance(slots.get("object"), str):
            told = f"{slots['object']!r} is a person, and nothing to {action}"
            raise UnresolvedError(Trouble(told, slots["object"]))
        if self._is_done_already(action, slots):
            return ObjectOf(root)  # "come, stand next to me"
        self._doubt_done(one)
        self._doubt_stated(one, root)
        self._note_object(named, resolved)
        if action == "walk_to":
            self._note_walk(one.get("to"))
            self._walked_together = one.get("together") or ()
        self._commands.append(task_type(action)(text, **slots))
        self._note_hand(action, root)
        self._did.append((one, root))
        return ObjectOf(root)

    def _object_of(self, one: Draft) -> tuple[Nominal | None, Any]:
        """The thing of a task: what was named anew, if it was, and the value of the slot."""
        thing = one.get("object")
        if not isinstance(thing, Nominal):
            return None, thing
        if one.get("inside"):
            return None, self._looked_into()
        if thing.is_bare_one:
            raise ask("which object is meant?")
        if thing.reference:
            meant = self._it(thing, one.action, one.get("source"))
            return (meant, self._description(meant)) if isinstance(meant, Nominal) else (None, meant)
        before = self._still_there(one, thing, self._that(thing)) or self._put_down_so(one, thing)
        if isinstance(before, ObjectOf):
            return None, before
        self._not_what_is_filled(one, thing)
        thing = self._door_of_what(before or thing, one.action)
        if isinstance(thing, ObjectOf):
            return None, thing
        if thing.anaphoric and one.action in ("open", "close"):
            thing = self._another_door(thing, one.action)
        named = self._same_kind(thing)
        if _is_everything(one) and self._recent(lambda entity: entity.of.sort == "thing"):
            raise ask("all that was named, or everything there is?")
        self._only_one(thing, one.action)
        if thing.anaphoric:
            self._only_kind(one.of for one in self._recent(lambda entity: entity.of.sort == "thing"))
        self._kind = named if named.kind is not None else self._kind
        return named, self._description(named)

    def _slots(self, one: Draft, resolved: Any, root: int) -> tuple[str, dict[str, Any]]:
        """The action of a task, which a place that was named before may decide, and its slots."""
        slots: dict[str, Any] = {}
        for name, value in one.slots:
            if name in _ASIDE:
                continue
            if name == "object":
                slots["object"] = resolved
            elif name == "count" and isinstance(resolved, ObjectOf):
                continue  # "the two cups, ... the cups": as many as there were
            elif name == "there":
                slots.update(self._there(value, root))
            elif name == "source":
                slots["source"] = self._source(value, root)
            elif name in ("to", "on"):
                slots[name] = self._goal(one.action, value, root)
            elif name in ("person", "of"):
                slots[name] = self._whom(one, value)
            elif name == "text":
                slots["words"] = value
            else:
                slots[name] = value
        if "count" in slots and one.action not in _TAKES_SEVERAL:
            raise ask("which one is meant?")  # "there are two cups on the table, look at them"
        if one.action == "find" and one.get("person") is not None and one.get("source") is not None:
            self._found_somebody(one.get("person"), one.get("source"))
        self._people += self._people_in(slots.get("words", ""))  # "her" who is told is none of them
        return slots.pop("action", one.action), slots

    def _whom(self, one: Draft, value: Nominal) -> Any:
        """Who is meant; several people are only looked for."""
        if one.get("count") is None:
            return self._person(value, anew=one.get("source") is not None)
        self._name_place(value)
        return self._description(value)

    def _found_somebody(self, person: Nominal, place: Nominal) -> None:
        """Remember where somebody is who is told by that alone: "a person in the kitchen", then "them"."""
        if (
            person.sort != "person"
            or person.count != 1
            or person.relation is not None
            or place.reference
            or not place.is_place
        ):
            return
        kind: RelationKind = "in" if place.sort == "room" else "on" if place.kind in SEATS else "next_to"
        relation = Relative(kind, place)
        self._people = [replace(one, relation=relation) if one == person else one for one in self._people]

    def _source(self, value: Any, root: int) -> Any:
        place = self._only_place(value, root) if value.reference == "there" else self._inside_or_before(value)
        self._sources[root] = place
        source = self._place(place, root)
        if not isinstance(source, ObjectOf):
            self._name_place(place)
        return source

    def _inside_or_before(self, place: Any) -> Any:
        return self._shelf_of_what_is_open(self._as_before(place))

    def _goal(self, action: str, said: Any, root: int) -> Any:
        value = self._inside_or_before(said)
        if value is not said and value == self._sources.get(root):
            raise ask(f"the same {value.kind}, or another one?")  # "from the big table ... on the table"
        if action == "walk_to":
            goal = self._walk(value)
        elif action == "hand_over" and is_them(value):
            goal = self._person(value)
        else:
            goal = self._place(value, root, into=action == "put_in")
        if action == "hand_over" and _is_unsaid(value):
            self._unsaid_giving = (len(self._commands), root)
        if not isinstance(goal, ObjectOf):
            self._name_place(value)
        if action in ("place", "put_in") and _is_movable(value):
            self._put_to = (self._clause, value)
        self._not_at_itself(goal, root)
        return goal

    def _note_object(self, named: Nominal | None, resolved: Any) -> None:
        """Remember what the next command acts on."""
        if named is not None:
            self._entities.append(Entity(len(self._commands), self._clause, named))
            if named.is_place:
                self._name_place(named)
        elif isinstance(resolved, ObjectOf):
            self._again(resolved.task)

    def _note_walk(self, to: Any) -> None:
        """Remember a thing that is walked to: "it", when nothing is handled before."""
        if not isinstance(to, Nominal) or to.sort != "thing" or to.reference:
            return
        self._thing_walked_to = to
        handled = any(not isinstance(self._commands[one.task], WalkToTask) for one in self._entities)
        if to.is_single and to.count == 1 and not handled:
            self._entities.append(Entity(len(self._commands), self._clause, to))

    def _note_hand(self, action: str, root: int) -> None:
        """Remember what is in the hand and what was given away."""
        if action == "pick":
            self._held.append(root)
            self._given.discard(root)
        elif action in PUTS_DOWN and root in self._held:
            self._held.remove(root)
        if action == "hand_over":
            self._given.add(root)
