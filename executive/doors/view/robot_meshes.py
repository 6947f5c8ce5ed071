"""What a robot looks like, from its URDF: the visual solids of each link as triangles.

Meshes that cannot be read here (Collada) are left out, and a link that is then bare shows its collision
solids.
"""

from __future__ import annotations

import xml.etree.ElementTree as ElementTree
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import trimesh
from numpy.typing import NDArray

from kinematics.arrays import Sealed
from kinematics.geometry import poses
from kinematics.geometry.poses import Transform

_READABLE = (".stl", ".obj", ".ply")
_USUAL = (190, 196, 204)
_SIDES = 24
_LEAST, _PER_M2 = 80, 2500.0
"""So many triangles a mesh keeps, and as many more for each square metre: browsers draw it thirty times a
second, some of them without a graphics card."""


@dataclass(frozen=True, slots=True)
class LinkMesh(Sealed):
    """One solid of a link.

    Attributes:
        link: Its name.
        vertices: In the link's frame, m, shape (n, 3).
        faces: Triangles, as indices of vertices, shape (m, 3).
        rgb: Its colour, 0 to 255.
    """

    link: str
    vertices: NDArray[np.float32]
    faces: NDArray[np.uint32]
    rgb: tuple[int, int, int]


def link_meshes(urdf: str) -> list[LinkMesh]:
    """Every solid that is drawn of a robot.

    Args:
        urdf: Text of its URDF, paths of meshes absolute.
    """
    robot = ElementTree.fromstring(urdf)
    colors = {
        str(one.get("name")): rgba for one in robot.findall("material") if (rgba := _rgba(one)) is not None
    }
    made: list[LinkMesh] = []
    for link in robot.findall("link"):
        name = str(link.get("name"))
        drawn = list(_solids(name, link.findall("visual"), colors))
        made += drawn or list(_solids(name, link.findall("collision"), colors))
    return made


def _solids(
    link: str, elements: list[ElementTree.Element], colors: Mapping[str, tuple[int, int, int]]
) -> Iterator[LinkMesh]:
    for element in elements:
        mesh = _mesh(element.find("geometry"))
        if mesh is None:
            continue
        material = element.find("material")
        rgb = None if material is None else _rgba(material) or colors.get(str(material.get("name")))
        place = _origin(element.find("origin"))
        corners, faces = simplified(np.asarray(mesh.vertices), np.asarray(mesh.faces))
        vertices = corners @ place[:3, :3].T + place[:3, 3]
        yield LinkMesh(
            link,
            np.asarray(vertices, dtype=np.float32),
            np.asarray(faces, dtype=np.uint32),
            rgb or _USUAL,
        )


def simplified(
    vertices: NDArray[np.float64], faces: NDArray[np.int64]
) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    """A mesh with fewer triangles, by quadric edge collapse; a small one stays as it is.

    Args:
        vertices: In metres, shape (n, 3).
        faces: Indices of vertices, shape (m, 3).
    """
    mesh = trimesh.Trimesh(vertices, faces, process=False)
    wanted = int(_LEAST + _PER_M2 * mesh.area)
    if len(faces) <= wanted:
        return vertices, faces
    fewer = mesh.simplify_quadric_decimation(face_count=wanted)
    return np.asarray(fewer.vertices, dtype=np.float64), np.asarray(fewer.faces, dtype=np.int64)


def _mesh(geometry: ElementTree.Element | None) -> trimesh.Trimesh | None:
    """The triangles of a geometry, in its own frame; None where it is none, or cannot be read."""
    solid = None if geometry is None else next(iter(geometry), None)
    if solid is None:
        return None
    made: trimesh.Trimesh | None = None
    match solid.tag:
        case "box":
            made = trimesh.creation.box(_numbers(solid.get("size", "0 0 0")))
        case "sphere":
            made = trimesh.creation.icosphere(subdivisions=2, radius=float(solid.get("radius", 0.0)))
        case "cylinder":
            radius, length = float(solid.get("radius", 0.0)), float(solid.get("length", 0.0))
            made = trimesh.creation.cylinder(radius, length, sections=_SIDES)
        case "mesh":
            path = Path(solid.get("filename", ""))
            if path.suffix.lower() in _READABLE and path.is_file():
                made = trimesh.load_mesh(path)
                scale = _numbers(solid.get("scale", "1 1 1"))
                made.vertices = made.vertices * scale
                if np.prod(scale) < 0.0:  # a mirrored one would be inside out
                    made.invert()
    return made


def _origin(element: ElementTree.Element | None) -> Transform:
    if element is None:
        return np.eye(4)
    roll, pitch, yaw = _numbers(element.get("rpy", "0 0 0")).tolist()
    turn = poses.rotation_z(yaw) @ poses.rotation_y(pitch) @ poses.rotation_x(roll)
    x, y, z = _numbers(element.get("xyz", "0 0 0")).tolist()
    return poses.transform(turn, (x, y, z))


def _rgba(material: ElementTree.Element) -> tuple[int, int, int] | None:
    color = material.find("color")
    if color is None:
        return None
    r, g, b = (round(255 * min(max(one, 0.0), 1.0)) for one in _numbers(color.get("rgba", "1 1 1 1"))[:3])
    return r, g, b


def _numbers(text: str) -> NDArray[np.float64]:
    return np.array([float(one) for one in text.split()])
