"""A URDF made fit by a robot's data: joints held, joints without end bounded, what is no part left out."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ElementTree
from collections.abc import Mapping

from robots.errors import DescriptionError
from robots.models.urdf import with_fixed_joints


def with_joints_held(urdf: ElementTree.Element, held: Mapping[str, float]) -> ElementTree.Element:
    """Hold joints fast that nothing is to move: wheels, a lift, the fingers of a hand that only reaches.

    Args:
        urdf: Stays as it is.
        held: Where they stand, rad or m, by name. Joints that mimic one of them follow it.

    Raises:
        DescriptionError: The URDF has no such joint.
    """
    if not held:
        return urdf
    names = {joint.attrib["name"] for joint in urdf.findall("joint")}
    if unknown := sorted(set(held) - names):
        raise DescriptionError(f"[held] the URDF has no joint {unknown[0]!r}")
    fast = set(held)
    while followers := {name for name, driver in _mimics(urdf).items() if driver in fast} - fast:
        fast |= followers
    return with_fixed_joints(urdf, "|".join(map(re.escape, sorted(fast))), held)


def bound_joints(urdf: ElementTree.Element, positions: Mapping[str, tuple[float, float]]) -> None:
    """Make hinges with limits of those joints that turn without end and that have limits in the data.

    Args:
        urdf: Is changed.
        positions: Limits by joint, rad.
    """
    for joint in urdf.findall("joint"):
        bounds = positions.get(joint.get("name", ""))
        if bounds is None or joint.get("type") != "continuous":
            continue
        joint.set("type", "revolute")
        limit = joint.find("limit")
        if limit is None:
            limit = ElementTree.SubElement(joint, "limit", effort="0", velocity="0")
        for key, value in zip(("lower", "upper"), bounds, strict=True):
            limit.set(key, repr(float(value)))


def without_world(urdf: ElementTree.Element) -> None:
    """Take away a root link called "world" that nothing belongs to: the link fixed to it is the root then."""
    world = next((link for link in urdf.findall("link") if link.get("name") == "world"), None)
    if world is None or len(world):
        return
    joints = [joint for joint in urdf.findall("joint") if joint.find("parent[@link='world']") is not None]
    if len(joints) == 1 and joints[0].get("type") == "fixed":
        urdf.remove(world)
        urdf.remove(joints[0])


def forget_capsules(urdf: ElementTree.Element) -> None:
    """Leave out what rounds cylinders off (``<collision_checking>``)."""
    for link in urdf.iter("link"):
        for element in link.findall("collision_checking"):
            link.remove(element)


def _mimics(urdf: ElementTree.Element) -> dict[str, str]:
    """The joint that each joint mimics, by the name of the one that does."""
    found = {}
    for joint in urdf.findall("joint"):
        mimic = joint.find("mimic")
        if mimic is not None:
            found[joint.attrib["name"]] = mimic.get("joint", "")
    return found
