"""What is asked before something is done: is it in the hand, given away, another one, does it harm?"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from executive.language.phrases.features import SUPERLATIVES, WEIGHTS
from executive.language.phrases.values import HARMS, Draft, Nominal, Relative, Trouble
from executive.language.resolve.antecedents import OPENED, in_hand, may_be_said_again, says_more
from executive.language.resolve.discourse import PUTS_DOWN, Discourse
from executive.language.resolve.kinds import listed, rules
from executive.meaning import Command
from executive.references import references
from trees.tasks import FindTask, HandOverTask, ObjectDescription, ObjectOf, PlaceTask, PutInTask

_TOLD = frozenset({"count", "find", "describe"})
"""Tasks that end with something to tell."""

_WHERE = {"hand_over": "with", "put_in": "in", "place": "on"}
"""How it is said where a thing is by then."""


@dataclass(frozen=True, slots=True)
class Order:
    """A task that is about to be ordered: how it is said, its thing, if that is named anew, and its root.

    The root is the first task that acts on that thing.
    """

    said: Draft
    named: Nominal | None
    root: int


Guard = Callable[[Discourse, Order], Trouble | None]
"""What stands against a task after what was said before, or None."""


def trouble_with(told: Discourse, order: Order) -> Trouble | None:
    """What has to be asked or refused before a task is done, or None."""
    return next((trouble for guard in _GUARDS if (trouble := guard(told, order)) is not None), None)


def trouble_after(told: Discourse) -> Trouble | None:
    """What has to be asked when all was said, or None."""
    commands = [step.command for step in told.steps]
    several = {index for index, one in enumerate(commands) if isinstance(one, FindTask) and one.count != 1}
    if any(references(command) & several for command in commands):
        return _asked("which one of those that are found is meant?")
    for root in told.held:  # "take the red cup to the kitchen, take the blue one too"
        for put in (step for step in told.steps[:root] if step.command.action in PUTS_DOWN):
            took = commands[put.root]
            verbs = {one.text.lower().partition(" ")[0] for one in (took, commands[root])}
            kinds = {getattr(getattr(one, "object", None), "kind", None) for one in (took, commands[root])}
            if put.command.text == took.text and len(verbs) == 1 and len(kinds) == 1:
                return _asked("where shall it go?")
    return None


def harm_in(commands: Sequence[Command]) -> Trouble | None:
    """Why a robot must not do this, or None: a fork in a toaster, a knife for a baby (``hazards.toml``).

    It is told from the tasks, where "it" is known to be the fork.
    """
    for command in commands:
        if not isinstance(command, HandOverTask | PutInTask | PlaceTask):
            continue
        thing = _described(command.object, commands)
        goal = _described(getattr(command, "on", None) or command.to, commands)
        where = goal.kind if isinstance(goal, ObjectDescription) else goal
        if not isinstance(thing, ObjectDescription) or thing.kind is None or not isinstance(where, str):
            continue
        if any(_harms(rule, thing, where.lower(), command.action) for rule in rules("harm")):
            return Trouble(f"the {thing.kind} {_WHERE[command.action]} the {where} {HARMS}", thing.kind)
    return None


def _described(thing: Any, commands: Sequence[Command]) -> Any:
    """The description behind "it", which may stand for what "it" stood for before."""
    for _ in commands:
        if isinstance(thing, ObjectOf) and 0 <= thing.task < len(commands):
            thing = getattr(commands[thing.task], "object", None)
    return thing


def _harms(rule: Mapping[str, Any], thing: ObjectDescription, where: str, action: str) -> bool:
    """Whether a rule forbids to do this with a thing there."""
    kind = thing.kind or ""
    if action not in rule["actions"] or where not in listed(rule["where"]):
        return False
    left_out = frozenset().union(*(listed(one) for one in rule.get("but", ())))
    if not left_out.isdisjoint((kind, where)) or (kind.startswith("toy ") and not rule.get("toys")):
        return False
    if rule.get("material") and thing.material is not None:
        return bool(thing.material == rule["material"])
    within = next((kind.removesuffix(end) for end in listed("packs") if kind.endswith(end)), kind)
    named = {kind, within, kind.rpartition(" ")[2], within.rpartition(" ")[2]}
    return any(not named.isdisjoint(listed(one)) for one in rule["things"])


def _goal(order: Draft) -> Any:
    """How the place was said where a thing goes, or what that place is beside."""
    goal = order.get("to") or order.get("on")
    return goal.to if isinstance(goal, Relative) else goal


def _asked(message: str) -> Trouble:
    return Trouble(message, asks=True)


def _moved_already(told: Discourse, order: Order) -> Trouble | None:
    """Take the cup that is in the hand, or put down the one that was given away."""
    action, named, source = order.said.action, order.named, order.said.get("source")
    if action == "pick" and order.root in told.held:
        return Trouble("what is named is in the hand already")
    again = action == "pick" and named is not None and in_hand(told, named, source)
    if again or (action in PUTS_DOWN and order.root in told.held and source):
        return _asked("it is in the hand by then: is another one meant?")
    given = [replace(one.of, anaphoric=False) for one in told.things if one.task in told.moved("hand_over")]
    gives = named is not None and action == "hand_over" and replace(named, anaphoric=False) in given
    if gives or (action in PUTS_DOWN and order.root in told.moved("hand_over")):
        return _asked("it is given away by then: is another one meant?")
    return None


def _left_somewhere(told: Discourse, order: Order) -> Trouble | None:
    """Leave the cup on the table: whether it is there already."""
    stays = order.said.get("stays") and order.root not in told.held
    return _asked("shall it be put there, or stay where it is?") if stays else None


def _same_twice(told: Discourse, order: Order) -> Trouble | None:
    """Put the cup in the cup; put the ball in the red box and the box on the table."""
    named = order.named or next((one.of for one in told.things if one.task == order.root), None)
    if order.said.action not in PUTS_DOWN or named is None or named.kind is None:
        return None
    here = [one.of for one in (*told.places, *told.mentioned) if one.clause == told.clause]
    filled = order.named is not None and may_be_said_again(named) and any(says_more(of, named) for of in here)
    if filled or (order.said.action != "hand_over" and _goal(order.said) == named):
        return _asked(f"is it the same {named.kind} twice? say how they differ")
    return None


def _one_of_several(told: Discourse, order: Order) -> Trouble | None:
    """The first one, the other one, everything: of what was named."""
    of = order.said.get("object")
    if not isinstance(of, Nominal) or order.named is None:
        return None
    alike = [one for one in told.things if one.of.kind == order.named.kind]
    singles = {one.task: one.of for one in alike if not one.is_several}
    of_what = of.ordinal in ("other", "last") and of.anaphoric and order.named.kind is None
    if of_what or (of.ordinal == "other" and len(singles) > 1):
        return _asked("which one is meant?" if singles else "other than what? nothing was named before")
    counted = of.anaphoric and any(one.ordinal not in listed("counted") for one in singles.values())
    known = any(told.steps[one.task].command.action in ("find", "pick") for one in alike if one.is_several)
    several = [one for one in alike if one.is_several and one.clause < told.clause]
    held = of.anaphoric and order.said.action == "pick" and any(one.task in told.held for one in several)
    if held or (of.ordinal in listed("counted") and (counted or known)):
        return _asked("which of those that were named is meant?")
    everything = of.sort == "any" and of.kind is None and of.is_plain and of.count == "all"
    if everything and order.said.get("source") is None and told.recent(("thing",)):
        return _asked("all that was named, or everything there is?")
    return None


def _among_the_same(told: Discourse, order: Order) -> Trouble | None:
    """The biggest cup on the table and the smallest: whether that is on the table too."""
    before = told.things[-1] if told.things else None
    said = [_goal(order.said), order.said.get("object") if order.said.get("source") is None else None]
    others = [of for of in said if isinstance(of, Nominal) and of.anaphoric and of.relation is None]
    if before is None or not others:
        return None
    stated = any(one.of.kind == before.of.kind and one.is_several for one in told.as_named("about"))
    placed = before.of.relation is not None or told.source_of(before.task) is not None
    ranked = before.of.sort in OPENED or _is_ranked(before.of)
    doubt = placed and (stated or (ranked and any(_is_ranked(of) for of in others)))
    return _asked("which one is meant?") if doubt else None


def _is_ranked(of: Nominal) -> bool:
    return of.size in SUPERLATIVES or of.ordinal not in (None, "other")


def _told_of_what(told: Discourse, order: Order) -> Trouble | None:
    """Go to the shelf, is there a cup; come and tell me; count the cups and find them."""
    where = order.said.get("there_are")
    around = [one for one in told.places if where is True or one.role in (where or ())]
    if where and order.said.get("source") is None and around:
        return _asked("only there, or in all that is in view?")
    if order.said.get("tells") and told.last_action not in _TOLD:
        return _asked("what shall be told?")
    found = order.said.action == "find" and order.said.get("object") == ObjectOf(order.root)
    if found and told.steps[order.root].command.action == "count":
        return _asked("which of them shall be found?")
    return None


def _by_weight(_told: Discourse, order: Order) -> Trouble | None:
    """Take the heaviest cup: which that is can be asked, and nothing can be chosen by it."""
    named = [value for _, value in order.said.slots] + [order.named]
    named += [of.relation for of in named if isinstance(of, Nominal)]
    of = [one.to if isinstance(one, Relative) else one for one in named]
    weighed = [one.size for one in of if isinstance(one, Nominal) and one.size in WEIGHTS]
    if not weighed or (order.said.action == "describe" and len(set(weighed)) == 1):
        return None
    told = "this robot cannot weigh things before it lifts them; say colour, size or where it is"
    return Trouble(f"{weighed[0]!r}: {told}", weighed[0])


_GUARDS: tuple[Guard, ...] = (
    _by_weight,
    _moved_already,
    _left_somewhere,
    _same_twice,
    _one_of_several,
    _among_the_same,
    _told_of_what,
)
