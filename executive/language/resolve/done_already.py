"""Whether a task that a sentence speaks of as done was ordered before: "... once you have put it down"."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from executive.language.clauses.scopes import UNCLEAR_ORDER
from executive.language.phrases.values import Bundle, Draft, Nominal, Trouble
from executive.language.resolve.discourse import UnresolvedError, ask
from executive.language.resolve.doubts import Doubts
from executive.language.resolve.genders import may_be
from trees import tasks
from trees.tasks import ObjectOf

_SAID = (
    "done",
    "condition",
    "late",
    "fetched",
    "out",
    "holds",
    "passive",
    "lifts",
    "reaches",
    "stated",
    "by_anyone",
)
"""Slots that say how a task was ordered, not what it is."""

_GOES = frozenset({"walk_to", "move", "go_home"})
_PUTS = frozenset({"place", "put_in", "hand_over"})
_UNDOES = {
    "open": frozenset({"close"}),
    "close": frozenset({"open"}),
    "pick": _PUTS,
    **dict.fromkeys(_PUTS, frozenset({"pick", *_PUTS})),
    **dict.fromkeys(_GOES, _GOES),
}
"""After which tasks another one is not done any more."""

_TOLD = ("kind", "name", "color", "size", "material", "ordinal", "relation")


def _slots_of(one: Draft) -> dict[str, Any]:
    """What a draft says, however the article was left out."""
    return {
        name: replace(value, determined=True) if isinstance(value, Nominal) else value
        for name, value in one.slots
        if name not in _SAID
    }


def _is_named_again(person: Any, said: Any) -> bool:
    return bool(person == said)


def _is_the_same(person: Any, said: Any) -> bool:
    """Whether somebody is named again, or is who "him" may be."""
    if isinstance(said, Nominal) and isinstance(person, Nominal) and said.reference == "him":
        return person.reference is None and may_be(said.said, person)
    return _is_named_again(person, said)


class DoneAlready(Doubts):
    """Knows which tasks were ordered so far, so that none is done twice because it is spoken of again."""

    def _ordered_before(self, one: Draft) -> ObjectOf | None:
        """The thing of the task before that is spoken of as done, or None when it was not ordered."""
        last = self._commands[-1] if self._commands else None
        goal = one.get("to")
        if one.action == "walk_to" and isinstance(goal, Nominal) and goal.reference == "there":
            return ObjectOf(len(self._commands) - 1) if isinstance(last, tasks.WalkToTask) else None
        if one.get("passive"):  # "once found"
            if not self._did or self._did[-1][0].action != one.action:
                self._doubt_done(one)
            return ObjectOf(self._did[-1][1])
        meant = self._spoken_of(one)
        said = _slots_of(one)
        since: set[str] = set()
        for before, root in reversed(self._did):
            since.add(before.action)
            if one.action == "pick" and meant == root and root in self._held and "source" not in said:
                return ObjectOf(root)  # "get the cup; once you have picked it up, ..."
            if before.action != one.action:
                continue
            rest = {name: value for name, value in said.items() if name not in ("object", "person")}
            ordered = _slots_of(before)
            if any(ordered.get(name) != value for name, value in rest.items()):
                continue
            if self._is_about(said, ordered, root, meant):
                return ObjectOf(root)
        return None

    def _spoken_of(self, one: Draft) -> int | None:
        """The task of the thing that "it" stands for, or that is held and described in the same words."""
        thing = one.get("object")
        if isinstance(thing, ObjectOf):
            return thing.task
        if not isinstance(thing, Nominal):
            return None
        if thing.reference == "it" and self._did:
            meant = self._it(thing, one.action)
            return meant.task if isinstance(meant, ObjectOf) else None
        held = None if thing.reference else self._held_as(thing, one.get("source"))
        return None if held is None else held.task

    def _is_about(
        self, said: Mapping[str, Any], ordered: Mapping[str, Any], root: int, meant: int | None
    ) -> bool:
        """Whether a task was ordered of the very thing or person."""
        person = said.get("person")
        if isinstance(person, Nominal) and (person.reference == "him" or person.reference == "them"):
            known = ordered.get("person")
            return isinstance(known, Nominal) and may_be(person.said, known)
        if person != ordered.get("person"):
            return False
        if meant == root or said.get("object") == ordered.get("object"):
            return True
        return self._is_only_such(said.get("object"), root)

    def _is_only_such(self, thing: Any, root: int) -> bool:
        """Whether a thing is told by no more than the only one of its kind that was named: "the cup"."""
        if not isinstance(thing, Nominal) or thing.reference or thing.indefinite or thing.kind is None:
            return False
        same = [one for one in self._entities if one.of.kind == thing.kind]
        if {one.task for one in same} != {root} or thing.is_single != same[-1].of.is_single:
            return False
        return all(getattr(thing, name) in (None, getattr(same[-1].of, name)) for name in _TOLD)

    def _is_given_just_now(self, bundle: Bundle) -> bool:
        """Whether the task before gives the very thing to whom it is to be brought."""
        first, *rest = bundle
        last, root = self._did[-1] if self._did else (None, -1)
        if last is None or last.action != "hand_over" or first.get("source") is not None:
            return False
        brought = first.get("fetched") and len(rest) == 1
        if not brought and not (last.get("stated") and not rest):  # "it goes to Ana, give it to her"
            return False
        handed, thing = bundle[-1], first.get("object")
        same = _is_the_same if last.get("stated") else _is_named_again
        if handed.action != "hand_over" or not same(last.get("to"), handed.get("to")):
            return False
        if isinstance(thing, Nominal) and thing.reference == "it":
            thing = self._it(thing, first.action)
        return bool(thing == ObjectOf(root))

    def _was_put_there(self, action: str, slots: Mapping[str, Any], root: int, *, stays: bool) -> bool:
        """Whether a task before put it where it is to go; otherwise that is noted.

        Raises:
            UnresolvedError: It is said to be left, with ``stays``, where no task has put it.
        """
        if action not in ("place", "put_in"):
            return False
        goal = (action, slots.get("on"), slots.get("to"))
        before = self._placed.get(root)
        if before is not None and root not in self._held and goal in (before, ("place", None, None)):
            return True
        in_a_room = before is not None and before[:2] == ("place", None) and isinstance(before[2], str)
        if (
            stays and root not in self._held and not in_a_room
        ):  # "put it on the shelf and leave it on the table"
            raise ask("shall it be put there, or stay where it is?")
        self._placed[root] = goal
        return False

    def _take_back(self, root: int) -> None:
        """Leave out a hand-over that nobody asked for: "bring the blanket and put it on the bed".

        Raises:
            UnresolvedError: It was asked for, so that the thing is given away by now.
        """
        if self._unsaid_giving != (len(self._commands) - 1, root):
            raise ask("it is given away by then: shall it be taken back first?")
        self._commands.pop()
        self._given.discard(root)
        self._held.append(root)

    def _let_go(self, root: int) -> ObjectOf:
        """What was put down or in, or given away, is let go of by then.

        Raises:
            UnresolvedError: It is not.
        """
        if root in self._held or root not in (*self._placed, *self._given):
            raise ask("where shall it be put?")
        return ObjectOf(root)

    def _in_the_hand(self, one: Draft, thing: Nominal) -> ObjectOf | None:
        """What the task before took, named again: "reach for the cup, grasp the cup, lift the cup"."""
        if not self._did or thing.indefinite:
            return None
        before, root = self._did[-1]
        if not (one.get("lifts") or before.get("reaches")):
            return None
        taken = next((one.of for one in self._entities if one.task == root), None)
        told = [name for name in _TOLD if getattr(thing, name) is not None]
        same = taken is not None and all(getattr(taken, name) == getattr(thing, name) for name in told)
        return ObjectOf(root) if same and root in self._held else None

    def _doubt_done(self, one: Draft) -> None:
        """Refuse what is done only if somebody else does it, and ask when that would have to be.

        Raises:
            UnresolvedError: It was not ordered before.
        """
        word, goal = one.get("condition"), one.get("to")
        on_the_way = bool(self._commands) and isinstance(goal, Nominal) and not goal.reference
        if word == "with":  # "go to the table with the lamp"
            raise ask("shall it be carried along, or does it tell where to go?")
        if word == "there":
            raise ask("which place does 'there' stand for?")
        if one.get("by_anyone"):
            thing = one.get("object")
            it = f"the {thing.kind}" if isinstance(thing, Nominal) and thing.kind else "it"
            raise ask(f"shall {it} be {one.get('by_anyone')} first, or does somebody else do that?")
        if word is not None and not on_the_way:
            told = f"a condition ({word!r}) cannot be honoured; say what to do"
            raise UnresolvedError(Trouble(told, word))
        if one.get("late") and self._commands:
            raise UnresolvedError(UNCLEAR_ORDER)

    def _is_done_already(self, action: str, slots: Mapping[str, Any]) -> bool:
        """Whether the task before walks to the same place, opens or closes the same, or finds it."""
        last = self._commands[-1] if self._commands else None
        if action == "walk_to":
            return isinstance(last, tasks.WalkToTask) and last.to == slots["to"]
        if isinstance(last, tasks.FindTask) and action == "find":  # "find the cup and tell me where it is"
            meant = slots.get("object")
            if isinstance(meant, ObjectOf):
                return all(isinstance(one, tasks.FindTask) for one in self._commands[meant.task :])
            return slots.get("person") is not None and slots.get("person") == last.person
        if isinstance(last, (tasks.OpenTask, tasks.CloseTask)) and last.action == action:
            return bool(last.object == slots["object"])
        return False
