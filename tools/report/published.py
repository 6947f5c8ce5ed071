"""Writes the report's folder: records, pages, pictures, and nothing else."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path

from tools.report import record as records
from tools.report.pages import pages
from tools.report.pictures import pictures
from tools.report.quotes import with_quotes
from tools.report.record import MeasuredRecord

RECORDS, PICTURES = "records", "pictures"


def publish(found: Sequence[MeasuredRecord], folder: Path, readme: Path | None = None) -> list[Path]:
    """Make a folder whole: what is not of these records goes.

    Args:
        found: The records of one report.
        folder: Such as ``docs/measured``.
        readme: A page that quotes from it, or None.

    Returns:
        The files that are new or have changed.

    Raises:
        UserError: matplotlib is not installed.
    """
    found = sorted(found, key=lambda record: record.name)  # pages do not tell which run came first
    made = {folder / name: text for name, text in pages(found).items()}
    made |= {folder / PICTURES / name: text for name, text in pictures(found).items()}
    if readme is not None:
        made[readme] = with_quotes(readme.read_text("utf-8"), found)
    kept = {records.write(record, folder / RECORDS) for record in found}
    changed = [file for file, text in made.items() if _written(file, text)]
    for file in _of_the_report(folder):
        if file not in made and file not in kept:
            file.unlink()
    return changed


def _of_the_report(folder: Path) -> Iterable[Path]:
    yield from folder.glob("*.md")
    yield from (folder / PICTURES).glob("*.svg")
    yield from (folder / RECORDS).glob("*.json")


def _written(file: Path, text: str) -> bool:
    if file.exists() and file.read_text("utf-8") == text:
        return False
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text, "utf-8")
    return True
