"""What each command means, by its verb; the words that its rules ask for are in ``words.toml``."""

from __future__ import annotations

import importlib.resources
import tomllib
from collections.abc import Mapping
from functools import cache


@cache
def word_lists() -> Mapping[str, frozenset[str]]:
    """The lists of ``words.toml``, each a set of words or short phrases in lower case."""
    text = importlib.resources.files(__name__).joinpath("words.toml").read_text("utf-8")
    return {name: frozenset(words) for name, words in tomllib.loads(text).items()}
