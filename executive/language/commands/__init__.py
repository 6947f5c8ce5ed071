"""What each command means, by its verb; the words that its rules ask for are in ``words.toml``."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import Any

from executive.language.phrases.arranging import guarded
from executive.language.phrases.parts import Parts
from executive.language.phrases.values import Meaning


def meanings(functions: Mapping[str, Callable[[Parts], Any]]) -> Mapping[str, Meaning]:
    """The meanings of rules of the grammar, each of which may raise what ``guarded`` understands."""
    return MappingProxyType({name: guarded(function) for name, function in functions.items()})
