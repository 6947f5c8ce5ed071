"""The Panda as files that every planner can read: one convex hull a link, fingers fixed open.

Made from the URDF of the example-robot-data package. All planners get the same solids, as hulls that
are declared convex, so that nobody pays for triangle meshes.
"""

from __future__ import annotations

import importlib.metadata
import re
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass
from pathlib import Path

import coal
import numpy as np
from numpy.typing import NDArray

JOINTS = tuple(f"panda_joint{i}" for i in range(1, 8))
TCP_FRAME = "panda_hand_tcp"
# Each finger's way out; the hand stays open while it moves.
OPENING_M = 0.04
_FOLDER = "panda_description"


@dataclass(frozen=True, slots=True)
class RobotFiles:
    """Where the robot's description lies.

    Attributes:
        urdf: The URDF, with absolute names of hull meshes.
        srdf: Pairs of links that are never judged.
    """

    urdf: Path
    srdf: Path


def write_panda(folder: Path) -> RobotFiles:
    """Write URDF, SRDF and hull meshes into a folder."""
    source = _source()
    folder.mkdir(parents=True, exist_ok=True)
    root = ElementTree.fromstring((source / "urdf" / "panda.urdf").read_text("utf-8"))
    for link in root.findall("link"):
        for visual in link.findall("visual"):
            link.remove(visual)
        _replace_meshes(link, source, folder)
    for joint in root.findall("joint"):
        if str(joint.get("name")).startswith("panda_finger_joint"):
            _fix_open(joint)
    files = RobotFiles(folder / "panda.urdf", folder / "panda.srdf")
    files.urdf.write_text(ElementTree.tostring(root, encoding="unicode"), "utf-8")
    files.srdf.write_text(_srdf(source), "utf-8")
    return files


def _source() -> Path:
    for file in importlib.metadata.files("example-robot-data") or []:
        if _FOLDER in file.parts and file.name == "panda.urdf":
            return Path(str(file.locate())).resolve().parents[1]
    raise FileNotFoundError(f"the package example-robot-data has no {_FOLDER}")


def _replace_meshes(link: ElementTree.Element, source: Path, folder: Path) -> None:
    declared = ElementTree.SubElement(link, "collision_checking")
    for collision in link.findall("collision"):
        mesh = collision.find("geometry/mesh")
        if mesh is None:
            continue
        file = folder / Path(str(mesh.get("filename"))).name
        _write_hull(source / "meshes" / "collision" / file.name, file)
        mesh.set("filename", str(file))
        # Pinocchio's extension of the URDF: without it the mesh is a soup of triangles to Coal
        collision.set("name", "hull")
        ElementTree.SubElement(declared, "convex", name="hull")


def _fix_open(joint: ElementTree.Element) -> None:
    sign = 1.0 if str(joint.get("name")).endswith("1") else -1.0
    joint.set("type", "fixed")
    origin = joint.find("origin")
    assert origin is not None
    x, y, z = (float(value) for value in str(origin.get("xyz")).split())
    origin.set("xyz", f"{x} {y + sign * OPENING_M} {z}")
    for tag in ("axis", "limit", "mimic", "dynamics"):
        for element in joint.findall(tag):
            joint.remove(element)


def _srdf(source: Path) -> str:
    text = (source / "srdf" / "panda.srdf").read_text("utf-8")
    pairs = re.findall(r"<disable_collisions .*?/>", text)
    arm = "".join(f'<joint name="{name}"/>' for name in JOINTS)
    return f'<robot name="panda"><group name="arm">{arm}</group>{"".join(pairs)}</robot>\n'


def _write_hull(mesh: Path, file: Path) -> None:
    """Write the convex hull of a mesh as an STL in text."""
    solid = coal.MeshLoader().load(str(mesh), np.ones(3))
    solid.buildConvexHull(True, "Qt")
    hull = solid.convex
    points: NDArray[np.float64] = np.array(hull.points())
    centre = points.mean(axis=0)
    lines = ["solid hull"]
    for i in range(hull.num_polygons):
        corners = points[[hull.polygons(i)[k] for k in range(3)]]
        normal = np.cross(corners[1] - corners[0], corners[2] - corners[0])
        if normal @ (corners[0] - centre) < 0.0:
            corners, normal = corners[::-1], -normal
        length = float(np.linalg.norm(normal))
        lines.append("facet normal " + " ".join(f"{v:.9g}" for v in normal / (length or 1.0)))
        lines.append(" outer loop")
        lines += ["  vertex " + " ".join(f"{v:.9g}" for v in corner) for corner in corners]
        lines += [" endloop", "endfacet"]
    file.write_text("\n".join([*lines, "endsolid hull", ""]), "utf-8")
