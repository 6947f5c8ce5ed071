"""What a statement named, as the task after it takes it up: "there is a cup on the table; bring it here"."""

from __future__ import annotations

from dataclasses import replace

from executive.language.phrases.values import Bundle, Draft, Mention, Nominal
from executive.language.resolve.antecedents import OPENS
from executive.language.resolve.discourse import PUTS_DOWN, THINGS, Discourse, UnresolvedError, ask, is_them
from executive.language.resolve.kinds import listed

_TAKES = frozenset({"pick", *PUTS_DOWN})
_AT_A_PLACE = frozenset({*_TAKES, "find", "count", "describe"})


def _unrelated() -> UnresolvedError:
    return ask("what has the statement to do with the task?")


def taking_up(told: Discourse, bundle: Bundle, stated: Mention) -> Bundle:
    """What is done with the thing of a statement, in place of the first "it", "them" or "one" after it.

    Raises:
        UnresolvedError: It is not clear what the statement is for.
    """
    first, *rest = bundle
    thing, of = first.get("object"), stated.of
    if stated.exists and told.last_action == "walk_to":
        raise ask(f"where is the {of.kind}?")  # "go to the shelf, there is a cup, bring it"
    if stated.meant_for is not None and not all(_goes_to(stated.meant_for, one) for one in bundle):
        raise ask(f"is it for {stated.meant_for.kind}, or for whom?")
    elsewhere = stated.source is not None and first.action not in _AT_A_PLACE
    if not isinstance(thing, Nominal) or elsewhere or (first.action in OPENS and not _opens(of, thing)):
        raise _unrelated()
    if stated.state is not None and (
        told.steps or first.action not in OPENS or stated.state.startswith(first.action)
    ):
        raise _unrelated()
    one_of_them = thing.anaphoric and thing.count == 1 and not of.is_single
    if one_of_them:  # "there are two cups on the table; take the red one"
        if of.kind is None or not of.is_plain or told.steps:
            raise _unrelated()
        of = replace(thing, kind=of.kind, sort=of.sort, anaphoric=False, said="")
    elif not _is_said_of(thing, of):
        raise _unrelated()
    handled = told.recent(THINGS) or told.mentioned
    if first.get("source") is not None or (told.steps and (handled or first.action not in _TAKES)):
        raise ask(f"what does {thing.reference or 'one'!r} stand for?")
    taken = first.replacing("object", of).with_slot("source", stated.source)
    return (taken if of.count == 1 or one_of_them else taken.with_slot("count", of.count), *rest)


def _is_said_of(thing: Nominal, of: Nominal) -> bool:
    """Whether it is "it", or "them" where it is several, or "one" of which any will do."""
    if is_them(thing):
        return not of.is_single and (thing.said not in listed("two") or of.count in (2, "both"))
    return of.is_single and (thing.reference == "it" or (thing.is_bare_one and of.indefinite))


def _opens(of: Nominal, thing: Nominal) -> bool:
    """Whether it is one thing that can be opened or closed: the only one, or one of those that were stated."""
    one = thing.count == 1 and not thing.plural and (of.is_single or thing.anaphoric)
    return one and (of.is_place or of.sort == "door")


def _goes_to(person: Nominal, one: Draft) -> bool:
    """Whether a task hands nothing over, or to the one whom it was said to be for."""
    to = one.get("to")
    return one.action != "hand_over" or (isinstance(to, Nominal) and (to == person or to.reference == "him"))
