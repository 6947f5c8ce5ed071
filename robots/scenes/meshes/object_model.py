"""An object as it was imported from a mesh, and the file that it is kept in; numpy reads it."""

from __future__ import annotations

import functools
import hashlib
import io
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array, Sealed
from kinematics.geometry.convex_parts import ConvexParts
from kinematics.geometry.shapes import Ball, Box, Cylinder, Shape
from kinematics.whole_file import read_whole, write_whole
from robots.scenes.meshes.up_axis import Up, name_of

ENDING = ".model"
"""What the name of the mesh's file has behind it."""


VERSION = 1
"""Of the way in which objects are made: another one makes others of the same mesh."""
_SAME = 1e-9
GREY = (0.6, 0.6, 0.6)


class NoModelError(ValueError):
    """A file that holds no object that was imported; the message says why."""


@dataclass(frozen=True, slots=True)
class ObjectModel(Sealed):
    """What an object looks like and what it is made of, in its own frame: centred, z up.

    Attributes:
        outline: The box, cylinder or ball that holds it, with its convex parts.
        vertices: Of what is seen of it, shape (n, 3), m.
        faces: Triangles of them, shape (m, 3).
        on_picture: Where each vertex is on its picture, shape (n, 2), from the lower left; None without one.
        picture: The file of its picture, PNG; empty without one.
        color: Its colour where it has no picture: red, green and blue in [0, 1].
    """

    outline: Shape
    vertices: Array
    faces: NDArray[np.int32]
    on_picture: Array | None = None
    picture: bytes = b""
    color: tuple[float, float, float] = GREY

    @property
    def parts(self) -> ConvexParts:
        """What it is made of."""
        if self.outline.parts is None:
            raise NoModelError("an object of no parts")
        return self.outline.parts

    def scaled(self, factor: float) -> ObjectModel:
        """The same, so many times as large."""
        if factor == 1.0:
            return self
        parts = self.parts
        grown = replace(
            parts,
            key=f"{parts.key} x {factor!r}",
            corners=factor * parts.corners,
            surface=factor * parts.surface,
            outline_error_m=factor * parts.outline_error_m,
        )
        return replace(self, outline=resized(self.outline, factor, grown), vertices=factor * self.vertices)

    def scaled_to(self, outline: Shape) -> Shape:
        """An outline with its parts, where it is this object's, of any size; else the outline as it is."""
        factor = outline.height_m / self.outline.height_m
        grown = self.scaled(factor if abs(factor - 1.0) > _SAME else 1.0).outline
        return grown if _alike(grown, outline) else outline


def _alike(one: Shape, other: Shape) -> bool:
    """Whether two outlines are of one size."""
    if type(one) is not type(other):
        return False
    return bool(np.allclose(_sizes(one), _sizes(other), rtol=_SAME))


def _sizes(outline: Shape) -> tuple[float, ...]:
    return outline.size_m if isinstance(outline, Box) else (outline.radius_m, outline.height_m)


def resized(outline: Shape, factor: float, parts: ConvexParts) -> Shape:
    """An outline that is so many times as large, about other parts."""
    if isinstance(outline, Box):
        x, y, z = (factor * value for value in outline.size_m)
        return Box((x, y, z), parts)
    if isinstance(outline, Cylinder):
        return Cylinder(factor * outline.radius_m, factor * outline.height_m, parts)
    return Ball(factor * outline.radius_m, parts)


def model_file(mesh: Path) -> Path:
    """Where the object that was made of a mesh is kept."""
    return mesh.with_name(mesh.name + ENDING)


def write_model(model: ObjectModel, file: Path) -> None:
    """Keep an object.

    Raises:
        OSError: The file cannot be written.
    """
    parts, outline = model.parts, model.outline
    content = io.BytesIO()
    np.savez_compressed(
        content,
        key=np.array(parts.key),
        outline=np.array(type(outline).__name__),
        sizes=np.array(_sizes(outline)),
        outline_error_m=np.array(parts.outline_error_m),
        corners=parts.corners,
        ends=np.array(parts.ends),
        surface=parts.surface,
        normals=parts.normals,
        rests=parts.rests,
        vertices=model.vertices,
        faces=model.faces,
        on_picture=np.zeros((0, 2)) if model.on_picture is None else model.on_picture,
        picture=np.frombuffer(model.picture, np.uint8),
        color=np.array(model.color),
    )
    write_whole(file, content.getvalue())


def read_model(file: Path) -> ObjectModel:
    """What was kept; the same file is read once.

    Raises:
        NoModelError: It is not there, is damaged, or was made by another version.
    """
    try:
        changed = file.stat()
    except OSError as absent:
        raise NoModelError(f"there is no {file.name}") from absent
    return _read(file, changed.st_mtime_ns, changed.st_size)


@functools.lru_cache(maxsize=256)
def _read(file: Path, changed_ns: int, size: int) -> ObjectModel:  # noqa: ARG001
    content = read_whole(file)
    if content is None:
        raise NoModelError(f"{file.name} is damaged")
    try:
        with np.load(io.BytesIO(content), allow_pickle=False) as kept:
            return _model(kept, file)
    except (KeyError, ValueError, OSError) as other:
        raise NoModelError(f"{file.name} was written by another version") from other


def _model(kept: Any, file: Path) -> ObjectModel:
    parts = ConvexParts(
        key=str(kept["key"]),
        corners=kept["corners"],
        ends=tuple(kept["ends"].tolist()),
        surface=kept["surface"],
        normals=kept["normals"],
        rests=kept["rests"],
        outline_error_m=float(kept["outline_error_m"]),
        file=str(file.absolute()),
    )
    sizes = kept["sizes"].tolist()
    outline: Shape
    match str(kept["outline"]):
        case "Box":
            outline = Box((sizes[0], sizes[1], sizes[2]), parts)
        case "Cylinder":
            outline = Cylinder(sizes[0], sizes[1], parts)
        case _:
            outline = Ball(sizes[0], parts)
    red, green, blue = kept["color"].tolist()
    on_picture = kept["on_picture"]
    return ObjectModel(
        outline=outline,
        vertices=kept["vertices"],
        faces=kept["faces"],
        on_picture=on_picture if len(on_picture) else None,
        picture=kept["picture"].tobytes(),
        color=(red, green, blue),
    )


def digest_of(mesh: Path) -> str:
    """Of a mesh file.

    Raises:
        OSError: It cannot be read.
    """
    return hashlib.sha256(mesh.read_bytes()).hexdigest()


def model_key(digest: str, scale: float, up: Up, turn_rad: float) -> str:
    """Digest of a mesh and of what was said of it; as files round numbers."""
    told = (VERSION, digest, round(scale, 6), _rounded(name_of(up)), round(turn_rad, 6))
    return hashlib.sha256(repr(told).encode()).hexdigest()[:24]


def _rounded(up: str | list[float]) -> str | list[float]:
    return up if isinstance(up, str) else [round(value, 4) for value in up]
