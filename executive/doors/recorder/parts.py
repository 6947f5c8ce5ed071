"""The files that hold the motion of one run: several where what recorded was killed and begun anew."""

from __future__ import annotations

from pathlib import Path

SUFFIX = ".mcap"
_FIRST = "motion"


def parts_of(folder: Path) -> list[Path]:
    """The files of a run's folder, the oldest first; none where its motion was not recorded."""
    return sorted(folder.glob(f"{_FIRST}*{SUFFIX}"), key=_number)


def next_part(folder: Path) -> Path:
    """Where the next file of a run goes."""
    parts = parts_of(folder)
    number = _number(parts[-1]) + 1 if parts else 1
    return folder / (f"{_FIRST}{SUFFIX}" if number == 1 else f"{_FIRST}_{number}{SUFFIX}")


def _number(path: Path) -> int:
    told = path.stem.removeprefix(_FIRST).lstrip("_")
    return int(told) if told.isdigit() else 1
