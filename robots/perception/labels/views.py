"""Views of things that somebody showed: a picture file each, in a folder for each name."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import InFloat64
from robots.perception.labels.labeller import Boxes, Image

MOST_VIEWS = 64
"""Of one thing."""
_ROOM_PX = 2
_NAME_FILE = "name.txt"


@dataclass(frozen=True, slots=True)
class View(InFloat64):
    """One thing from one side.

    Attributes:
        color: Red, green, blue as in daylight, shape (height, width, 3).
        mask: Where the thing is in it, shape (height, width).
    """

    color: Image
    mask: NDArray[np.bool_]


def view_of(image: Image, boxes: Boxes, k: int) -> View:
    """The part of a picture that shows one thing, with holes of its mask closed."""
    left, top, right, bottom = boxes.places[k].tolist()
    rows, columns = image.shape[:2]
    left, top = max(left - _ROOM_PX, 0), max(top - _ROOM_PX, 0)
    right, bottom = min(right + _ROOM_PX, columns), min(bottom + _ROOM_PX, rows)
    mask = (boxes.pieces[top:bottom, left:right] == k + 1).astype(np.uint8)
    closed = cv2.morphologyEx(mask, cv2.MORPH_CLOSE, np.ones((7, 7), np.uint8)) > 0
    others = boxes.pieces[top:bottom, left:right]
    closed &= (others == 0) | (others == k + 1)
    return View(image[top:bottom, left:right].copy(), closed)


def folder_name(name: str) -> str:
    """The folder of a name: its letters and digits."""
    return re.sub(r"[^a-z0-9]+", "-", name.casefold()).strip("-") or "thing"


def keep_views(folder: Path, name: str, views: Sequence[View]) -> int:
    """Add views to those that are kept of a thing; the oldest go when there are too many.

    Args:
        folder: Of all things that were shown.
        name: What people call the thing.
        views: Of it.

    Returns:
        How many are kept of it now.
    """
    own = folder / folder_name(name)
    own.mkdir(parents=True, exist_ok=True)
    (own / _NAME_FILE).write_text(name + "\n", "utf-8")
    files = _files(own)
    number = int(files[-1].stem.rpartition("-")[2]) if files else 0
    for view in views:
        number += 1
        pixels = np.dstack([view.color[..., ::-1], np.where(view.mask, 255, 0).astype(np.uint8)])
        ok, packed = cv2.imencode(".png", pixels)
        if ok:
            (own / f"view-{number:04d}.png").write_bytes(packed.tobytes())
    files = _files(own)
    for old in files[:-MOST_VIEWS]:
        old.unlink()
    return min(len(files), MOST_VIEWS)


def forget_views(folder: Path, name: str) -> int:
    """Remove all views of a thing; tells how many there were."""
    own = folder / folder_name(name)
    files = _files(own)
    for file in files:
        file.unlink()
    (own / _NAME_FILE).unlink(missing_ok=True)
    if own.is_dir() and not any(own.iterdir()):
        own.rmdir()
    return len(files)


def known_names(folder: Path) -> dict[str, int]:
    """What was shown, and how many views are kept of each; in order of the names."""
    found = {}
    for own in sorted(folder.glob("*/")) if folder.is_dir() else []:
        if count := len(_files(own)):
            found[_name_in(own)] = count
    return dict(sorted(found.items()))


def kept_views(folder: Path) -> dict[str, list[View]]:
    """All views by the names of what they show; a file that is no picture of ours is left out."""
    found: dict[str, list[View]] = {}
    for own in sorted(folder.glob("*/")) if folder.is_dir() else []:
        views = [view for file in _files(own) if (view := _read(file)) is not None]
        if views:
            found[_name_in(own)] = views
    return dict(sorted(found.items()))


def _files(own: Path) -> list[Path]:
    return sorted(own.glob("view-[0-9][0-9][0-9][0-9].png")) if own.is_dir() else []


def _name_in(own: Path) -> str:
    try:
        return (own / _NAME_FILE).read_text("utf-8").strip() or own.name
    except (OSError, UnicodeDecodeError):
        return own.name.replace("-", " ")


def _read(file: Path) -> View | None:
    pixels = cv2.imdecode(np.frombuffer(file.read_bytes(), np.uint8), cv2.IMREAD_UNCHANGED)
    if pixels is None or pixels.ndim != 3 or pixels.shape[2] != 4 or not (pixels[..., 3] > 127).any():
        return None
    return View(np.ascontiguousarray(pixels[..., 2::-1]), np.asarray(pixels[..., 3] > 127))
