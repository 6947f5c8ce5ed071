"""What the things of a planning scene are called, and which words may mean them."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping
from enum import IntEnum

from kinematics.scene.label import Label
from kinematics.scene.planning_scene import SceneObject
from robots.perception.seen_label import SeenLabel
from robots.scenes.scene_words import COLORS, OBJECT_KINDS
from trees.beliefs.scene.scene_update import kind_of


def split_words(words: str) -> tuple[str, str | None]:
    """Kind and colour of "red cup 2"; furniture has no colour."""
    color, _, kind = kind_of(words).partition(" ")
    return (kind, color) if kind and color in COLORS else (kind_of(words) or words, None)


def label_of(item: SceneObject) -> Label:
    """What a thing was seen to be called; of one without a label, what its name in the scene says."""
    return item.label if item.label is not None else label_in(item.name, item.movable)


def label_in(name: str, movable: bool = True) -> Label:
    """What a name of the planning scene says: kind and colour of an object, the kind of all else."""
    return Label(*split_words(name)) if movable else Label(kind_of(name))


def words_besides(named: Iterable[tuple[str, Label]]) -> Mapping[str, frozenset[str]]:
    """What things are called, and what each may be called besides.

    Args:
        named: What each is called first, and its label; things that are called alike are taken together.
    """
    words: dict[str, frozenset[str]] = {}
    for called, label in named:
        words[called] = words.get(called, frozenset()) | besides(label)
    return words


def besides(label: Label) -> frozenset[str]:
    """What a thing is called besides its kind, as words are compared."""
    return frozenset(map(plain, (*label.names, *label.categories)))


class CalledBy(IntEnum):
    """By what a word means a thing; the less, the more surely.

    Attributes:
        NAME: By a name of its own: "tomato soup", "tomato soup can".
        KIND: By its kind, or the last word of its name: "can", "soup".
        CATEGORY: By what sort of thing it is: "food".
        LIKE: By a kind that it may be as well: a can, where cups look much the same.
        MAYBE: By a name that it may have, and nobody is sure of. Only a person knows.
        HEAD: By the last words alone of what was said, which said more: "can" of "paint can". Only a person
            knows whether that one is meant.
    """

    NAME = 0
    KIND = 1
    CATEGORY = 2
    LIKE = 3
    MAYBE = 4
    HEAD = 5


def called_by(said: str | None, label: Label) -> CalledBy | None:
    """By what somebody means a thing of that label; None if not at all.

    Args:
        said: A noun phrase without article, colour or size; None means anything.
        label: What the thing is called.
    """
    if said is None or said == label.kind:  # mostly
        return CalledBy.KIND
    words, kind = plain(said), plain(label.kind)
    names, categories = tuple(map(plain, label.names)), tuple(map(plain, label.categories))
    if words in names or _is_joined(words, names, (kind, *categories)):
        return CalledBy.NAME
    if words == kind or any(_ends(name, words) for name in names) or _is_joined(words, categories, (kind,)):
        return CalledBy.KIND
    if words in categories:
        return CalledBy.CATEGORY
    if isinstance(label, SeenLabel):
        alike = tuple(map(plain, label.alike))
        if words in OBJECT_KINDS and words in alike:
            return CalledBy.LIKE
        if words in alike or any(_ends(name, words) for name in alike) or _is_joined(words, alike, (kind,)):
            return CalledBy.MAYBE
    heads = (kind, *names, *categories)
    return CalledBy.HEAD if any(_ends(words, head) for head in heads) else None


def is_of_color(color: str | None, said: str | None, label: Label) -> bool:
    """Whether a thing is of a colour that somebody says: the one that is seen, or that it is named by.

    A "black book" is what bears that name, whatever it looks like. Where no colour could be told, as of a
    thing of several, the end of its name counts as well: a "black bowl" is the "akita black bowl".

    Args:
        color: None means any.
        said: The noun phrase behind it, as for ``called_by``.
        label: What the thing is called.
    """
    if color in (None, label.color):
        return True
    if said is None:
        return False
    by = called_by(f"{color} {said}", label)
    return by is CalledBy.NAME or (by is CalledBy.KIND and label.color is None)


def can_be_told(said: str, labels: Collection[str]) -> bool:
    """Whether something that is called so could be found by a detector that tells some words.

    Args:
        said: A noun phrase, as for ``called_by``.
        labels: The words, in lower case.
    """
    words = plain(said)
    heads = {" ".join(tail) for tail in _tails(words.split())}
    return any(label in heads or _ends(label, words) for label in map(plain, labels))


def plain(words: str) -> str:
    """Words as they are compared: in lower case, hyphens as spaces."""
    return " ".join(words.casefold().replace("-", " ").replace("_", " ").split())


def _tails(words: list[str]) -> Iterator[list[str]]:
    for first in range(len(words)):
        yield words[first:]


def _ends(phrase: str, head: str) -> bool:
    """Whether a phrase says the head and more before it."""
    return phrase.endswith(f" {head}")


def _is_joined(words: str, firsts: Collection[str], seconds: Collection[str]) -> bool:
    """Whether words are one of the first and one of the second, in this order: "tomato soup" and "can"."""
    return any(words == f"{first} {second}" for first in firsts for second in seconds)
