"""Compiled code that goes to another machine with the first order, so that it need not be compiled there."""

from __future__ import annotations

import io
import shutil
import tempfile
import zipfile
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from kinematics.compiled.cache import folder, is_complete

NOTHING = np.empty(0, np.uint8)


def packed_kernel() -> NDArray[np.uint8]:
    """The compiled code of this machine as the bytes of a zip (uint8); empty when there is none."""
    place = folder()
    if place is None or not is_complete():
        return NOTHING
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w", zipfile.ZIP_DEFLATED) as out:
        for file in sorted(file for file in place.rglob("*") if file.is_file()):
            out.write(file, file.relative_to(place))
    return np.frombuffer(packed.getbuffer(), np.uint8)


def unpack_kernel(packed: NDArray[np.uint8]) -> None:
    """Put compiled code where this machine looks for it, unless it has its own.

    What was compiled for another kind of processor counts as not compiled, as always.

    Args:
        packed: As ``packed_kernel`` gave it.
    """
    if packed.size and not is_complete():
        place = folder()
        if place is not None:
            _unpack(packed, place)


def _unpack(packed: NDArray[np.uint8], place: Path) -> None:
    """Unpack beside the place and rename file by file: another process may be at the same."""
    with tempfile.TemporaryDirectory(dir=place.parent) as beside:
        with zipfile.ZipFile(io.BytesIO(packed.tobytes())) as archive:
            archive.extractall(beside)
        for file in sorted(file for file in Path(beside).rglob("*") if file.is_file()):
            there = place / file.relative_to(beside)
            there.parent.mkdir(parents=True, exist_ok=True)
            shutil.move(file, there)
