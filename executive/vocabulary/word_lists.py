"""Word lists as they are written: those beside this file, those of other packages, and a user's own.

A file holds tables; a table is a word class: a terminal of the grammar, or, with ``refusal``, words
that are understood but never acted on. ``words`` maps a meaning to the phrases that carry it, ``same``
lists phrases that mean themselves. In a phrase ``[x|y]`` may be left out, ``(x|y)`` is one of several.
"""

from __future__ import annotations

import importlib.resources
import itertools
from collections.abc import Container, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from typing import Any

from executive.errors import VocabularyError
from executive.vocabulary.inflection import gerund, participle, plural
from executive.vocabulary.written import MOST_VARIANTS, expand, variants
from robots.outside import VOCABULARY, outside_files, outside_folders
from robots.toml_text import TomlTextError, read_toml

Tables = Mapping[str, Any]


@dataclass(frozen=True, slots=True)
class WordClass:
    """One class of words, a terminal of the grammar: its phrases by meaning, written out.

    A class that no grammar uses has a ``refusal``: why none of it is acted on, as a format of ``word`` and
    of ``meaning`` as ``meanings`` says it. The phrases of a ``derived`` one are formed from another's.
    """

    name: str
    words: Mapping[str, tuple[str, ...]]
    refusal: str | None = None
    meanings: Mapping[str, str] = field(default_factory=dict)
    derived: bool = False


@dataclass(frozen=True, slots=True)
class OutsideWords:
    """Tables of words that other packages add, by where they come from, and why others were left out."""

    words: tuple[tuple[str, Tables], ...]
    complaints: tuple[str, ...] = ()


def read_classes(user_files: Sequence[Path]) -> list[WordClass]:
    """Every word class, with the words that are added to it.

    Raises:
        VocabularyError: A user's list is malformed.
    """
    tables: dict[str, dict[str, Any]] = {}
    for file in sorted(importlib.resources.files("executive.vocabulary").iterdir(), key=str):
        if file.name.endswith(".toml") and file.name != "forms.toml":
            _add(tables, read_toml(file.read_text("utf-8")))
    for _, words in outside_words(frozenset(tables)).words:
        _add(tables, words)
    for path in user_files:
        words = _user_tables(path)
        defect = _defect(words, tables)
        if defect is not None:
            raise VocabularyError(f"{path}: {defect}")
        _add(tables, words)
    return [word_class for name, table in tables.items() for word_class in _classes(name, table)]


@cache
def outside_words(classes: frozenset[str]) -> OutsideWords:
    """The word lists of other packages, read once; one that cannot be one is left out.

    Args:
        classes: Names of the word classes that there are.
    """
    words: list[tuple[str, Tables]] = []
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


def _user_tables(path: Path) -> Any:
    try:
        return read_toml(path.read_text("utf-8")).get("vocabulary", {})
    except OSError as failed:
        raise VocabularyError(f"{path}: cannot be read: {failed.strerror}") from failed
    except (TomlTextError, UnicodeDecodeError) as failed:
        raise VocabularyError(f"{path}: is no TOML: {failed}") from failed


def _defect(tables: Any, classes: Container[str]) -> str | None:
    """What keeps somebody's tables from being added to the classes, or None."""
    if not isinstance(tables, dict):
        return "vocabulary must be a table of word classes"
    for name, table in tables.items():
        if name not in classes:
            return f"there is no word class {name!r}"
        if not isinstance(table, dict) or not table or set(table) - {"words", "same"}:
            return f"{name}: needs words or same, and nothing else"
        words = table.get("words", {})
        lists: list[Any] = [table.get("same", []), *words.values()] if isinstance(words, dict) else [None]
        if not all(isinstance(one, list) and all(isinstance(word, str) and word.strip() for word in one)
                   for one in lists):  # fmt: skip
            return f"{name}: words are lists of phrases by meaning, same is a list of phrases"
        for phrase in itertools.chain.from_iterable(lists):
            if (count := variants(phrase)) > MOST_VARIANTS:
                return f"{name}: {phrase[:40]!r} stands for {count:.0e} phrases; at most {MOST_VARIANTS}"
    return None


def _add(tables: dict[str, dict[str, Any]], added: Tables) -> None:
    for name, table in added.items():
        merged = tables.setdefault(name, {"words": {}})
        merged.update({key: value for key, value in table.items() if key not in ("words", "same")})
        same = [(one, [one]) for phrase in table.get("same", ()) for one in _choices(phrase)]
        for meaning, phrases in itertools.chain(table.get("words", {}).items(), same):
            merged["words"][meaning] = [*merged["words"].get(meaning, []), *phrases]


def _choices(phrase: str) -> Iterator[str]:
    """The phrases that one with choices stands for; any other is a meaning as it is written: "t-shirt"."""
    return expand(phrase) if {"(", "["} & set(phrase) else iter((phrase,))


def _classes(name: str, table: Tables) -> Iterator[WordClass]:
    """A word class, and those whose phrases are formed from its own."""
    words = {
        " ".join(meaning.title().split() if table.get("proper") else meaning.split()): tuple(
            one for phrase in phrases for one in expand(phrase)
        )
        for meaning, phrases in table["words"].items()
    }
    if table.get("inflect"):
        for meaning, phrases in list(words.items()):
            given = words.get(f"{meaning}:ing", ())
            words[f"{meaning}:ing"] = (*given, *dict.fromkeys(map(gerund, phrases)))
            words[f"{meaning}:ed"] = tuple(dict.fromkeys(map(participle, phrases)))
    yield WordClass(name, words, table.get("refusal"), table.get("meaning", {}))
    if "plural" in table:
        more = table.get("plurals", {})
        several = {one: (*map(plural, phrases), *more.get(one, ())) for one, phrases in words.items()}
        yield WordClass(table["plural"], several, derived=True)
    if "owner" in table:
        owners = {one: tuple(f"{phrase}'s" for phrase in phrases) for one, phrases in words.items()}
        yield WordClass(table["owner"], owners, derived=True)
