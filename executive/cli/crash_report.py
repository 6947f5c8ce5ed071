"""What is kept of a defect, so that it can be mended; the user sees one line."""

from __future__ import annotations

import platform
import sys
import tempfile
import traceback
from pathlib import Path

from executive.config import crashes_directory
from robots.clock import utc_timestamp


def write_crash_report(raised: BaseException) -> Path | None:
    """Write down the exception, the command and the versions; return where, or None if nowhere can be."""
    name = f"crash-{utc_timestamp().replace(':', '-')}.txt"
    text = "\n".join(
        [
            f"command: {sys.argv!r}",
            f"python: {sys.version}",
            f"platform: {platform.platform()}",
            "",
            *traceback.format_exception(raised),
        ]
    )
    for folder in (crashes_directory(), Path(tempfile.gettempdir())):
        path = folder / name
        try:
            folder.mkdir(parents=True, exist_ok=True)
            path.write_text(text, "utf-8", "backslashreplace")
        except OSError:
            continue
        return path
    return None
