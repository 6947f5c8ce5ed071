"""A URDF as a tree of moving joints with what hangs on each, at the joints' zero: what drafting looks at."""

from __future__ import annotations

import math
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import coal
import numpy as np
import pinocchio as pin

from kinematics.arrays import Array
from kinematics.geometry import poses
from robots.models.fitted_urdf import bound_joints, forget_capsules, without_world
from robots.models.urdf import link_names, moving_joints, read_urdf

WITHOUT_END = (-math.pi, math.pi)
"""What a joint that turns without end is given as limits, rad."""
_ROOM = 0.02
"""What a posture keeps from a joint's limits, rad or m."""
_MOST_POINTS = 5000
"""Corners of a solid that are looked at."""


@dataclass(frozen=True, slots=True)
class Joint:
    """A moving joint as its URDF has it.

    Attributes:
        name: Of the joint.
        kind: "revolute", "continuous" or "prismatic".
        lower, upper: Limits, rad or m; those of a joint without end are ``WITHOUT_END``.
        velocity, effort: Limits; 0 where the URDF says nothing.
        link: The link that it moves.
        mimics: The joint that it follows, if it follows one.
        parent: The joint that carries it; None at the base.
    """

    name: str
    kind: str
    lower: float
    upper: float
    velocity: float
    effort: float
    link: str
    mimics: str | None
    parent: str | None

    @property
    def zero(self) -> float:
        """Position nearest to zero."""
        return min(max(0.0, self.lower), self.upper)

    @property
    def rest(self) -> float:
        """The same, a little inside the limits."""
        room = min(_ROOM, 0.25 * (self.upper - self.lower))
        return min(max(0.0, self.lower + room), self.upper - room)


class Anatomy:
    """The joints of a robot, what they carry, and where all of it is with the joints at zero.

    Places are those of a level frame at the URDF's root link, z up and x ahead: the link's own, unless
    ``turn`` is set to another.

    Attributes:
        urdf: The document, mesh paths absolute.
        joints: Moving joints by name, parents before children.
        root: The root link.
    """

    def __init__(self, path: Path, root: Path) -> None:
        """Read a URDF.

        Args:
            path: The file.
            root: Folder that its ``package://`` paths begin at.

        Raises:
            DescriptionError: It is no URDF.
        """
        self.urdf = read_urdf(path, root)
        self.capsules = self.urdf.find("link/collision_checking/capsule") is not None
        forget_capsules(self.urdf)
        without_world(self.urdf)
        self.joints = _joints(self.urdf)
        self.endless = [joint.name for joint in self.joints.values() if joint.kind == "continuous"]
        bound_joints(self.urdf, dict.fromkeys(self.endless, WITHOUT_END))
        children = {joint.attrib["link"] for joint in self.urdf.findall("joint/child")}
        self.root = next(name for name in link_names(self.urdf) if name not in children)
        text = ElementTree.tostring(self.urdf, encoding="unicode")
        self.model = pin.buildModelFromXML(text)
        self.data = self.model.createData()
        self.q = np.array([self.joints[name].zero for name in list(self.model.names)[1:]])
        pin.framesForwardKinematics(self.model, self.data, self.q)
        self.turn: Array = np.eye(3)
        self._solids = [
            pin.buildGeomFromUrdfString(self.model, text, kind)
            for kind in (pin.GeometryType.COLLISION, pin.GeometryType.VISUAL)
        ]

    def children(self, name: str | None) -> list[str]:
        """Joints that hang on a joint directly; on the base of None."""
        return [joint.name for joint in self.joints.values() if joint.parent == name]

    def subtree(self, name: str) -> list[str]:
        """A joint and all that hang on it."""
        found = [name]
        for one in found:
            found += self.children(one)
        return found

    def way(self, name: str) -> list[str]:
        """Joints from the base to a joint, itself included."""
        joint = self.joints[name]
        return [*([] if joint.parent is None else self.way(joint.parent)), name]

    def place(self, name: str) -> Array:
        """``level_T_joint``, shape (4, 4)."""
        placed: Array = self._turned @ np.array(self.data.oMi[self.model.getJointId(name)].homogeneous)
        return placed

    def frame(self, link: str) -> Array:
        """``level_T_link``, shape (4, 4)."""
        placed: Array = self._turned @ np.array(self.data.oMf[self.frame_id(link)].homogeneous)
        return placed

    @property
    def _turned(self) -> Array:
        return poses.transform(self.turn, np.zeros(3))

    def frame_id(self, link: str) -> int:
        """Pinocchio's index of a link; a joint may have the same name."""
        return int(self.model.getFrameId(link, pin.FrameType.BODY))

    def axis(self, name: str) -> Array:
        """Axis of a joint in the level frame, shape (3,)."""
        jacobian = pin.computeJointJacobian(self.model, self.data, self.q, self.model.getJointId(name))
        column = np.array(jacobian)[:, self.model.joints[self.model.getJointId(name)].idx_v]
        along = column[:3] if np.any(column[:3]) and not np.any(column[3:]) else column[3:]
        return np.asarray(self.place(name)[:3, :3] @ along)

    def links_of(self, name: str | None) -> list[str]:
        """Links that move with a joint (with the base of None) and with no joint beyond it."""
        number = 0 if name is None else self.model.getJointId(name)
        bodies = [frame for frame in self.model.frames if frame.type == pin.FrameType.BODY]
        return [str(frame.name) for frame in bodies if frame.parentJoint == number]

    def points(self, name: str | None) -> Array:
        """Corners of what moves with a joint and with no joint beyond it, shape (n, 3)."""
        number = 0 if name is None else self.model.getJointId(name)
        return np.asarray(self._points[number] @ self.turn.T)

    def all_points(self, names: list[str]) -> Array:
        """Corners of what moves with one of several joints, shape (n, 3)."""
        return np.vstack([np.empty((0, 3)), *(self.points(name) for name in names)])

    def everything(self) -> Array:
        """Corners of all that moves, and the joints' origins where nothing has a shape, shape (n, 3)."""
        origins = [self.place(name)[:3, 3] for name in self.joints]
        return np.vstack([self.all_points(list(self.joints)), *origins])

    def link_box(self, link: str) -> tuple[Array, Array] | None:
        """Lowest and highest corner of what is drawn of a link, or it collides with, in its frame."""
        found = []
        for item in (item for solids in self._solids for item in solids.geometryObjects):
            if str(self.model.frames[item.parentFrame].name) == link:
                in_link = self.model.frames[item.parentFrame].placement.inverse() * item.placement
                found.append(_corners(item) @ in_link.rotation.T + in_link.translation)
        if not found:
            return None
        points = np.vstack(found)
        return points.min(axis=0), points.max(axis=0)

    def hull_fails(self, link: str) -> bool:
        """Whether a mesh that a link collides with has no hull: flat, or of a corner with too many edges."""
        for item in self._solids[0].geometryObjects:
            solid = item.geometry
            if str(self.model.frames[item.parentFrame].name) != link or not isinstance(
                solid, coal.BVHModelBase
            ):
                continue
            try:
                solid.buildConvexHull(True, "Qt")
            except (RuntimeError, ValueError):
                return True
        return False

    def collides_with(self, link: str) -> bool:
        """Whether a link has a collision solid."""
        frames = (self.model.frames[item.parentFrame] for item in self._solids[0].geometryObjects)
        return any(str(frame.name) == link for frame in frames)

    @cached_property
    def _points(self) -> list[Array]:
        found: list[list[Array]] = [[np.empty((0, 3))] for _ in range(self.model.njoints)]
        for item in (item for solids in self._solids for item in solids.geometryObjects):
            place = self.data.oMi[item.parentJoint] * item.placement
            found[item.parentJoint].append(_corners(item) @ place.rotation.T + place.translation)
        return [np.vstack(parts) for parts in found]


def _corners(item: pin.GeometryObject) -> Array:
    """Corners of a solid, or of the box around it, scaled, shape (n, 3)."""
    solid = item.geometry
    if isinstance(solid, coal.BVHModelBase):
        points = np.array(solid.vertices(), dtype=np.float64).reshape(-1, 3)
        if len(points):  # those of the loader are scaled already
            low, high = points.argmin(axis=0), points.argmax(axis=0)
            spread = np.linspace(0, len(points) - 1, min(len(points), _MOST_POINTS)).astype(np.intp)
            chosen: Array = points[np.concatenate([low, high, spread])]
            return chosen
    solid.computeLocalAABB()
    low, high = np.array(solid.aabb_local.min_), np.array(solid.aabb_local.max_)
    grid = np.array(np.meshgrid(*zip(low, high, strict=True))).reshape(3, -1)
    return np.asarray(grid.T)


def _joints(urdf: ElementTree.Element) -> dict[str, Joint]:
    elements = {joint.attrib["name"]: joint for joint in urdf.findall("joint")}
    above = {joint.find("child").attrib["link"]: joint for joint in elements.values()}  # type: ignore[union-attr]
    order = moving_joints(urdf)
    found: dict[str, Joint] = {}
    for name in order:
        element = elements[name]
        limit, mimic = element.find("limit"), element.find("mimic")
        numbers = {} if limit is None else limit.attrib
        lower, upper = float(numbers.get("lower", "0")), float(numbers.get("upper", "0"))
        if element.get("type") == "continuous":
            lower, upper = WITHOUT_END
        found[name] = Joint(
            name=name,
            kind=element.get("type", ""),
            lower=min(lower, upper),
            upper=max(lower, upper),
            velocity=float(numbers.get("velocity", "0")),
            effort=float(numbers.get("effort", "0")),
            link=_child(element),
            mimics=None if mimic is None else mimic.get("joint"),
            parent=_carrier(element, above, order),
        )
    return found


def _child(joint: ElementTree.Element) -> str:
    child = joint.find("child")
    return "" if child is None else child.attrib["link"]


def _carrier(
    joint: ElementTree.Element, above: dict[str, ElementTree.Element], moving: tuple[str, ...]
) -> str | None:
    """The moving joint that a joint hangs on."""
    one: ElementTree.Element | None = joint
    while one is not None:
        parent = one.find("parent")
        one = None if parent is None else above.get(parent.attrib["link"])
        if one is not None and one.attrib["name"] in moving:
            return one.attrib["name"]
    return None
