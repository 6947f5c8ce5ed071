"""The file of a picture that is on an object of a scene."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from kinematics.geometry.shapes import Ball, Shape
from robots.errors import SceneError

ENDINGS = (".png", ".jpg", ".jpeg")
_LARGEST_BYTES = 20_000_000


def picture_file(told: str, shape: Shape, source: str, fail: Callable[[str, str], SceneError]) -> str:
    """The path of a picture.

    Args:
        told: As the scene has it; relative to the scene's file.
        shape: Of what it is on.
        source: The scene's file.
        fail: Makes an error of a key and a reason.

    Raises:
        SceneError: There is no such file, it is no picture, or the object can carry none.
    """
    if isinstance(shape, Ball):
        raise fail("texture", "is for boxes and for what is round and upright; a ball carries no picture")
    if not told.lower().endswith(ENDINGS):
        raise fail("texture", f"must be a picture ({', '.join(ENDINGS)}), not {told!r}")
    path = Path(told)
    if not path.is_absolute():
        path = Path(source).absolute().parent / path
    try:
        size = path.stat().st_size
    except OSError:
        near = sorted(one.name for one in path.parent.glob("*") if one.suffix.lower() in ENDINGS)[:5]
        there = f"; there are {', '.join(near)}" if near else ""
        raise fail("texture", f"there is no file {path}{there}") from None
    if size > _LARGEST_BYTES:
        raise fail("texture", f"{path} is larger than {_LARGEST_BYTES} bytes")
    return str(path)
