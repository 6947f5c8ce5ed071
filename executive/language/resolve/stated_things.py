"""What a statement named, as the task after it takes it up: "there is a cup on the table; bring it here"."""

from __future__ import annotations

from dataclasses import replace

from executive.language.phrases.values import Bundle, Draft, Mention, Nominal
from executive.language.resolve.discourse import Discourse, UnresolvedError, ask

_AT_A_PLACE = frozenset({"pick", "place", "put_in", "hand_over", "find", "count", "describe"})


_TAKES = frozenset({"pick", "place", "put_in", "hand_over"})
"""Tasks of which the thing can be nothing that was gone to or opened before."""


def _unrelated() -> UnresolvedError:
    return ask("what has the statement to do with the task?")


def _goes_to(person: Nominal, one: Draft) -> bool:
    """Whether a task hands nothing over, or to the one whom it was said to be for."""
    to = one.get("to")
    if one.action != "hand_over":
        return True
    return isinstance(to, Nominal) and (to == person or to.reference == "him")


def _is_one(thing: Nominal, of: Nominal) -> bool:
    """Whether it is one thing that is opened or closed: the only one, or one of those that were stated."""
    return thing.count == 1 and not thing.plural and (of.is_single or thing.anaphoric)


class StatedThings(Discourse):
    """Puts what a statement named in place of the first "it", "them" or "one" after it."""

    def _with_mention(self, bundle: Bundle) -> Bundle:
        """With what was stated; a task that does not take it up is asked about.

        Raises:
            UnresolvedError: It is not clear what the statement is for.
        """
        first, *rest = bundle
        if self._mention is None:
            return (self._at_stated_place(first), *rest)
        stated, self._mention = self._mention, None
        thing = first.get("object")
        if stated.exists and self._commands and self._commands[-1].action == "walk_to":
            raise ask(f"where is the {stated.of.kind}?")  # "go to the shelf, there is a cup, bring it"
        if stated.state is not None:
            return (self._made_opposite(first, stated), *rest)
        if stated.meant_for is not None and not all(_goes_to(stated.meant_for, one) for one in bundle):
            raise ask(f"is it for {stated.meant_for.kind}, or for whom?")
        if first.action in ("open", "close") and not stated.of.is_place and stated.of.sort != "door":
            raise _unrelated()
        if first.action in ("open", "close") and isinstance(thing, Nominal) and not _is_one(thing, stated.of):
            raise ask(f"which {stated.of.kind} is meant?")
        takes_place = stated.source is None or first.action in _AT_A_PLACE
        if not isinstance(thing, Nominal) or not takes_place:
            raise _unrelated()
        if thing.anaphoric and thing.count == 1 and not stated.of.is_single:
            return (self._one_of(first, thing, stated), *rest)
        return (self._the_same(first, thing, stated), *rest)

    def _at_stated_place(self, first: Draft) -> Draft:
        """Another one of several that were stated to be somewhere: "the right one" after "the left one"."""
        thing = first.get("object")
        another = isinstance(thing, Nominal) and thing.anaphoric and first.get("source") is None
        if self._stated_at is None or not another:
            return first
        if first.action not in _AT_A_PLACE:
            raise _unrelated()
        return first.with_slot("source", self._stated_at)

    def _made_opposite(self, first: Draft, stated: Mention) -> Draft:
        """What is open is closed, and what is closed is opened."""
        thing = first.get("object")
        opposite = "close" if stated.state == "open" else "open"
        is_it = isinstance(thing, Nominal) and thing.reference == "it"
        if self._commands or first.action != opposite or not is_it:
            raise _unrelated()
        return first.replacing("object", stated.of)

    def _one_of(self, first: Draft, thing: Nominal, stated: Mention) -> Draft:
        """One of several that were stated: "there are two cups on the table; take the red one"."""
        of = stated.of
        if of.kind is None or not of.is_plain or self._commands or first.get("source") is not None:
            raise _unrelated()
        self._stated_at = stated.source
        told = first.replacing("object", replace(thing, kind=of.kind, sort=of.sort, anaphoric=False))
        return told.with_slot("source", stated.source)

    def _the_same(self, first: Draft, thing: Nominal, stated: Mention) -> Draft:
        """The very thing that was stated: "it", or "them" where it is several."""
        of = stated.of
        pronoun = "it" if of.is_single else "them"
        one_of_them = thing.is_bare_one and of.indefinite and of.is_single  # "he needs a fork, bring him one"
        if thing.reference != pronoun and not one_of_them:
            raise _unrelated()
        if thing.said == "both" and of.count not in (2, "both"):
            raise ask("which two are meant?")
        handled = self._recent(lambda entity: entity.of.sort in ("thing", "any")) or self._mentioned
        takes = first.action in _TAKES and not handled  # "go to the hall. My keys are there. Bring them"
        if (self._commands and not takes) or first.get("source") is not None:
            raise ask(f"what does {pronoun!r} stand for?")
        told = first.replacing("object", of).with_slot("source", stated.source)
        return told if of.count == 1 else told.with_slot("count", of.count)
