"""Words of other packages, in the form of a user's own words; a list that cannot be one is left out."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from typing import Any

from robots.outside import VOCABULARY, outside_files, outside_folders
from robots.toml_text import TomlTextError, read_toml


@dataclass(frozen=True, slots=True)
class OutsideWords:
    """Words that other installed packages add to the vocabulary.

    Attributes:
        words: For each file where it comes from, and its tables by word class.
        complaints: Why a file or package was left out, one line each.
    """

    words: tuple[tuple[str, Mapping[str, Any]], ...]
    complaints: tuple[str, ...] = ()


@cache
def outside_words(classes: frozenset[str]) -> OutsideWords:
    """The word lists of other packages, read once.

    Args:
        classes: Names of the word classes that there are.
    """
    words: list[tuple[str, Mapping[str, Any]]] = []
    complaints = list(outside_folders(VOCABULARY).complaints)
    for name, file in outside_files(VOCABULARY).items():
        try:
            tables = read_toml(file.read_text("utf-8"))["vocabulary"]
        except (OSError, KeyError, UnicodeDecodeError, TomlTextError) as broken:
            complaints.append(f"words {name!r}: {type(broken).__name__}: {broken}")
            continue
        defect = _defect(tables, classes)
        if defect is None:
            words.append((f"words {name!r}", tables))
        else:
            complaints.append(f"words {name!r}: {defect}")
    return OutsideWords(tuple(words), tuple(complaints))


def _defect(tables: Any, classes: frozenset[str]) -> str | None:
    """What keeps a file from being added to the classes, or None."""
    if not isinstance(tables, dict):
        return "vocabulary must be a table of word classes"
    for name, table in tables.items():
        if name not in classes:
            return f"there is no word class {name!r}"
        if not isinstance(table, dict) or not table or set(table) - {"words", "same"}:
            return f"{name}: needs words or same, and nothing else"
        by_meaning = table.get("words", {})
        lists = [table.get("same", []), *by_meaning.values()] if isinstance(by_meaning, dict) else [None]
        if not all(isinstance(one, list) and all(isinstance(word, str) and word.strip() for word in one)
                   for one in lists):  # fmt: skip
            return f"{name}: words are lists of phrases by meaning, same is a list of phrases"
    return None
