"""Making a URDF one that the simulator reads: it knows no packages, and refuses what weighs nothing."""

from __future__ import annotations

import xml.etree.ElementTree as ElementTree
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from robots.errors import CannotImportError
from robots.scenes.importing.extra import library
from robots.scenes.importing.mesh_file import Mesh, read_mesh
from robots.scenes.importing.seen_color import said_color
from robots.scenes.scene_words import COLORS

LEAST_MASS_KG, LEAST_INERTIA = 1e-4, 1e-9
"""Of what says that it weighs nothing, or says nothing, kg and kg m2."""
_INERTIA = 1e-3
"""Of a link whose own is none, m2."""
_SHAPES = ("box", "cylinder", "sphere", "capsule", "mesh")
_PACKAGE, _FILE = "package://", "file://"
_MOMENTS = ("ixx", "iyy", "izz")
_PRODUCTS = ("ixy", "ixz", "iyz")


def make_readable(root: ElementTree.Element, file: Path) -> tuple[list[str], dict[str, bytes]]:
    """Change a URDF so that nothing of it is lost when the simulator reads it.

    Every link is a body of its own, with its mass and what is seen of it. Meshes are read here: of a file of
    several meshes the simulator takes the first, and it knows few kinds.

    Returns:
        What had to be mended, and the meshes, by the names that the changed URDF has for them.

    Raises:
        CannotImportError: A solid's mesh is not there, or cannot be read.
    """
    told: list[str] = []
    meshes: dict[str, bytes] = {}
    for link in root.iter("link"):
        told += [*_known_solids(link, file, meshes), *_sound_mass(link)]
    compiler = _child(_child(root, "mujoco"), "compiler")
    compiler.attrib.pop("meshdir", None)
    compiler.attrib |= {"fusestatic": "false", "discardvisual": "false", "strippath": "false"}
    compiler.attrib |= {"balanceinertia": "true", "boundmass": str(LEAST_MASS_KG)}
    compiler.attrib["boundinertia"] = str(LEAST_INERTIA)
    return list(dict.fromkeys(told)), meshes


def _known_solids(link: ElementTree.Element, file: Path, meshes: dict[str, bytes]) -> Iterator[str]:
    """Leave out solids of unknown shape and looks that nobody can read; add the meshes of the others."""
    for kind in ("visual", "collision"):
        for item in link.findall(kind):
            shape = next((each for each in item.iterfind("geometry/*") if each.tag in _SHAPES), None)
            if shape is None:
                link.remove(item)
                yield f"a {kind} of {link.get('name')!r} of a shape that nobody knows was left out"
                continue
            if shape.tag != "mesh":
                continue
            try:
                mesh = read_mesh(_found(shape.get("filename", ""), file))
            except CannotImportError as missing:
                if kind == "collision":
                    raise
                link.remove(item)
                yield f"what is seen of {link.get('name')!r} was left out: {missing}"
                continue
            name = f"mesh_{len(meshes)}.stl"
            meshes[name] = _stl(mesh)
            shape.set("filename", name)
            if kind == "visual" and item.find("material") is None:
                _color(item, mesh)


def _stl(mesh: Mesh) -> bytes:
    content = library("trimesh").Trimesh(mesh.vertices, mesh.faces, process=False).export(file_type="stl")
    return bytes(content)


def _found(named: str, file: Path) -> Path:
    """Where a mesh is; a package is looked for in the folders around the file.

    Raises:
        CannotImportError: Nowhere.
    """
    name = named.removeprefix(_FILE)
    folders = [file.absolute().parent]
    if name.startswith(_PACKAGE):
        package, _, name = name.removeprefix(_PACKAGE).partition("/")
        around = folders[0].parents
        folders += [each / package for each in (folders[0], *around)]
        folders += [each for each in around if each.name == package]
    places = [*(folder / name for folder in folders), folders[0] / Path(name).name]
    for place in places:
        if place.is_file():
            return place
    raise CannotImportError(f"{file}: its mesh {named!r} is not there")


def _color(visual: ElementTree.Element, mesh: Mesh) -> None:
    """Give what is seen the colour that most of its mesh has, where the mesh says one."""
    said = said_color(mesh.surface) if mesh.surface is not None else None
    if said is not None:
        rgba = " ".join(f"{value:.4f}" for value in (*COLORS[said[0]], 1.0))
        ElementTree.SubElement(ElementTree.SubElement(visual, "material", name=""), "color", rgba=rgba)


def _sound_mass(link: ElementTree.Element) -> list[str]:
    """A mass and an inertia that a body can have."""
    inertial = _child(link, "inertial")
    mass, inertia = _child(inertial, "mass"), _child(inertial, "inertia")
    said = _number(mass, "value")
    moments, products = ([_number(inertia, key) for key in keys] for keys in (_MOMENTS, _PRODUCTS))
    matrix = np.diag(moments)
    matrix[[0, 0, 1], [1, 2, 2]] = matrix[[1, 2, 2], [0, 0, 1]] = products
    mass.set("value", str(max(said, LEAST_MASS_KG)))
    if np.linalg.eigvalsh(matrix).min() > 0.0 and said > 0.0:
        return []
    own = max(_INERTIA * said, LEAST_INERTIA)
    inertia.attrib |= {key: str(own) for key in _MOMENTS} | dict.fromkeys(_PRODUCTS, "0")
    return [f"the inertia of {link.get('name')!r} was none"] if said > 0.0 else []


def _child(parent: ElementTree.Element, tag: str) -> ElementTree.Element:
    """The first of this tag, made where there is none."""
    found = parent.find(tag)
    return ElementTree.SubElement(parent, tag) if found is None else found


def _number(item: ElementTree.Element, key: str) -> float:
    try:
        value = float(item.get(key, "0"))
    except ValueError:
        return 0.0
    return value if np.isfinite(value) else 0.0
