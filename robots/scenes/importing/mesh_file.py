"""Reading a mesh file, whatever it is written in."""

from __future__ import annotations

import hashlib
import warnings
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array, Sealed
from robots.errors import CannotImportError
from robots.scenes.importing.extra import library
from robots.scenes.importing.seen_color import Surface, on_picture, seen_surface, small_png

ENDINGS = (".obj", ".stl", ".glb", ".gltf", ".ply", ".msh")
MOST_FACES = 2_000_000
_SHEET = 1e-9
_WHITE = (255, 255, 255)
"""Of a material that says nothing, as in glTF."""


@dataclass(frozen=True, slots=True)
class Mesh(Sealed):
    """Triangles, in the units and axes of the file.

    Attributes:
        vertices: Shape (n, 3).
        faces: Rows of them, shape (m, 3).
        on_picture: Where each vertex is on the picture, shape (n, 2); None without one.
        picture: PNG; empty without one.
        color: Red, green, blue in [0, 1].
        surface: What is seen of it; None where the file says nothing of colours.
        digest: Of the file.
    """

    vertices: Array
    faces: NDArray[np.int32]
    on_picture: Array | None
    picture: bytes
    color: tuple[float, float, float]
    surface: Surface | None
    digest: str


def read_mesh(file: Path) -> Mesh:
    """Read a mesh with what is seen on it.

    Raises:
        CannotImportError: The extra is missing, the file is no mesh, or has no surface.
    """
    if file.suffix.lower() not in ENDINGS:
        raise CannotImportError(f"{file}: is no mesh; known are {', '.join(ENDINGS)}")
    try:
        content = file.read_bytes()
    except OSError as absent:
        raise CannotImportError(f"{file}: cannot be read: {absent.strerror}") from absent
    trimesh = library("trimesh")
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of pictures with nothing on them
            found = _triangles(trimesh, file)
    except Exception as broken:
        raise CannotImportError(f"{file}: cannot be read as a mesh: {broken}") from broken
    faces = np.asarray(getattr(found, "faces", ()), np.int32)
    if not len(faces):
        raise CannotImportError(f"{file}: has no surface")
    if len(faces) > MOST_FACES:
        raise CannotImportError(f"{file}: has {len(faces)} triangles; at most {MOST_FACES} are read")
    vertices = np.asarray(found.vertices, np.float64)
    if not np.isfinite(vertices).all() or np.ptp(vertices, axis=0).max() <= _SHEET:
        raise CannotImportError(f"{file}: its points are no numbers, or all at one place")
    uv, picture, color = _looks(found.visual)
    surface = None
    if picture and uv is not None:
        surface = seen_surface(vertices, faces, on_picture(picture, uv[faces].mean(axis=1)))
    elif found.visual.defined:
        surface = seen_surface(vertices, faces, _face_colors(found.visual))
    return Mesh(vertices, faces, uv, picture, color, surface, hashlib.sha256(content).hexdigest())


def _triangles(trimesh: Any, file: Path) -> Any:
    """All of a file's geometry in one, placed as the file says."""
    loaded = trimesh.load_scene(file, process=False, maintain_order=True)
    if len(loaded.geometry) == 1 and len(loaded.graph.nodes_geometry) == 1:
        node = loaded.graph.nodes_geometry[0]
        transform, name = loaded.graph[node]
        only = loaded.geometry[name].copy()
        only.apply_transform(transform)
        return only
    return loaded.to_mesh()


def _face_colors(visual: Any) -> Array:
    """Of each triangle, or of all of them, red, green and blue in [0, 1]."""
    if _is_plain(visual):
        return np.array(_main_color(visual))
    plain = visual.to_color() if hasattr(visual, "to_color") else visual
    return np.asarray(plain.face_colors, np.float64)[:, :3] / 255.0


def _is_plain(visual: Any) -> bool:
    """Whether a material without a picture is all that is said."""
    return getattr(visual, "material", None) is not None and _image(visual) is None


def _image(visual: Any) -> Any:
    """The picture on it; None where there is none, or nothing says where on it."""
    material = getattr(visual, "material", None)
    if material is None or visual.uv is None:
        return None
    return getattr(material, "image", None) or getattr(material, "baseColorTexture", None)


def _main_color(visual: Any) -> tuple[float, float, float]:
    if _is_plain(visual):
        said = visual.material.main_color
        color = np.asarray(_WHITE if said is None else said, np.float64)[:3] / 255.0
        if hasattr(visual.material, "baseColorFactor"):  # glTF says how much light comes back
            color = np.where(color <= 0.0031308, 12.92 * color, 1.055 * color ** (1.0 / 2.4) - 0.055)
    else:
        plain = visual.to_color() if hasattr(visual, "to_color") else visual
        color = np.asarray(plain.main_color, np.float64)[:3] / 255.0
    red, green, blue = color.tolist()
    return red, green, blue


def _looks(visual: Any) -> tuple[Array | None, bytes, tuple[float, float, float]]:
    """Where each vertex is on the picture, the picture, and the colour without one."""
    color, image = _main_color(visual), _image(visual)
    if image is None:
        return None, b"", color
    return np.asarray(visual.uv, np.float64), small_png(image), color
