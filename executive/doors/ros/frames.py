"""The frames of a robot as ROS wants them: each link in its parent, from the URDF and what joints read."""

from __future__ import annotations

import xml.etree.ElementTree as ElementTree
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
_HALF = 0.5


@dataclass(frozen=True, slots=True)
class _Joint:
    """One joint of the URDF; ``drives``: whose position it takes, times what, plus what."""

    parent: str
    child: str
    xyz: tuple[float, float, float]
    quaternion: tuple[float, float, float, float]
    axis: tuple[float, float, float]
    kind: str
    drives: tuple[str, float, float]


class FrameTree:
    """Every link of a URDF in its parent.

    Attributes:
        moving: Parent and child of each joint that moves, in the order of ``poses``.
        fixed: The same of those that do not, with xyz and quaternion (x, y, z, w).
    """

    def __init__(self, urdf: str, names: Sequence[str]) -> None:
        """Read a URDF.

        Args:
            urdf: Its text.
            names: Joints whose positions will be given, in their order; others stay at zero.
        """
        joints = [
            _joint(one)
            for one in ElementTree.fromstring(urdf).iter("joint")
            if one.find("parent") is not None
        ]
        moving = [one for one in joints if one.kind in ("revolute", "continuous", "prismatic")]
        self.moving = [(one.parent, one.child) for one in moving]
        self.fixed = [
            (one.parent, one.child, one.xyz, one.quaternion) for one in joints if one.kind == "fixed"
        ]
        index = {name: i for i, name in enumerate(names)}
        self._source = np.array([index.get(one.drives[0], len(names)) for one in moving], dtype=np.intp)
        self._factor = np.array([one.drives[1] for one in moving])
        self._offset = np.array([one.drives[2] for one in moving])
        self._axis = np.array([one.axis for one in moving]).reshape(-1, 3)
        self._xyz = np.array([one.xyz for one in moving]).reshape(-1, 3)
        self._rest = np.array([one.quaternion for one in moving]).reshape(-1, 4)
        self._slides = np.array([one.kind == "prismatic" for one in moving], dtype=bool)

    def poses(self, positions: Floats) -> tuple[Floats, Floats]:
        """Where each moving joint's child is in its parent.

        Args:
            positions: Of the named joints, rad or m, shape (n,).

        Returns:
            Translations in metres, shape (m, 3), and quaternions (x, y, z, w), shape (m, 4).
        """
        value = np.append(positions, 0.0)[self._source] * self._factor + self._offset
        angle = np.where(self._slides, 0.0, value) * _HALF
        turn = np.column_stack([self._axis * np.sin(angle)[:, None], np.cos(angle)])
        slide = self._axis * np.where(self._slides, value, 0.0)[:, None]
        return self._xyz + rotated(self._rest, slide), product(self._rest, turn)


def product(first: Floats, second: Floats) -> Floats:
    """Products of quaternions (x, y, z, w), row by row, shape (n, 4)."""
    a, b = first[:, :3], second[:, :3]
    aw, bw = first[:, 3:], second[:, 3:]
    vector = aw * b + bw * a + np.cross(a, b)
    return np.hstack([vector, aw * bw - np.sum(a * b, axis=1, keepdims=True)])


def rotated(by: Floats, vectors: Floats) -> Floats:
    """Vectors turned by quaternions (x, y, z, w), row by row, shape (n, 3)."""
    twice = 2.0 * np.cross(by[:, :3], vectors)
    turned: Floats = vectors + by[:, 3:] * twice + np.cross(by[:, :3], twice)
    return turned


def _joint(element: ElementTree.Element) -> _Joint:
    origin = element.find("origin")
    placed: Mapping[str, str] = {} if origin is None else origin.attrib
    axis, mimic = element.find("axis"), element.find("mimic")
    parent, child = element.find("parent"), element.find("child")
    drives = (element.get("name", ""), 1.0, 0.0)
    if mimic is not None:
        drives = (
            mimic.get("joint", ""),
            float(mimic.get("multiplier", 1.0)),
            float(mimic.get("offset", 0.0)),
        )
    return _Joint(
        parent="" if parent is None else parent.get("link", ""),
        child="" if child is None else child.get("link", ""),
        xyz=_three(placed.get("xyz", "0 0 0")),
        quaternion=_quaternion(*_three(placed.get("rpy", "0 0 0"))),
        axis=_three("1 0 0" if axis is None else axis.get("xyz", "1 0 0")),
        kind=element.get("type", "fixed"),
        drives=drives,
    )


def _three(text: str) -> tuple[float, float, float]:
    x, y, z = map(float, text.split())
    return x, y, z


def _quaternion(roll: float, pitch: float, yaw: float) -> tuple[float, float, float, float]:
    """Of the URDF's fixed-axis angles, (x, y, z, w)."""
    (sr, sp, sy), (cr, cp, cy) = (f(np.array([roll, pitch, yaw]) * _HALF).tolist() for f in (np.sin, np.cos))
    return (
        sr * cp * cy - cr * sp * sy,
        cr * sp * cy + sr * cp * sy,
        cr * cp * sy - sr * sp * cy,
        cr * cp * cy + sr * sp * sy,
    )
