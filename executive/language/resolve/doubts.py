"""What has to be asked before something is done with a thing: is it in the hand, given away, another one?"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from executive.language.phrases.values import Draft, Nominal, Relative, Trouble
from executive.language.resolve.destinations import Destinations
from executive.language.resolve.discourse import UnresolvedError, ask
from executive.language.resolve.repeated_nouns import PUTS_DOWN
from executive.references import references
from trees import tasks
from trees.tasks import ObjectOf

_MOVES = frozenset({"pick", *PUTS_DOWN})

_TOLD = frozenset({"count", "find", "describe"})
"""Tasks that end with something to tell."""


def _is_beside_itself(thing: Nominal, one: Draft) -> bool:
    """Whether a thing goes to what is described in the very same words: "put the cup in the cup"."""
    goal = one.get("to") or one.get("on")
    goal = goal.to if isinstance(goal, Relative) else goal
    return isinstance(goal, Nominal) and thing.kind is not None and goal == thing


def _is_there(place: Any) -> bool:
    """Whether a place was named before: "take it there"."""
    return isinstance(place, Nominal) and place.reference == "there"


class Doubts(Destinations):
    """Knows what the tasks so far did to each thing, and what may be meant by doing more."""

    def _doubt(self, one: Draft, named: Nominal | None, resolved: Any, root: int) -> None:
        """Ask what is unclear about a task.

        Args:
            one: The task.
            named: Its thing, if that was named anew.
            resolved: The same as the value of a slot.
            root: The first task of that thing.

        Raises:
            UnresolvedError: Something is.
        """
        if one.action == "pick":
            self._doubt_pick(one, named, root)
        elif one.action in PUTS_DOWN:
            self._doubt_putting(one, named, resolved, root)
        if one.get("there_are") and one.get("source") is None and (around := self._around(one)):
            raise ask("only there, or in all that is in view?", [f"the {around[-1].said or around[-1].kind}"])
        if one.get("tells") and not (self._commands and self._commands[-1].action in _TOLD):
            raise ask("what shall be told?")
        if one.get("again") and not self._was_opened(resolved):
            raise UnresolvedError(Trouble("how to do it ('again') cannot be chosen", "again"))

    def _doubt_for_whom(self, about: Sequence[Nominal]) -> None:
        """Ask who gets what was just brought to nobody: "bring a blanket, Grandma is cold".

        Raises:
            UnresolvedError: It may be somebody of whom a statement tells why.
        """
        brought = self._unsaid_giving is not None and self._unsaid_giving[0] == len(self._commands) - 1
        people = [str(one.kind) for one in about if one.is_person]
        if brought and people:
            raise ask("to whom?", ["me", *people])

    def _doubt_stated(self, one: Draft, root: int) -> None:
        """Ask what is done with a thing that was just said to go elsewhere: "the milk goes in the fridge".

        Raises:
            UnresolvedError: Something else is.
        """
        if one.action not in _MOVES:
            return
        if one.get("stated"):
            self._stated_to_go[root] = self._clause
        elif self._stated_to_go.get(root, self._clause) != self._clause:
            raise ask("it is said to go elsewhere: shall it be put there first?")

    def _doubt_another(self) -> None:
        """Ask where another one goes that is only taken, by the verb that took one somewhere.

        Raises:
            UnresolvedError: "Take the red cup to the kitchen. Take the blue one too."
        """
        for root in self._held:
            took, put, takes = self._commands[root - 2 : root + 1] if root > 1 else (None, None, None)
            if not isinstance(took, tasks.PickTask) or put is None or not isinstance(takes, tasks.PickTask):
                continue
            carried = put.action in PUTS_DOWN and put.text == took.text
            verbs = {one.text.lower().partition(" ")[0] for one in (took, takes)}
            kinds = {getattr(one.object, "kind", None) for one in (took, takes)}
            if carried and len(verbs) == 1 and len(kinds) == 1:
                raise ask("where shall it go?")

    def _doubt_several_found(self) -> None:
        """Ask which one is meant where something is to be done to several that were only looked for.

        Raises:
            UnresolvedError: "Find the cups and bring them to me".
        """
        several = set(filter(self._was_search_for_several, range(len(self._commands))))
        if any(references(command) & several for command in self._commands):
            raise ask("which one of those that are found is meant?")

    def _doubt_pick(self, one: Draft, named: Nominal | None, root: int) -> None:
        if root in self._held:
            raise UnresolvedError(Trouble("what is named is in the hand already", None))
        if named is not None and self._held_as(named, one.get("source")) is not None:
            raise ask(f"the {named.kind or 'one'} is in the hand by then: is another one meant?")
        if _is_there(one.get("source")) and root in (*self._placed, *self._given):
            raise ask("shall it be taken from there, or carried there?")

    def _doubt_putting(self, one: Draft, named: Nominal | None, resolved: Any, root: int) -> None:
        if resolved is not None and root in self._held and one.get("source"):
            raise ask("it is in the hand by then: is another one meant?")
        if one.get("stays") and root not in self._held and root not in self._placed:
            raise ask("shall it be put there, or stay where it is?")  # "leave the cup on the table"
        if named is None:
            return
        if one.action == "hand_over" and self._is_given(named):
            raise ask(f"the {named.kind or 'one'} is given away by then: is another one meant?")
        if one.action != "hand_over" and _is_beside_itself(named, one):
            raise ask(f"is it the same {named.kind} twice? say how they differ")

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

    def _was_opened(self, what: Any) -> bool:
        """Whether a task before opens it, so that to close it "again" is to close it."""
        opened = [index for index, one in enumerate(self._commands) if one.action == "open"]
        if isinstance(what, ObjectOf):
            return what.task in opened
        return any(isinstance(one, tasks.OpenTask) and one.object == what for one in self._commands)
