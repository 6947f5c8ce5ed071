"""Which of the things around the robot bear a word and a colour."""

from __future__ import annotations

from collections.abc import Sequence

from trees.beliefs.grounding.unmatched import NoneFitsError, UntellableError
from trees.beliefs.scene.believed_thing import BelievedThing, Surroundings
from trees.beliefs.scene.held_object import is_like
from trees.beliefs.scene.labels import CalledBy, called_by, is_of_color
from trees.beliefs.scene.scene_update import kind_of
from trees.tasks import ObjectDescription


def things_called(
    wanted: ObjectDescription, around: Surroundings, *, several: bool = False
) -> list[BelievedThing]:
    """Objects that are called so, and of the colour that is meant.

    Of several ways to be called so the surest counts: a "soup" is what is named so, before any can of food.

    Args:
        wanted: The description.
        around: What is believed.
        several: Whether all are meant: then whatever is of that sort counts as much as what is named so.

    Raises:
        NoneFitsError: There is none.
        UntellableError: Something may be called so, or bears only the last of the words that were said.
    """
    by = {
        thing.name: rank
        for thing in around.objects
        if is_of_color(wanted.color, wanted.kind, thing.label)
        if (rank := called_by(wanted.kind, thing.label)) is not None
    }
    rank = min(by.values(), default=None)
    if rank is None:
        held = [name for name, label in around.held.items() if is_like(wanted, label)]
        raise NoneFitsError(f"the {kind_of(held[0])} is in the hand" if held else f"no {wanted} seen", False)
    last = max(rank, CalledBy.CATEGORY) if several and rank < CalledBy.LIKE else rank
    fitting = [thing for thing in around.objects if by.get(thing.name, CalledBy.HEAD + 1) <= last]
    if rank is CalledBy.MAYBE:
        raise UntellableError(_may_be_it(str(wanted), fitting), fitting)
    if rank is CalledBy.HEAD:
        raise UntellableError(_is_it(str(wanted), fitting), fitting)
    return fitting


def _may_be_it(noun: str, alike: Sequence[BelievedThing]) -> str:
    """The question whether something is what it may be."""
    if len(alike) > 1:
        return f"I am not sure which of these is the {noun}: which one?"
    return f"I am not sure: is the {alike[0].words} the {noun}?"


def _is_it(noun: str, alike: Sequence[BelievedThing]) -> str:
    """The question whether something that is called nearly so is meant."""
    if len(alike) > 1:
        return f"I see no {noun}: which of these is meant?"
    return f"I see no {noun}, only the {alike[0].words}: is that meant?"
