"""The words that are understood, read from the TOML files beside this one and from the user's.

A file holds tables; a table is a word class: a terminal of the grammar, or, with ``refusal``, words
that are understood but never acted on. ``words`` maps a meaning to the phrases that carry it, ``same``
lists phrases that mean themselves. In a phrase ``[x|y]`` may be left out, ``(x|y)`` is one of several.
"""

from __future__ import annotations

import importlib.resources
import itertools
from collections import ChainMap
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import Any

from executive.errors import VocabularyError
from executive.vocabulary.inflection import gerund, participle, plural
from executive.vocabulary.outside import outside_words
from executive.vocabulary.prepared import Head, Prepared, digest_of, keep, kept
from executive.vocabulary.written import MOST_VARIANTS, expand, variants
from robots.outside import VOCABULARY, outside_files
from robots.toml_text import TomlTextError, read_toml

Words = tuple[str, ...]

_THINGS = ("KIND", "KINDS", "SUBSTANCE", "PAIR", "CONTAINER", "FURNITURE", "DOOR")
"""Word classes of things: what one is called, what several are called, and those with ways of their own."""

_KEYS = frozenset(
    {"words", "same", "refusal", "meaning", "plural", "plurals", "inflect", "proper", "owner", "irregular"}
)


@dataclass(frozen=True, slots=True)
class Reading:
    """One way to read a phrase: its word class and what it means there."""

    word_class: str
    meaning: str


@dataclass(frozen=True, slots=True)
class WordClass:
    """One class of words.

    Attributes:
        name: Terminal of the grammar.
        words: Phrases by meaning, written out.
        refusal: Why none of them is acted on, as a format of ``word`` and ``meaning``; None when the
            grammar uses them.
        meanings: What ``meaning`` reads like in ``refusal``.
        derived: Whether its phrases are formed from those of another class.
    """

    name: str
    words: Mapping[str, tuple[str, ...]]
    refusal: str | None = None
    meanings: Mapping[str, str] = field(default_factory=dict)
    derived: bool = False


_Beginning = tuple[tuple[int, ...], Mapping[Words, Sequence[Reading]]]


class Vocabulary:
    """Every word class, with a look-up by phrase."""

    def __init__(self, classes: Sequence[WordClass]) -> None:
        self._begin(_prepared(classes), lambda: classes)

    @classmethod
    def of_prepared(cls, prepared: Prepared, classes: Callable[[], Sequence[WordClass]]) -> Vocabulary:
        """A vocabulary whose classes are written out only when somebody asks for them all."""
        vocabulary = cls.__new__(cls)
        vocabulary._begin(prepared, classes)
        return vocabulary

    def _begin(self, prepared: Prepared, classes: Callable[[], Sequence[WordClass]]) -> None:
        self._prepared, self._all_classes = prepared, classes
        self._heads = {head[0]: head for head in prepared.heads}
        self._readings: dict[str, _Beginning] = {}
        self._whole: frozenset[Words] = frozenset()

    def with_things(self, words: Sequence[str]) -> Vocabulary:
        """The same vocabulary, and further words for kinds of things.

        A word that is refused here is one of them from now on; one that is known as a thing stays what it is.
        A phrase of several words is one thing wherever it stands: "macaroni and cheese" is no list of two.

        Args:
            words: Noun phrases in lower case, each as one thing is called.
        """
        added: dict[str, list[str]] = {}
        for word in words:
            length, readings = self.match(word.split())
            known = length == len(word.split()) and any(
                one.word_class in _THINGS and self.refusal_of(one.word_class, one.meaning, word) is None
                for one in readings
            )
            if not known:
                many = word if word.endswith("s") and not word.endswith("ss") else plural(word)
                for phrase, word_class in ((word, _THINGS[0]), (many, _THINGS[1])):
                    line = f"{phrase}\t{word_class}\t{word if phrase != word else ''}"
                    added.setdefault(phrase.partition(" ")[0], []).append(line)
        beginnings = {first: self._also(first, lines) for first, lines in added.items()}
        prepared = replace(
            self._prepared,
            beginnings=ChainMap(beginnings, dict(self._prepared.beginnings)),
            words=" ".join([self._prepared.words, *words, *map(plural, words)]),
        )
        vocabulary = Vocabulary.of_prepared(prepared, self._all_classes)
        vocabulary._whole = frozenset(tuple(word.split()) for word in words if " " in word)
        return vocabulary

    def _also(self, first: str, lines: Sequence[str]) -> str:
        """Phrases that begin with a word, with further ones, which take the place of what is refused."""
        taken = {line.partition("\t")[0] for line in lines}
        kept_lines = []
        for line in self._prepared.beginnings.get(first, "").split("\n"):
            phrase, _, rest = line.partition("\t")
            word_class, _, meaning = rest.partition("\t")
            refused = line and self.refusal_of(word_class, meaning or phrase, phrase) is not None
            if line and not (refused and phrase in taken):
                kept_lines.append(line)
        return "\n".join([*kept_lines, *lines])

    @cached_property
    def classes(self) -> Mapping[str, WordClass]:
        """The word classes by name."""
        return {word_class.name: word_class for word_class in self._all_classes()}

    def matches(self, words: Sequence[str], start: int) -> Iterator[tuple[int, Reading]]:
        """Every phrase that begins at ``start``: its length, and one reading of it."""
        lengths, readings = self._beginning_with(words[start])
        if self._whole:
            left = words[start:]
            whole = (n for n in lengths if n <= len(left) and tuple(left[:n]) in self._whole)
            lengths = (longest,) if (longest := max(whole, default=0)) else lengths
        for length in lengths:
            if start + length <= len(words):
                for reading in readings.get(tuple(words[start : start + length]), ()):
                    yield length, reading

    def _beginning_with(self, word: str) -> _Beginning:
        """The lengths of all phrases that begin with a word, and the readings of each.

        They are sorted out when the word is first met: a process that parses one sentence meets few of them.
        """
        found = self._readings.get(word)
        if found is not None:
            return found
        readings: dict[Words, list[Reading]] = {}
        lines = self._prepared.beginnings.get(word)
        for line in lines.split("\n") if lines else ():
            phrase, word_class, meaning = line.split("\t")
            known = readings.setdefault(tuple(phrase.split(" ")), [])
            reading = Reading(word_class, meaning or phrase)
            if reading not in known:
                known.append(reading)
        found = tuple(dict.fromkeys(map(len, readings))), readings
        if readings:  # an unknown word is not kept: there is no end of them
            self._readings[word] = found
        return found

    def match(self, words: Sequence[str]) -> tuple[int, Sequence[Reading]]:
        """The longest phrase at the beginning of ``words``: its length and readings, or (0, ())."""
        found = list(self.matches(words, 0)) if words else []
        longest = max((length for length, _ in found), default=0)
        return longest, tuple(reading for length, reading in found if length == longest)

    @cached_property
    def single_words(self) -> frozenset[str]:
        """Every word that occurs in some phrase."""
        return frozenset(self._prepared.words.split())

    def phrases(self, class_name: str) -> list[str]:
        """Every phrase of a class, sorted."""
        return sorted(itertools.chain.from_iterable(self.classes[class_name].words.values()))

    def refusal(self, reading: Reading, word: str) -> str | None:
        """Why a phrase in one of its readings is not acted on; None when the grammar uses its class."""
        return self.refusal_of(reading.word_class, reading.meaning, word)

    def refusal_of(self, class_name: str, meaning: str, word: str) -> str | None:
        """Why a phrase of a class is not acted on; None when the grammar uses the class, or there is none."""
        head = self._heads.get(class_name)
        if head is None or head[1] is None:
            return None
        return head[1].format(word=word, meaning=head[2].get(meaning, meaning))


def load_vocabulary(user_files: Sequence[Path] = (), cache: Path | None = None) -> Vocabulary:
    """Read the word lists that travel with the package, those of other packages, and a user's own.

    Args:
        user_files: TOML files of the same form; their words are added to the classes of these names.
        cache: A folder where the classes are kept, written out, from one process to the next. None keeps
            nothing.

    Raises:
        VocabularyError: A list is malformed.
    """
    own = _own_files()
    digest = None if cache is None else _digest(own, user_files)
    if cache is None or digest is None:
        return Vocabulary(_read_classes(own, user_files))
    found = kept(cache, digest)
    if found is not None:
        prepared, words = found
        return Vocabulary.of_prepared(prepared, lambda: _restored(prepared.heads, words()))
    classes = _read_classes(own, user_files)
    keep(cache, digest, _prepared(classes), {one.name: one.words for one in classes})
    return Vocabulary(classes)


def _own_files() -> list[tuple[str, str]]:
    """The files beside this one: names and texts."""
    folder = importlib.resources.files("executive.vocabulary")
    return sorted(
        (item.name, item.read_text("utf-8")) for item in folder.iterdir() if item.name.endswith(".toml")
    )


def _digest(own: Sequence[tuple[str, str]], user_files: Sequence[Path]) -> str | None:
    """What the classes are made of, the rules that inflect them included; None when it cannot be told."""
    folder = importlib.resources.files("executive.vocabulary")
    outside = outside_files(VOCABULARY)
    try:
        rules = [
            (folder / name).read_bytes()
            for name in ("__init__.py", "inflection.py", "prepared.py", "written.py")
        ]
        given = [path.read_bytes() for path in user_files]
        brought = [f"{name}".encode() + file.read_bytes() for name, file in sorted(outside.items())]
    except OSError:
        return None
    return digest_of([*(text.encode() for _, text in own), *rules, b"given", *given, b"brought", *brought])


def _prepared(classes: Sequence[WordClass]) -> Prepared:
    heads = tuple((one.name, one.refusal, dict(one.meanings), one.derived) for one in classes)
    beginnings: dict[str, list[str]] = {}
    words: dict[str, None] = {}
    for one in classes:
        for meaning, phrases in one.words.items():
            for phrase in phrases:
                line = f"{phrase}\t{one.name}\t{meaning if meaning != phrase else ''}"
                beginnings.setdefault(phrase.partition(" ")[0], []).append(line)
                words.update(dict.fromkeys(phrase.split(" ")))
    return Prepared(heads, {first: "\n".join(lines) for first, lines in beginnings.items()}, " ".join(words))


def _restored(heads: Sequence[Head], words: Mapping[str, Mapping[str, Sequence[str]]]) -> list[WordClass]:
    return [
        WordClass(
            name,
            {meaning: tuple(phrases) for meaning, phrases in words[name].items()},
            refusal,
            meanings,
            derived=derived,
        )
        for name, refusal, meanings, derived in heads
    ]


def _read_classes(own: Sequence[tuple[str, str]], user_files: Sequence[Path]) -> list[WordClass]:
    tables: dict[str, dict[str, Any]] = {}
    for file_name, text in own:
        _add(tables, read_toml(text), file_name, new_classes=True)
    usable = frozenset(name for name, table in tables.items() if not table.get("irregular"))
    for source, words in outside_words(usable).words:
        _add(tables, words, source, new_classes=False)
    for path in user_files:
        _add(tables, _user_tables(path), str(path), new_classes=False)
    irregular = {
        base: form
        for table in tables.values()
        if table.get("irregular")
        for form, bases in table["words"].items()
        for base in bases
    }
    return [word_class for name, table in tables.items() for word_class in _classes(name, table, irregular)]


def _user_tables(path: Path) -> dict[str, Any]:
    try:
        document = read_toml(path.read_text("utf-8"))
    except OSError as failed:
        raise VocabularyError(f"{path}: cannot be read: {failed.strerror}") from failed
    except (TomlTextError, UnicodeDecodeError) as failed:
        raise VocabularyError(f"{path}: is no TOML: {failed}") from failed
    words = document.get("vocabulary", {})
    if not isinstance(words, dict):
        raise VocabularyError(f"{path}: vocabulary: must be a table of word classes")
    return words


def _add(
    tables: dict[str, dict[str, Any]], added: Mapping[str, Any], source: str, *, new_classes: bool
) -> None:
    for name, table in added.items():
        if not new_classes and (name not in tables or tables[name].get("irregular")):
            known = ", ".join(sorted(key for key in tables if not tables[key].get("irregular")))
            raise VocabularyError(f"{source}: no word class {name!r} among {known}")
        if not isinstance(table, dict):
            raise VocabularyError(f"{source}: {name}: must be a table")
        unknown = set(table) - (_KEYS if new_classes else {"words", "same"})
        if unknown or not ({"words", "same"} & set(table)):
            raise VocabularyError(f"{source}: {name}: needs words or same, and knows no {sorted(unknown)}")
        merged = tables.setdefault(name, {"words": {}})
        merged.update({key: value for key, value in table.items() if key not in ("words", "same")})
        words = _listed(table, source, name)
        for meaning, phrases in words.items():
            merged["words"][meaning] = [*merged["words"].get(meaning, []), *phrases]


def _listed(table: Mapping[str, Any], source: str, name: str) -> dict[str, list[str]]:
    words = table.get("words", {})
    same = table.get("same", [])
    lists = [same, *words.values()] if isinstance(words, dict) else [None]
    if not all(
        isinstance(phrases, list) and all(isinstance(one, str) and one.strip() for one in phrases)
        for phrases in lists
    ):
        raise VocabularyError(
            f"{source}: {name}: words are lists of phrases by meaning, same is a list of phrases"
        )
    for phrase in itertools.chain(same, *words.values()):
        if (count := variants(phrase)) > MOST_VARIANTS:
            shown = f"{phrase[:40]!r} stands for {count:.0e} phrases"
            raise VocabularyError(f"{source}: {name}: {shown}; at most {MOST_VARIANTS} are written out")
    result = {meaning: list(phrases) for meaning, phrases in words.items()}
    for phrase in same:
        for one in expand(phrase) if "(" in phrase or "[" in phrase else (phrase,):
            result.setdefault(one, []).append(one)
    return result


def _classes(name: str, table: Mapping[str, Any], irregular: Mapping[str, str]) -> Iterator[WordClass]:
    if table.get("irregular"):
        return
    words = {
        _meaning(meaning, table): tuple(one for phrase in phrases for one in expand(phrase))
        for meaning, phrases in table["words"].items()
    }
    if table.get("inflect"):
        for meaning, phrases in list(words.items()):
            words[f"{meaning}:ing"] = (
                *words.get(f"{meaning}:ing", ()),
                *dict.fromkeys(gerund(one) for one in phrases),
            )
            words[f"{meaning}:ed"] = tuple(dict.fromkeys(participle(one, irregular) for one in phrases))
    yield WordClass(name, words, table.get("refusal"), table.get("meaning", {}))
    if "plural" in table:
        more = table.get("plurals", {})
        several = {
            meaning: (*map(plural, phrases), *more.get(meaning, ())) for meaning, phrases in words.items()
        }
        yield WordClass(table["plural"], several, derived=True)
    if "owner" in table:
        owners = {meaning: tuple(f"{one}'s" for one in phrases) for meaning, phrases in words.items()}
        yield WordClass(table["owner"], owners, derived=True)


def _meaning(meaning: str, table: Mapping[str, Any]) -> str:
    meaning = " ".join(meaning.split())
    return meaning.title() if table.get("proper") else meaning
