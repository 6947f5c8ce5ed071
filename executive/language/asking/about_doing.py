"""Whether what would be a command asks about doing it, or thanks for what was done."""

from __future__ import annotations

from collections.abc import Set as AbstractSet

from executive.language.words.lattice import Lattice

_PRAISED = "praise"
"""Meaning of those courtesies that may be said of what was done: "lovely, opening the fridge"."""

_PRAISE = frozenset({"good", "great", "well", "nice", "excellent", "perfect", "fine", "thanks", "thank"})
"""Words of what is said to whoever has done something, as well as before a command."""

_ASK = frozenset({"OPENING", "THERE_IS"})
"""What begins with "you" and asks for something, or states where it is: "you could", "you see"."""


def asks_about_doing(lattice: Lattice, verbs: AbstractSet[str]) -> bool:
    """Whether a question mark ends "opening the fridge?", "the milk goes there?", "the milk from there?"."""
    asks = lattice.plain.rstrip().endswith("?")
    if not asks:
        return False
    said = [word for start in range(len(lattice.pieces)) for word in lattice.phrase(start)]
    states = any(word.word_class == "GETS" for word in said)
    begun = [at for at in range(len(lattice.pieces)) if _begins_apart(lattice, at)]
    begins = {at: {word.word_class for word in lattice.phrase(at)} for at in begun}
    states = states or any(
        "YOU_DO" in one and one.isdisjoint(_ASK) for one in begins.values()
    )  # "you take sugar?"
    classes = {word.word_class for word in said}
    states = states or ("FROM" in classes and classes.isdisjoint(verbs))
    return states or any(word.meaning.endswith(":ing") for word in lattice.phrase(0))


def _begins_apart(lattice: Lattice, position: int) -> bool:
    """Whether nothing but courtesies stands before a place, and a mark ends them."""
    return position == 0 or (lattice.may_begin(position) and lattice.pieces[position - 1].is_mark)


def praises(lattice: Lattice) -> bool:
    """Whether an -ing form stands right behind praise or thanks: "good job picking up the cup"."""
    size = len(lattice.pieces)
    for start in range(size):
        for praise in lattice.phrase(start):
            is_praise = praise.meaning == _PRAISED or not _PRAISE.isdisjoint(praise.said.split())
            if praise.word_class not in ("OPENING", "FILLER") or not is_praise:
                continue
            following = [*lattice.phrase(praise.end)] if praise.end < size else []
            for one in tuple(following):
                if one.word_class == "ADDRESSED" and one.end < size:  # "good job, robot"
                    following += lattice.phrase(one.end)
            if any(one.meaning.endswith(":ing") for one in following):
                return True
    return False
