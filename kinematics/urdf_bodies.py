"""A URDF of bodies and joints alone, for solvers that need no shapes."""

from __future__ import annotations

import functools
import xml.etree.ElementTree as ElementTree


@functools.cache
def without_meshes(urdf: str) -> str:
    """Drop what is drawn and what collides: PlaCo loads every mesh otherwise, for 0.8 s."""
    root = ElementTree.fromstring(urdf)
    for link in root.findall("link"):
        for element in (*link.findall("visual"), *link.findall("collision")):
            link.remove(element)
    return ElementTree.tostring(root, encoding="unicode")
