"""What is asked before something is done: is it in the hand, given away, another one, in this order?"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

from executive.language.phrases.features import SUPERLATIVES
from executive.language.phrases.values import Draft, Nominal, Relative, Trouble
from executive.language.resolve.antecedents import in_hand, may_be_said_again, says_more, standing_open
from executive.language.resolve.discourse import PUTS_DOWN, THINGS, Discourse
from executive.references import references
from trees.tasks import FindTask, ObjectOf

_TOLD = frozenset({"count", "find", "describe"})
"""Tasks that end with something to tell."""

_COUNTED = frozenset({"first", "second", "third", "fourth", "fifth", "last"})


@dataclass(frozen=True, slots=True)
class Order:
    """A task that is about to be ordered.

    Attributes:
        said: How it was said.
        named: Its thing, if that was named anew.
        root: The first task that acts on that thing.
    """

    said: Draft
    named: Nominal | None
    root: int

    @property
    def thing(self) -> Nominal | None:
        """How its thing was said."""
        thing = self.said.get("object")
        return thing if isinstance(thing, Nominal) else None

    @property
    def goal(self) -> Nominal | None:
        """How the place was said where it goes, or what that place is beside."""
        goal = self.said.get("to") or self.said.get("on")
        goal = goal.to if isinstance(goal, Relative) else goal
        return goal if isinstance(goal, Nominal) else None


Guard = Callable[[Discourse, Order], Trouble | None]
"""What stands against a task after what was said before, or None."""


def trouble_with(told: Discourse, order: Order) -> Trouble | None:
    """What has to be asked or refused before a task is done, or None."""
    return next((trouble for guard in _GUARDS if (trouble := guard(told, order)) is not None), None)


def trouble_after(told: Discourse) -> Trouble | None:
    """What has to be asked when all was said, or None."""
    several = {
        index for index, one in enumerate(told.commands) if isinstance(one, FindTask) and one.count != 1
    }
    if any(references(command) & several for command in told.commands):
        return _asked("which one of those that are found is meant?")
    for root in told.held:  # "take the red cup to the kitchen, take the blue one too"
        takes = told.steps[root]
        for step in told.steps[:root]:
            took = told.steps[step.root].command
            carried = step.command.action in PUTS_DOWN and step.command.text == took.text
            alike = getattr(took, "object", None), getattr(takes.command, "object", None)
            verbs = {one.text.lower().partition(" ")[0] for one in (took, takes.command)}
            if carried and len({getattr(one, "kind", None) for one in alike}) == 1 and len(verbs) == 1:
                return _asked("where shall it go?")
    return None


def _asked(message: str) -> Trouble:
    return Trouble(message, asks=True)


def _taken_already(told: Discourse, order: Order) -> Trouble | None:
    if order.said.action != "pick":
        return None
    if order.root in told.held:
        return Trouble("what is named is in the hand already")
    if order.named is not None and in_hand(told, order.named, order.said.get("source")) is not None:
        return _asked(f"the {order.named.kind or 'one'} is in the hand by then: is another one meant?")
    return None


def _given_already(told: Discourse, order: Order) -> Trouble | None:
    if order.said.action not in PUTS_DOWN:
        return None
    given = [one.of for one in told.things if one.task in told.given]
    again = order.said.action == "hand_over" and any(one == _as(order.named, one) for one in given)
    if again or order.root in told.given:
        return _asked("it is given away by then: is another one meant?")
    return None


def _as(named: Nominal | None, one: Nominal) -> Nominal | None:
    return None if named is None else replace(named, anaphoric=one.anaphoric)


def _left_somewhere(told: Discourse, order: Order) -> Trouble | None:
    """Leave the cup on the table: whether it is there already."""
    if order.said.get("stays") and order.root not in told.held:
        return _asked("shall it be put there, or stay where it is?")
    if order.said.get("lets_go"):
        return _asked("where shall it be put?")
    return None


def _same_twice(told: Discourse, order: Order) -> Trouble | None:
    """Put the cup in the cup; put the ball in the red box and the box on the table."""
    named, goal = order.named, order.goal
    if order.said.action not in PUTS_DOWN:
        return None
    if order.root in told.held and order.said.get("source"):
        return _asked("it is in the hand by then: is another one meant?")
    if named is None or named.kind is None:
        return None
    here = [one.of for one in (*told.places, *told.mentioned) if one.clause == told.clause]
    filled = may_be_said_again(named) and any(says_more(of, named) for of in here)
    if filled or (order.said.action != "hand_over" and goal == named):
        return _asked(f"is it the same {named.kind} twice? say how they differ")
    return None


def _one_of_several(told: Discourse, order: Order) -> Trouble | None:
    """The first one, the other one, everything: of what was named."""
    of, named = order.thing, order.named
    if of is None or named is None:
        return None
    alike = {one.task: one for one in told.things if one.of.kind == named.kind}
    singles = [one for one in alike.values() if not one.is_several]
    if of.ordinal == "other" and (len(singles) > 1 or (of.anaphoric and named.kind is None)):
        return _asked("which one is meant?" if singles else "other than what? nothing was named before")
    if of.ordinal in _COUNTED:
        chosen = of.anaphoric and any(one.of.ordinal not in _COUNTED for one in singles)
        several = [one for one in alike.values() if one.is_several]
        found = [one for one in several if told.commands[one.task].action == "find"]
        if chosen or found or any(one.task in told.held for one in several):
            return _asked("which of those that were named is meant?")
    everything = of.sort == "any" and of.kind is None and of.is_plain and of.count == "all"
    if everything and order.said.get("source") is None and any(one.of.sort == "thing" for one in told.things):
        return _asked("all that was named, or everything there is?")
    return None


def _ranked_among(told: Discourse, order: Order) -> Trouble | None:
    """The biggest cup on the table and the smallest: whether that is on the table too."""
    before = told.things[-1] if told.things else None
    if before is None or before.of.sort not in THINGS:
        return None
    ranked = _is_ranked(before.of) and (
        before.of.relation is not None or told.source_of(before.task) is not None
    )
    stated = any(one.of.kind == before.of.kind and one.is_several for one in told.as_named("about"))
    for of, source in ((order.thing, order.said.get("source")), (order.goal, None)):
        another = of is not None and of.anaphoric and of.relation is None and source is None
        if another and (stated or (ranked and _is_ranked(of))):
            return _asked("which one is meant?")
    return None


def _is_ranked(of: Nominal | None) -> bool:
    return of is not None and (of.size in SUPERLATIVES or of.ordinal not in (None, "other"))


def _only_there(told: Discourse, order: Order) -> Trouble | None:
    """Go to the shelf; is there a cup?"""
    where = order.said.get("there_are")
    opened = [one.of for one in told.things if one.of.sort == "container"]
    around = opened if where == "opened" else [*(one.of for one in told.places), *opened]
    if where and order.said.get("source") is None and around:
        return _asked("only there, or in all that is in view?")
    return None


def _nothing_before(told: Discourse, order: Order) -> Trouble | None:
    """Come and tell me; close it again; count the cups and find them."""
    if order.said.get("tells") and told.last_action not in _TOLD:
        return _asked("what shall be told?")
    if order.said.get("again") and not (told.opened or standing_open(told)):
        return Trouble("how to do it ('again') cannot be chosen", "again")
    if order.said.action == "find" and order.said.get("object") == ObjectOf(order.root):
        return (
            None if told.commands[order.root].action != "count" else _asked("which of them shall be found?")
        )
    return None


_GUARDS: tuple[Guard, ...] = (
    _taken_already,
    _given_already,
    _left_somewhere,
    _same_twice,
    _one_of_several,
    _ranked_among,
    _only_there,
    _nothing_before,
)
