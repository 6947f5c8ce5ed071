"""Word classes written out once and kept from one process to the next.

Reading and inflecting the word lists takes longer than everything else that a process does that only
parses one sentence. What is kept is named by a digest of all that it was made of, so that it never is
out of date.
"""

from __future__ import annotations

import contextlib
import hashlib
import json
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from kinematics.whole_file import read_whole, write_whole

_NAME = "vocabulary-{digest}.kept"
_KEPT = 4
"""Files that are kept: a person may use several lists of words of their own in turn."""

Head = tuple[str, str | None, dict[str, str], bool]
"""A word class without its phrases: name, refusal, readings of the refusal's meanings, whether derived."""

Words = Mapping[str, Mapping[str, Sequence[str]]]
"""Phrases by word class and meaning."""


@dataclass(frozen=True, slots=True)
class Prepared:
    """Vocabulary and grammar as a process that parses sentences needs them, ready to be loaded.

    Attributes:
        heads: The word classes, without their phrases.
        beginnings: For each first word of a phrase the phrases that begin with it, one a line: phrase, word
            class and meaning, with tabs between; no meaning where it is the phrase itself. The lines are
            cut up when the word is met.
        words: Every word of any phrase, with spaces between.
    """

    heads: Sequence[Head]
    beginnings: Mapping[str, str]
    words: str


def digest_of(sources: Iterable[bytes]) -> str:
    """A name for what is made of some files: it changes when any of them does."""
    digest = hashlib.sha256()
    for source in sources:
        digest.update(len(source).to_bytes(8, "little"))
        digest.update(source)
    return digest.hexdigest()[:24]


def kept(cache: Path, digest: str) -> tuple[Prepared, Callable[[], Words]] | None:
    """What was kept under a digest, with the phrases by class, which few need; or None."""
    content = read_whole(cache / _NAME.format(digest=digest))
    if content is None:
        return None
    first, words, phrases = content.split(b"\n")
    rows: Any = json.loads(first)
    heads = [
        (str(name), refusal, dict(meanings), bool(derived))
        for name, refusal, meanings, derived in rows["heads"]
    ]
    return Prepared(heads, dict(rows["beginnings"]), words.decode()), lambda: json.loads(phrases)


def keep(cache: Path, digest: str, prepared: Prepared, phrases: Words) -> None:
    """A folder that cannot be written is no reason to fail."""
    file = cache / _NAME.format(digest=digest)
    first = json.dumps({"heads": list(prepared.heads), "beginnings": dict(prepared.beginnings)})
    with contextlib.suppress(OSError):
        cache.mkdir(parents=True, exist_ok=True)
        others = sorted(cache.glob(_NAME.format(digest="*")), key=lambda one: one.stat().st_mtime)
        for old in others[: -_KEPT + 1]:
            old.unlink()
        write_whole(file, "\n".join((first, prepared.words, json.dumps(phrases))).encode())
