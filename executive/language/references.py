"""From clauses to commands: what every word stands for, and the tasks that come of it."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

from executive.language.antecedents import PUTS_DOWN, Antecedents
from executive.language.discourse import Entity, UnresolvedError, ask, is_them
from executive.language.handled_thing import PREVIOUS
from executive.language.phrases import Bundle, Clause, Draft, Nominal, Relative, Trouble
from executive.meaning import Command, StopCommand
from trees import tasks
from trees.tasks import ObjectOf

__all__ = ["Resolver", "UnresolvedError"]

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
_AT_A_PLACE = frozenset({"pick", "place", "put_in", "hand_over", "find", "count", "describe"})


def _is_movable(place: Any) -> bool:
    """Whether something was put into or onto a thing that could be carried on with it."""
    return isinstance(place, Nominal) and place.sort in ("thing", "any") and place.reference is None


def _is_beside_itself(thing: Nominal, one: Draft) -> bool:
    """Whether a thing goes to what is described in the very same words: "put the cup in the cup"."""
    goal = one.get("to") or one.get("on")
    goal = goal.to if isinstance(goal, Relative) else goal
    return isinstance(goal, Nominal) and thing.kind is not None and goal == thing


def _is_everything(one: Draft) -> bool:
    """Whether it is done to "everything", and nobody says where that is."""
    thing = one.get("object")
    bare = isinstance(thing, Nominal) and thing.sort == "any" and thing.kind is None and thing.is_plain
    return bare and thing.count == "all" and one.get("source") is None


def _is_there(place: Any) -> bool:
    """Whether a place was named before: "take it there"."""
    return isinstance(place, Nominal) and place.reference == "there"


class Resolver(Antecedents):
    """Turns clauses into commands, remembering what was named.

    Args:
        people_in: Who is named in words that are to be said.
    """

    def __init__(self, people_in: Callable[[str], Sequence[Nominal]] = lambda _text: ()) -> None:
        super().__init__()
        self._people_in = people_in

    def commands(self, clauses: Sequence[Clause]) -> tuple[Command, ...]:
        """The commands, in order.

        Raises:
            UnresolvedError: Something that is referred to is missing or not clear.
        """
        for self._clause, clause in enumerate(clauses):
            if clause.mention is not None and self._mention is not None:
                raise ask("which of them is meant?")
            self._mention = clause.mention or self._mention
            for named in clause.about:
                self._name_place(named)
            for bundle in clause.bundles:
                for each in self._spread(self._with_mention(bundle)):
                    self._bundle(each, clause.text)
        if self._mention is not None or not self._commands:
            raise UnresolvedError(Trouble("something is stated that no task follows from"))
        return tuple(self._commands)

    def _with_mention(self, bundle: Bundle) -> Bundle:
        """With what a statement named in place of the first "it" or "them": "a cup is there; take it"."""
        first, *rest = bundle
        thing = first.get("object")
        takes_place = first.action in _AT_A_PLACE
        if self._mention is None:
            another = isinstance(thing, Nominal) and thing.anaphoric and first.get("source") is None
            if self._stated_at is None or not another:
                return bundle
            if not takes_place:
                raise ask("what has the statement to do with the task?")
            return (first.with_slot("source", self._stated_at), *rest)
        stated, self._mention = self._mention, None
        of = stated.of
        if stated.state is not None:
            opposite = "close" if stated.state == "open" else "open"
            if self._commands or first.action != opposite or _reference(thing) != "it":
                raise ask("what has the statement to do with the task?")
            return (_replaced(first, "object", of), *rest)
        if first.action in ("open", "close") and not of.is_place and of.sort != "door":
            raise ask("what has the statement to do with the task?")
        pronoun = "it" if of.is_single else "them"
        takes_place = takes_place or stated.source is None
        if (
            isinstance(thing, Nominal)
            and thing.anaphoric
            and thing.count == 1
            and not of.is_single
            and takes_place
        ):
            if of.kind is None or not of.is_plain or self._commands or first.get("source") is not None:
                raise ask("what has the statement to do with the task?")
            first = _replaced(first, "object", replace(thing, kind=of.kind, sort=of.sort, anaphoric=False))
            self._stated_at = stated.source  # of "the right one" after "the left one" as well
            return (first.with_slot("source", stated.source), *rest)
        if not isinstance(thing, Nominal) or thing.reference != pronoun or not takes_place:
            raise ask("what has the statement to do with the task?")
        if thing.said == "both" and of.count not in (2, "both"):
            raise ask("which two are meant?")
        if self._commands or first.get("source") is not None:
            raise ask(f"what does {pronoun!r} stand for?")
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
            raise ask("what does 'them' stand for?")
        if thing.said == "both":
            counts = {entity.task: entity.of.count for entity in recent}
            if list(counts.values()) not in ([1, 1], [2], ["both"]):
                raise ask("which two are meant?")
        for root in roots:
            first, *rest = bundle
            yield (_replaced(first, "object", ObjectOf(root)), *rest)

    def _bundle(self, bundle: Bundle, text: str) -> None:
        last: Any = None
        for one in bundle:
            if one.get("fetched"):
                one = replace(one, slots=tuple(slot for slot in one.slots if slot[0] != "fetched"))
                thing = one.get("object")
                held = self._held_as(thing, one.get("source")) if isinstance(thing, Nominal) else None
                if isinstance(thing, ObjectOf) or thing.reference or held is not None:
                    last = held or (thing if isinstance(thing, ObjectOf) else self._carried(thing))
                    if last.task in self._held and one.get("source") is None:
                        continue
                    one = _replaced(one, "object", last)
            if one.get("object") is PREVIOUS or one.get("object") == PREVIOUS:
                one = _replaced(one, "object", last)
            last = self._task(one, text)

    def _carried(self, thing: Nominal) -> Any:
        """What "it" is that is brought somewhere: not another one than what is in the hand.

        Raises:
            UnresolvedError: It may be.
        """
        meant = self._it(thing, "pick")
        if self._held and isinstance(meant, ObjectOf) and meant.task not in self._held:
            raise ask("which of them does 'it' stand for?")
        return meant

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
                if _is_everything(one) and self._recent(lambda entity: entity.of.sort == "thing"):
                    raise ask("all that was named, or everything there is?")
                self._only_one(thing, one.action)
                if thing.anaphoric:
                    recent = self._recent(lambda entity: entity.of.sort == "thing")
                    self._only_kind(one.of for one in recent)
                self._kind = named if named.kind is not None else self._kind
                resolved = self._description(named)
        elif isinstance(thing, ObjectOf):
            resolved = thing
        root = resolved.task if isinstance(resolved, ObjectOf) else index
        if one.action == "pick" and root in self._held:
            if _is_only_lifted(one) and named is None:
                return ObjectOf(root)  # "grasp it and lift it"
            raise UnresolvedError(Trouble("what is named is in the hand already", None))
        if one.action == "pick" and named is not None and self._held_as(named, one.get("source")) is not None:
            raise ask(f"the {named.kind or 'one'} is in the hand by then: is another one meant?")
        if one.action == "pick" and _is_there(one.get("source")) and root in (*self._placed, *self._given):
            raise ask("shall it be taken from there, or carried there?")
        if one.action in PUTS_DOWN and resolved is not None and root in self._held and one.get("source"):
            raise ask("it is in the hand by then: is another one meant?")
        if one.action == "hand_over" and named is not None and self._is_given(named):
            raise ask(f"the {named.kind or 'one'} is given away by then: is another one meant?")
        slots: dict[str, Any] = {}
        if one.get("there_are") and one.get("source") is None and (around := self._around(one)):
            raise ask("only there, or in all that is in view?", [f"the {around[-1].kind}"])
        if one.get("stays") and root not in self._held and root not in self._placed:
            raise ask("shall it be put there, or stay where it is?")  # "leave the cup on the table"
        if one.action in ("place", "put_in") and named is not None and _is_beside_itself(named, one):
            raise ask(f"is it the same {named.kind} twice? say how they differ")
        if one.get("again") and not self._was_opened(resolved):
            raise UnresolvedError(Trouble("how to do it ('again') cannot be chosen", "again"))
        for name, value in one.slots:
            if name in ("there_are", "again", "stays", "holds"):
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
                    if one.action == "hand_over" and is_them(value)
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
        if "words" in slots:
            self._people += self._people_in(slots["words"])  # "her" who is told is none of them
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
        if self._is_done_already(action, slots):
            return ObjectOf(root)  # "come, stand next to me"
        self._commands.append(_TYPES[action](text, **slots))
        if named is not None:
            self._entities.append(Entity(index, self._clause, named))
            if named.is_place:
                self._name_place(named)
        elif isinstance(resolved, ObjectOf):
            self._again(resolved.task)
        if action == "pick":
            self._held.append(root)
            self._given.discard(root)
        elif action in PUTS_DOWN and root in self._held:
            self._held.remove(root)
        if action == "hand_over":
            self._given.add(root)
        return ObjectOf(root)

    def _held_as(self, thing: Nominal, source: Nominal | None) -> ObjectOf | None:
        """What a task before picks up that is described in the very same words, or None.

        Raises:
            UnresolvedError: It may be one of several, or another that is not in the hand.
        """
        if thing.anaphoric:
            thing = self._same_kind(thing)
        fitting = {
            entity.task: entity.of
            for entity in self._entities
            if entity.task in self._held
            and entity.of == replace(thing, anaphoric=entity.of.anaphoric)
            and source in (None, self._sources.get(entity.task))
        }
        if not fitting:
            return None
        elsewhere = source is None and any(task in self._sources for task in fitting)
        if len(fitting) > 1 or (elsewhere and thing.indefinite):
            raise ask(f"which {thing.kind or 'one'} is meant?")
        return ObjectOf(next(iter(fitting)))

    def _is_given(self, thing: Nominal) -> bool:
        """Whether a task before gives away what is described in the very same words."""
        given = [entity.of for entity in self._entities if entity.task in self._given]
        return any(one == replace(thing, anaphoric=one.anaphoric) for one in given)

    def _around(self, one: Draft) -> list[Nominal]:
        """Where "is there a cup?" may be asked of: what was opened, and places, if not "see if there is"."""
        opened = [entity.of for entity in self._entities if entity.of.sort == "container"]
        return opened if one.get("there_are") == "opened" else [*self._places, *opened]

    def _is_done_already(self, action: str, slots: Mapping[str, Any]) -> bool:
        """Whether the task before walks to the same place, or opens or closes the same."""
        last = self._commands[-1] if self._commands else None
        if action == "walk_to":
            return isinstance(last, tasks.WalkToTask) and last.to == slots["to"]
        if isinstance(last, (tasks.OpenTask, tasks.CloseTask)) and last.action == action:
            return bool(last.object == slots["object"])
        return False

    def _was_opened(self, what: Any) -> bool:
        """Whether a task before opens it, so that to close it "again" is to close it."""
        opened = [index for index, one in enumerate(self._commands) if one.action == "open"]
        if isinstance(what, ObjectOf):
            return what.task in opened
        return any(isinstance(one, tasks.OpenTask) and one.object == what for one in self._commands)


def _is_only_lifted(one: Draft) -> bool:
    """Whether nothing is said of picking a thing up that may not be so once it is held."""
    return all(one.get(slot) is None for slot in ("hand", "source", "holds"))


def _reference(thing: Any) -> str | None:
    return thing.reference if isinstance(thing, Nominal) else None


def _replaced(one: Draft, name: str, value: Any) -> Draft:
    return replace(one, slots=tuple((key, value if key == name else old) for key, old in one.slots))
