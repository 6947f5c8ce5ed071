"""The files that hold the motion of one run: several where what recorded was killed and begun anew."""

from __future__ import annotations

from pathlib import Path

SUFFIX = ".mcap"
_FIRST = "motion"


class MotionParts:
    """The files of a run's folder.

    Args:
        folder: Of the run.
    """

    def __init__(self, folder: Path) -> None:
        self._folder = folder

    def all(self) -> list[Path]:
        """Those that are there, the oldest first; none where the run's motion was not recorded."""
        return sorted(self._folder.glob(f"{_FIRST}*{SUFFIX}"), key=_number)

    def next(self) -> Path:
        """Where the next one goes."""
        there = self.all()
        number = _number(there[-1]) + 1 if there else 1
        return self._folder / (f"{_FIRST}{SUFFIX}" if number == 1 else f"{_FIRST}_{number}{SUFFIX}")


def _number(path: Path) -> int:
    told = path.stem.removeprefix(_FIRST).lstrip("_")
    return int(told) if told.isdigit() else 1
