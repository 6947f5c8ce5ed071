"""A noun that is said again with less: "the drawer" after "the left drawer" is that one."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from typing import Any

from executive.language.phrases.values import Draft, Nominal
from executive.language.resolve.discourse import Discourse, ask
from trees.tasks import ObjectOf

PUTS_DOWN = ("place", "put_in", "hand_over")
_TOLD = ("color", "size", "material", "ordinal", "name", "relation")


def _says_more(before: Nominal, thing: Nominal) -> bool:
    """Whether what was named before is the same in more words: "the red cup"."""
    if before.kind is None or before.kind != thing.kind:
        return False
    told = [name for name in _TOLD if getattr(thing, name) is not None]
    if any(getattr(before, name) != getattr(thing, name) for name in told):
        return False
    more = any(getattr(before, name) is not None and getattr(thing, name) is None for name in _TOLD)
    return more or (not before.is_single and before.count != "all")


def _is_compound(before: Nominal, thing: Nominal) -> bool:
    """Whether the word is the last one of what is in the hand: "cranberry juice", "juice"."""
    if before.sort != "thing" or before.kind == thing.kind or thing.kind is None or not thing.is_plain:
        return False
    return any(said.endswith(f" {thing.kind}") for said in (before.kind or "", before.said))


def _may_be_said_again(thing: Nominal) -> bool:
    """Whether it is "the cup", and neither "a cup", "my cup" nor "three cups"."""
    definite = thing.determined or (thing.is_single and not thing.mass)
    plain = not (thing.reference or thing.anaphoric or thing.indefinite or thing.whose or thing.counted)
    return plain and definite and thing.ordinal != "other" and thing.owner is None


class RepeatedNouns(Discourse):
    """Knows what was told more fully before."""

    def _told_before(self, thing: Nominal) -> Any:
        """The task's thing, the place or the person that a noun is said of again; None if it is said anew.

        Raises:
            UnresolvedError: It may be one of several.
        """
        if not _may_be_said_again(thing):
            return None
        acted = [one for one in self._entities if one.clause < self._clause or thing.is_person]
        if any(one.of == thing for one in acted):
            return None
        places = [one for clause, one in (*self._named_in, *self._mentioned_in) if clause < self._clause]
        people = self._people if thing.sort == "person" else []
        if thing in places or thing in people:
            return None
        if thing.sort == "door" and self._names_what_opens((*places, *(one.of for one in acted))):
            return None
        tasks = {
            one.task: one.of
            for one in acted
            if _says_more(one.of, thing) or (one.task in self._held and _is_compound(one.of, thing))
        }
        if not thing.is_single:
            tasks = {task: of for task, of in tasks.items() if not of.is_single}
        others = [
            one
            for one in dict.fromkeys((*places, *people))
            if _says_more(one, thing) and one.is_single and thing.is_single and one not in tasks.values()
        ]
        held = [task for task in tasks if task in self._held]
        if len(held) == 1 and not others:
            tasks = {held[0]: tasks[held[0]]}
        one_of_them = thing.is_single and any(not of.is_single for of in tasks.values())
        if one_of_them or len(tasks) + len(others) > 1:
            raise ask(f"which {thing.kind} is meant?")
        if others:
            return others[0]
        return ObjectOf(next(iter(tasks))) if tasks else None

    @staticmethod
    def _names_what_opens(named: Iterable[Nominal]) -> bool:
        """Whether "the door" may be that of a container."""
        return any(one.sort == "container" for one in named)

    def _as_before(self, value: Any) -> Any:
        """A place or a person as it was told before."""
        if not isinstance(value, Nominal) or not (value.is_place or value.sort == "person"):
            return value
        before = self._told_before(value)
        return before if isinstance(before, Nominal) else value

    def _still_there(self, one: Draft, thing: Nominal, before: Any) -> Any:
        """What a noun was said of before, unless it is said to be at another place than that.

        Raises:
            UnresolvedError: It was given away since.
        """
        if not isinstance(before, ObjectOf) or thing.whose:
            return before
        source = one.get("source")
        if source is not None and source != self._sources.get(before.task):
            return None
        if before.task in self._given:
            raise ask(f"the {thing.kind} is given away by then: is another one meant?")
        return before

    def _same_thing(self, one: Draft, thing: Nominal) -> ObjectOf | None:
        """What is brought somewhere and was told more fully before."""
        before = None if thing.reference or thing.is_place else self._told_before(thing)
        before = self._still_there(one, thing, before)
        return before if isinstance(before, ObjectOf) else None

    def _put_down_so(self, one: Draft, thing: Nominal) -> ObjectOf | None:
        """What is put down and was picked up in the same words: by then another one is on the left."""
        if one.action not in PUTS_DOWN or thing.is_plain or thing.indefinite or one.get("source") is not None:
            return None
        said = self._same_kind(thing)
        held = {
            each.task
            for each in self._entities
            if each.task in self._held and each.of == replace(said, anaphoric=each.of.anaphoric)
        }
        return ObjectOf(held.pop()) if len(held) == 1 else None

    def _not_what_is_filled(self, one: Draft, thing: Nominal) -> None:
        """Ask which box is put down that another thing was just put into, in the same breath.

        Raises:
            UnresolvedError: "Put the ball in the red box and the box on the table."
        """
        if one.action not in PUTS_DOWN or not _may_be_said_again(thing):
            return
        here = [of for clause, of in (*self._named_in, *self._mentioned_in) if clause == self._clause]
        if any(_says_more(of, thing) for of in here):
            raise ask(f"which {thing.kind} is meant?")

    def _not_at_itself(self, goal: Any, root: int) -> None:
        """Ask when what is held goes to where a noun says that it is itself: "the red box ... in the box".

        Raises:
            UnresolvedError: It does.
        """
        beside = getattr(getattr(goal, "relation", None), "to", None)
        if root in self._held and ObjectOf(root) in (goal, beside):
            raise ask("is it the same one twice? say how they differ")
