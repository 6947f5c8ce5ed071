"""What takes long to make and is kept from one process to the next, under a digest of all it was made of."""

from __future__ import annotations

import contextlib
import hashlib
import json
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

from kinematics.whole_file import read_whole, write_whole

_MOST = 4
"""Files of one name that are kept: a person may use several lists of words of their own in turn."""


def kept(cache: Path, name: str, sources: Iterable[bytes], make: Callable[[], Any]) -> Any:
    """What was made of some sources before, or what is made now; the folder need not be writable.

    Args:
        cache: The folder.
        name: Of what is kept.
        sources: All that it is made of: when one of them changes it is made anew.
        make: Makes it, as plain JSON.
    """
    digest = hashlib.sha256()
    for source in sources:
        digest.update(len(source).to_bytes(8, "little") + source)
    file = cache / f"{name}-{digest.hexdigest()[:24]}.kept"
    content = read_whole(file)
    if content is not None:
        return json.loads(content)
    made = make()
    with contextlib.suppress(OSError):
        cache.mkdir(parents=True, exist_ok=True)
        others = sorted(cache.glob(f"{name}-*.kept"), key=lambda one: one.stat().st_mtime)
        for old in others[: -_MOST + 1]:
            old.unlink()
        write_whole(file, json.dumps(made).encode())
    return made
