"""What each command means, by its verb; the words that its rules ask for are in ``words.toml``."""

from __future__ import annotations

import importlib.resources
import tomllib
from collections.abc import Callable, Mapping
from functools import cache
from types import MappingProxyType
from typing import Any

from executive.language.phrases.arranging import guarded
from executive.language.phrases.parts import Parts
from executive.language.phrases.values import Meaning


@cache
def word_lists() -> Mapping[str, frozenset[str]]:
    """The lists of ``words.toml``, each a set of words or short phrases in lower case."""
    text = importlib.resources.files(__name__).joinpath("words.toml").read_text("utf-8")
    return {name: frozenset(words) for name, words in tomllib.loads(text).items()}


def meanings(functions: Mapping[str, Callable[[Parts], Any]]) -> Mapping[str, Meaning]:
    """The meanings of rules of the grammar, each of which may raise what ``guarded`` understands."""
    return MappingProxyType({name: guarded(function) for name, function in functions.items()})
