"""A robot's URDF, made fit for use: mesh paths, frames and collision shapes of its data, joints held fast."""

from __future__ import annotations

import copy
import math
import re
import xml.etree.ElementTree as ElementTree
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from kinematics.geometry import poses
from kinematics.geometry.poses import Transform
from robots.errors import DescriptionError

Table = Mapping[str, Any]


def read_urdf(path: Path, root: Path) -> ElementTree.Element:
    """Parse a URDF of the robots' data, without what is meant for other simulators.

    Args:
        path: The file.
        root: Folder that its mesh paths begin at, ``package://`` that of the package's name in it; they
            become absolute. Other paths begin at the file.

    Raises:
        DescriptionError: There is no such file, or it is no URDF.
    """
    if not path.is_file():
        raise DescriptionError(f"[source] urdf: there is no {path}")
    text = re.sub(r"package:///?example-robot-data/robots/", f"{root}/", path.read_text("utf-8"))
    try:
        urdf = ElementTree.fromstring(text)
    except ElementTree.ParseError as broken:
        raise DescriptionError(f"[source] urdf: {path} is no URDF: {broken}") from broken
    for mesh in urdf.iter("mesh"):
        name = mesh.get("filename", "")
        if name.startswith("package://"):
            mesh.set("filename", f"{root}/{name.removeprefix('package://').lstrip('/')}")
        elif name and not name.startswith("/"):
            mesh.set("filename", str((path.parent / name.removeprefix("file://")).resolve()))
    for tag in ("gazebo", "transmission"):
        for element in urdf.findall(tag):
            urdf.remove(element)
    return urdf


def add_frame(urdf: ElementTree.Element, name: str, link: str, place: Table) -> None:
    """Add a link without a body, fixed to another at ``xyz`` (m) and ``rpy`` (rad)."""
    ElementTree.SubElement(urdf, "link", name=name)
    joint = ElementTree.SubElement(urdf, "joint", name=f"{name}_joint", type="fixed")
    ElementTree.SubElement(joint, "parent", link=link)
    ElementTree.SubElement(joint, "child", link=name)
    _add_origin(joint, place)


def add_collision_box(urdf: ElementTree.Element, link: str, place: Table) -> None:
    """Give a link one more collision shape: a box of ``size_m`` at ``xyz`` and ``rpy``.

    With ``drawn`` it is to be seen as well; with ``instead`` it takes the place of the link's own shapes.

    Raises:
        DescriptionError: There is no such link.
    """
    element = next((item for item in urdf.findall("link") if item.get("name") == link), None)
    if element is None:
        raise DescriptionError(f"the URDF has no link {link!r} for a collision box")
    if place.get("instead"):
        for shape in element.findall("collision"):
            element.remove(shape)
    for part in ("collision", "visual") if place.get("drawn") else ("collision",):
        shape = ElementTree.SubElement(element, part)
        _add_origin(shape, place)
        geometry = ElementTree.SubElement(shape, "geometry")
        ElementTree.SubElement(geometry, "box", size=" ".join(map(str, place["size_m"])))


def _add_origin(element: ElementTree.Element, place: Table) -> None:
    xyz, rpy = place.get("xyz", (0.0, 0.0, 0.0)), place.get("rpy", (0.0, 0.0, 0.0))
    ElementTree.SubElement(element, "origin", xyz=" ".join(map(str, xyz)), rpy=" ".join(map(str, rpy)))


def with_fixed_joints(
    urdf: ElementTree.Element, pattern: str, positions: Mapping[str, float]
) -> ElementTree.Element:
    """Copy a URDF with some joints held fast.

    Args:
        urdf: Stays as it is.
        pattern: Which joints, as a regular expression of their names.
        positions: Where they stand, by name; joints that mimic one follow it, all others stand at 0.
    """
    fixed = copy.deepcopy(urdf)
    for joint in fixed.findall("joint"):
        if not re.fullmatch(pattern, joint.get("name", "")):
            continue
        position = _position(joint, positions)
        if position != 0.0:  # else the numbers of the file stay as they are written
            _displace(joint, position)
        joint.set("type", "fixed")
        for tag in ("mimic", "limit", "dynamics"):
            for element in joint.findall(tag):
                joint.remove(element)
    return fixed


def _position(joint: ElementTree.Element, positions: Mapping[str, float]) -> float:
    mimic = joint.find("mimic")
    if mimic is None:
        return positions.get(joint.get("name", ""), 0.0)
    followed = positions.get(mimic.get("joint", ""), 0.0)
    return float(mimic.get("multiplier", "1")) * followed + float(mimic.get("offset", "0"))


def _displace(joint: ElementTree.Element, position: float) -> None:
    """Put the motion of a joint into its origin."""
    origin, axis = joint.find("origin"), joint.find("axis")
    if origin is None:
        origin = ElementTree.SubElement(joint, "origin")
    along = np.array([1.0, 0.0, 0.0]) if axis is None else np.array(_numbers(axis.get("xyz", "1 0 0")))
    along /= np.linalg.norm(along)
    place = pose_of(_numbers(origin.get("xyz", "0 0 0")), _numbers(origin.get("rpy", "0 0 0")))
    if joint.get("type") == "prismatic":
        place = place @ poses.translation(*(along * position))
    else:
        place = place @ poses.transform(poses.rotation_from_vector(along * position), np.zeros(3))
    origin.set("xyz", " ".join(repr(float(value)) for value in place[:3, 3]))
    origin.set("rpy", " ".join(repr(value) for value in _roll_pitch_yaw(place)))


def pose_of(xyz: Sequence[float], rpy: Sequence[float]) -> Transform:
    """Transform of a URDF's origin: roll, pitch, yaw about fixed axes."""
    roll, pitch, yaw = rpy
    turn = poses.rotation_z(yaw) @ poses.rotation_y(pitch) @ poses.rotation_x(roll)
    return poses.transform(turn, xyz)


def _roll_pitch_yaw(pose: Transform) -> tuple[float, float, float]:
    r = pose[:3, :3]
    pitch = math.atan2(-r[2, 0], math.hypot(r[0, 0], r[1, 0]))
    if math.hypot(r[0, 0], r[1, 0]) < 1e-9:  # roll and yaw turn about the same axis: all of it is roll
        return math.atan2(-r[1, 2], r[1, 1]), pitch, 0.0
    return math.atan2(r[2, 1], r[2, 2]), pitch, math.atan2(r[1, 0], r[0, 0])


def _numbers(text: str) -> list[float]:
    return [float(item) for item in text.split()]


def moving_joints(urdf: ElementTree.Element) -> tuple[str, ...]:
    """Moving joints in Pinocchio's order: depth first, children in the order of their joints' names.

    Raises:
        DescriptionError: A joint hangs in the air, or there is no first link.
    """
    children: dict[str, list[tuple[str, str, bool]]] = {}
    is_child = set()
    for joint in urdf.findall("joint"):
        parent, child = joint.find("parent"), joint.find("child")
        if parent is None or child is None:
            raise DescriptionError(f"joint {joint.get('name')!r} has no parent or no child")
        moving = joint.get("type") not in ("fixed", "floating")
        children.setdefault(parent.attrib["link"], []).append(
            (joint.attrib["name"], child.attrib["link"], moving)
        )
        is_child.add(child.attrib["link"])
    roots = [name for name in link_names(urdf) if name not in is_child]
    if not roots:
        raise DescriptionError("the URDF has no link that all others hang on: it is empty, or a ring")
    order: list[str] = []

    def visit(link: str) -> None:
        for name, child, moving in sorted(children.get(link, []), key=lambda item: item[1]):
            if moving:
                order.append(name)
            visit(child)

    visit(roots[0])
    return tuple(order)


def link_names(urdf: ElementTree.Element) -> list[str]:
    """Names of all links, in the order of the file."""
    return [link.attrib["name"] for link in urdf.findall("link")]


def joints_named(urdf: ElementTree.Element, names: Iterable[str]) -> dict[str, ElementTree.Element]:
    """Joints by name.

    Raises:
        DescriptionError: One of them is not in the URDF.
    """
    by_name = {joint.attrib["name"]: joint for joint in urdf.findall("joint")}
    wanted = list(names)
    if missing := [name for name in wanted if name not in by_name]:
        raise DescriptionError(f"the URDF has no joint {missing[0]!r}")
    return {name: by_name[name] for name in wanted}
