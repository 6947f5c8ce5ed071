"""Answers that name what is not meant beside what is: "the red one, not the blue one"."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from executive.language.phrases import Item
from executive.language.taken_back.contrasts import NOT, Reader, only_contrast
from executive.language.taken_back.set_apart import Apart
from executive.language.words.lattice import Lattice
from executive.meaning import command_json
from trees.tasks import ObjectDescription, PickTask

MAX_WORDS = 20


def contrasted_answer(
    lattice: Lattice, reader: Reader, selected: Callable[[str], ObjectDescription | None]
) -> ObjectDescription | None:
    """What an answer chooses beside something else; None where that is open, or it names nothing else.

    Args:
        lattice: The answer.
        reader: The parser.
        selected: What a text without a contrast chooses.
    """
    word = only_contrast(lattice)
    if word is None or word.meaning != NOT or len(lattice.pieces) > MAX_WORDS:
        return None
    found = set()
    for meant, not_meant in _parted(lattice, word.start, word.end):
        chosen = selected(meant)
        named = [one for one in reader.meanings("item", not_meant) if isinstance(one, Item)]
        if chosen is not None and named:
            apart = Apart([command_json(PickTask(meant, object=chosen))], reader.sort_of)
            found.add(chosen if all(map(apart.stands_beside, named)) else None)
    return found.pop() if len(found) == 1 else None


def _parted(lattice: Lattice, start: int, end: int) -> Iterator[tuple[str, str]]:
    """What may be meant, and what is not: "W, not E", "not E, W", "not E but W"."""
    texts = [piece.text for piece in lattice.pieces]
    if start > 0:
        yield " ".join(texts[:start]).rstrip(" ,"), " ".join(texts[end:])
        return
    for index in range(end + 1, len(texts) - 1):
        if texts[index] in (",", "but"):
            after = index + 2 if texts[index + 1] == "but" else index + 1
            yield " ".join(texts[after:]), " ".join(texts[end:index])
