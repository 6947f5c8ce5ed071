"""Which things a name means: one of the planning scene, or whose the thing is, which nobody can see."""

from __future__ import annotations

import re
from collections.abc import Collection, Sequence

from trees.beliefs.grounding.choice_words import from_the_left
from trees.beliefs.grounding.unmatched import NoneFitsError, UntellableError
from trees.beliefs.scene.believed_thing import BelievedThing
from trees.beliefs.scene.scene_update import kind_of

_WHOSE = re.compile(r"['’]s? ")


def named(name: str, fitting: Sequence[BelievedThing], held: Collection[str]) -> list[BelievedThing]:
    """Those of some things that a name means; what is called otherwise is never taken for it.

    Args:
        name: "red cup 2", "Ana's cup".
        fitting: What fits otherwise.
        held: Names of what is in the robot's hands.

    Raises:
        NoneFitsError: There is none of that name.
        UntellableError: It says whose the thing is.
    """
    kept = [thing for thing in fitting if thing.name == name]
    if kept:
        return kept
    if name in held:
        raise NoneFitsError(f"the {kind_of(name)} is in the hand", False)
    words = kind_of(name).casefold()
    # a name that the scene gave, of something that has moved since, and whose colour may be seen by now
    alike = [thing for thing in fitting if thing.words.casefold() == words]
    alike = alike or [thing for thing in fitting if thing.kind == words]
    if alike:
        return alike
    owned = [thing for thing in fitting if _WHOSE.search(words) and words.endswith(f" {thing.kind}")]
    if owned:
        raise UntellableError(f"which one is {name}? names cannot be seen", from_the_left(owned))
    raise NoneFitsError(f"no {name} seen", True)


def may_name_a(kind: str, name: str) -> bool:
    """Whether a name does not contradict a kind: "kitchen door", "Ana's fridge", "fridge 2"."""
    words = kind_of(name).casefold()
    return words == kind or words.endswith(f" {kind}")
