"""Word classes written out once and kept from one process to the next.

Reading and inflecting the word lists takes longer than everything else that a process does that only
parses one sentence. What is kept is named by a digest of all that it was made of, so that it never is
out of date.
"""

from __future__ import annotations

import contextlib
import hashlib
import json
import os
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

_NAME = "vocabulary-{digest}.json"
_KEPT = 4
"""Files that are kept: a person may use several lists of words of their own in turn."""

Table = tuple[str, dict[str, list[str]], str | None, dict[str, str], bool]
"""A word class: name, phrases by meaning, refusal, readings of the refusal's meanings, whether derived."""


def digest_of(sources: Iterable[bytes]) -> str:
    """A name for what is made of some files: it changes when any of them does."""
    digest = hashlib.sha256()
    for source in sources:
        digest.update(len(source).to_bytes(8, "little"))
        digest.update(source)
    return digest.hexdigest()[:24]


def kept(cache: Path, digest: str) -> list[Table] | None:
    """The classes that were kept under a digest, or None."""
    try:
        rows: Any = json.loads((cache / _NAME.format(digest=digest)).read_text("utf-8"))
        return [
            (str(name), dict(words), refusal, dict(meanings), bool(derived))
            for name, words, refusal, meanings, derived in rows
        ]
    except (OSError, ValueError, TypeError):
        return None


def keep(cache: Path, digest: str, tables: Sequence[Table]) -> None:
    """Write the file whole or not at all; a folder that cannot be written is no reason to fail."""
    file = cache / _NAME.format(digest=digest)
    partial = file.with_suffix(f".{os.getpid()}.tmp")
    with contextlib.suppress(OSError):
        cache.mkdir(parents=True, exist_ok=True)
        others = sorted(cache.glob(_NAME.format(digest="*")), key=lambda one: one.stat().st_mtime)
        for old in others[: -_KEPT + 1]:
            old.unlink()
        partial.write_text(json.dumps(tables), "utf-8")
        partial.replace(file)
