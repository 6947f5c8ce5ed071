"""Words that a model may not pass over unasked: negation, condition, time, report."""

from __future__ import annotations

import importlib.resources
import re
from collections.abc import Mapping
from functools import cache

from executive.vocabulary.written import split_words
from robots.toml_text import read_toml

_CONTRACTED = "n't"


def traps_in(text: str) -> tuple[str, ...]:
    """The trap words of a text as they are said, each once, in their order.

    Args:
        text: What the person said, in any case.
    """
    words = [word for word, _, _ in split_words(text.replace("’", "'"))]
    plain = f" {' '.join(words)} "
    found = {
        match.start(): phrase
        for phrases in trap_words().values()
        for phrase in phrases
        if (match := re.search(rf"(?<= ){re.escape(phrase)}(?= )", plain)) is not None
    }
    found |= {plain.index(f" {word} "): word for word in words if word.endswith(_CONTRACTED)}
    return tuple(phrase for _, phrase in sorted(found.items()))


@cache
def trap_words() -> Mapping[str, tuple[str, ...]]:
    """The words by what makes each a trap."""
    file = importlib.resources.files("executive.front") / "trap_words.toml"
    return {kind: tuple(words) for kind, words in read_toml(file.read_text("utf-8")).items()}
