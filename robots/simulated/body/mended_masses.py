"""Masses of a URDF as the simulator takes them: inertias that are none are made those of small balls.

URDFs have such links where nobody cared: antennas, bases that never move, links between two axes.
"""

from __future__ import annotations

import xml.etree.ElementTree as ElementTree

import numpy as np

_TENSOR = ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")
_LEAST_KG_M2 = 1e-15
"""What the simulator takes for none."""
_BALL_M = 0.01
"""Radius of the ball that a mass without inertia becomes."""
_LEAST_KG = 0.001
"""What a link weighs that a joint moves and that weighs nothing."""


def mend_masses(urdf: ElementTree.Element) -> None:
    """Give masses without a proper inertia that of a ball; a link that a joint moves weighs a gram at least.

    Args:
        urdf: Is changed; what has a mass and an inertia stays to the letter.
    """
    moved = {
        child.get("link")
        for joint in urdf.findall("joint")
        if joint.get("type") not in ("fixed", "floating")
        for child in joint.findall("child")
    }
    for link in urdf.findall("link"):
        inertial = link.find("inertial")
        if inertial is not None and _is_taken(inertial, link.get("name") in moved):
            continue
        mass_kg = 0.0 if inertial is None else _mass_kg(inertial)
        if inertial is not None and mass_kg <= 0.0:
            link.remove(inertial)
            inertial = None
        if inertial is None and link.get("name") not in moved:
            continue
        if inertial is None:
            inertial, mass_kg = ElementTree.SubElement(link, "inertial"), _LEAST_KG
            ElementTree.SubElement(inertial, "mass", value=repr(mass_kg))
        tensor = inertial.find("inertia")
        if tensor is None:
            tensor = ElementTree.SubElement(inertial, "inertia")
        for key in _TENSOR:
            tensor.set(key, repr(0.4 * mass_kg * _BALL_M**2) if key[1] == key[2] else "0")


def _mass_kg(inertial: ElementTree.Element) -> float:
    mass = inertial.find("mass")
    return 0.0 if mass is None else float(mass.get("value", "0"))


def _is_taken(inertial: ElementTree.Element, moved: bool) -> bool:
    """Whether the simulator takes an inertia: a proper one, or none at all of a link that no joint moves."""
    tensor = inertial.find("inertia")
    if tensor is None or (moved and _mass_kg(inertial) <= 0.0):
        return False
    if not moved and not any(float(tensor.get(key, "0")) for key in _TENSOR):
        return True
    ixx, ixy, ixz, iyy, iyz, izz = (float(tensor.get(key, "0")) for key in _TENSOR)
    return float(np.linalg.eigvalsh([[ixx, ixy, ixz], [ixy, iyy, iyz], [ixz, iyz, izz]])[0]) > _LEAST_KG_M2
