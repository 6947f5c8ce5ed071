"""Two things on opposite sides of one: "the spoon right of the plate and the fork left of it"."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from executive.language.phrases.arranging import Arranged

_OPPOSITES = frozenset({("left_of", "right_of"), ("in_front_of", "behind")})


def with_the_middle(each: Sequence[Arranged]) -> list[Arranged]:
    """With what the first is beside in place of "it", if the other is on the opposite side of it.

    Of "the spoon right of the plate and the fork right of it" the fork may be beside the spoon.
    """
    if len(each) != 2:
        return list(each)
    first, second = each
    if first.goal is None or second.goal is None or second.goal.of.reference != "it":
        return list(each)
    sides = (first.goal.relation, second.goal.relation)
    middle = first.goal.of
    named = middle.kind is not None and not middle.reference and middle.is_single and middle.determined
    alone = first.source is None and first.object.relation is None and not middle.anaphoric
    if not named or not alone or not {sides, sides[::-1]} & _OPPOSITES:
        return list(each)
    return [first, replace(second, goal=replace(second.goal, of=middle))]
