"""What a statement named, as the task after it takes it up: "there is a cup on the table; bring it here"."""

from __future__ import annotations

from dataclasses import replace

from executive.language.phrases.values import Bundle, Mention, Nominal
from executive.language.resolve.antecedents import OPENED, OPENS
from executive.language.resolve.discourse import MOVES, THINGS, Discourse, ask, is_them
from executive.language.resolve.kinds import listed

_AT_A_PLACE = frozenset({*MOVES, "find", "count", "describe"})


def taking_up(told: Discourse, bundle: Bundle, stated: Mention) -> Bundle:
    """What is done with the thing of a statement, in place of the first "it", "them" or "one" after it.

    Raises:
        UnresolvedError: It is not clear what the statement is for.
    """
    first, *rest = bundle
    thing, of = first.get("object"), stated.of
    is_one = isinstance(thing, Nominal) and thing.anaphoric and thing.count == 1 and not of.is_single
    chosen = is_one and of.kind is not None and of.is_plain and not told.steps
    opens, state = first.action in OPENS, stated.state or ""
    opened = told.steps or of.sort not in OPENED or state.startswith(first.action)
    placed = first.get("source") is not None or (stated.source and first.action not in _AT_A_PLACE)
    handled = told.recent(THINGS) or told.mentioned or first.action not in MOVES or stated.exists
    unfit = opened if opens else state
    if not (chosen or _is_said_of(thing, of)) or placed or unfit or (told.steps and handled):
        raise ask("what has the statement to do with the task?")
    if chosen:  # "there are two cups on the table; take the red one"
        of = replace(thing, kind=of.kind, sort=of.sort, anaphoric=False, said="")
    taken = first.replacing("object", of).with_slot("source", stated.source)
    return (taken if of.count == 1 else taken.with_slot("count", of.count), *rest)


def _is_said_of(thing: object, of: Nominal) -> bool:
    """Whether it is "it", or "them" where it is several, or "one" of which any will do."""
    if not isinstance(thing, Nominal):
        return False
    if is_them(thing):
        return not of.is_single and (thing.said not in listed("two") or of.count in (2, "both"))
    return of.is_single and (thing.reference == "it" or (thing.is_bare_one and of.indefinite))
