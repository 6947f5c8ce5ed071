"""The bodies of a foreign model, with what they collide by and what is seen of them."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import mujoco
import numpy as np

from kinematics.arrays import Array, Indices
from kinematics.geometry import poses
from kinematics.geometry.poses import Transform
from robots.simulated.importing.mending import compiled

WORLD = 0
_UNSAID = (0.5, 0.5, 0.5, 1.0)
"""Red, green, blue and how solid the simulator draws what has no colour."""
_AROUND = 20
_STORIES = 8
_SIGNS = np.array([[x, y, z] for x in (-1.0, 1.0) for y in (-1.0, 1.0) for z in (-1.0, 1.0)])
_GLUED = re.compile(r"(?<=[a-z])(root|link|\d+)+$")
_ENDINGS = re.compile(r"([_\s](main|object|body|root|link|\d+)|-\d+)+$")


@dataclass(frozen=True, slots=True)
class Foreign:
    """A compiled foreign model, at its first keyframe, or as it is written.

    Attributes:
        model, data: MuJoCo's.
        file: Where it is from.
        mends: What had to be mended before it could be compiled.
        are_drawn: Its solids are what their meshes show, not the hulls of these.
        cut: Convex parts of such geoms in the world, as they come to be cut: that takes seconds.
    """

    model: Any
    data: Any
    file: Path
    mends: tuple[str, ...] = ()
    are_drawn: bool = False
    cut: dict[int, list[Array]] = field(default_factory=dict)

    def name(self, body: int) -> str:
        """A body's name; of one without, its number."""
        return str(self.model.body(body).name) or f"body {body}"

    def children(self, body: int) -> list[int]:
        """Bodies that hang on one."""
        return [k for k in range(1, self.model.nbody) if int(self.model.body_parentid[k]) == body]

    def subtree(self, body: int) -> list[int]:
        """A body and all that hangs on it."""
        found = [body]
        for child in self.children(body):
            found += self.subtree(child)
        return found

    def joints(self, body: int) -> list[int]:
        """Joints by which a body moves on its parent."""
        first = int(self.model.body_jntadr[body])
        return list(range(first, first + int(self.model.body_jntnum[body])))

    def joint_type(self, joint: int) -> int:
        """MuJoCo's; as a whole number, for its enumeration is not found among what an array holds."""
        return int(self.model.jnt_type[joint])

    def is_free(self, body: int) -> bool:
        """Whether it moves on nothing: by a free joint, or by slides along all three axes."""
        free, slide = int(mujoco.mjtJoint.mjJNT_FREE), int(mujoco.mjtJoint.mjJNT_SLIDE)
        kinds = {joint: self.joint_type(joint) for joint in self.joints(body)}
        axes = [self.model.jnt_axis[joint] for joint, kind in kinds.items() if kind == slide]
        return free in kinds.values() or (len(axes) >= 3 and np.linalg.matrix_rank(axes) == 3)

    def led(self) -> set[int]:
        """Bodies that a program moves, by a marker that they are tied to."""
        tied = (int(mujoco.mjtEq.mjEQ_WELD), int(mujoco.mjtEq.mjEQ_CONNECT))
        found: set[int] = set()
        for k in range(self.model.neq):
            if int(self.model.eq_type[k]) in tied and int(self.model.eq_objtype[k]) == int(
                mujoco.mjtObj.mjOBJ_BODY
            ):
                pair = {int(self.model.eq_obj1id[k]), int(self.model.eq_obj2id[k])}
                if any(int(self.model.body_mocapid[body]) >= 0 for body in pair):
                    found |= pair
        return found

    def pose(self, body: int) -> Transform:
        """Of a body in the world, shape (4, 4)."""
        return poses.transform(self.data.xmat[body].reshape(3, 3), self.data.xpos[body])

    def geoms(self, bodies: Iterable[int], colliding: bool) -> list[int]:
        """Geoms of some bodies that touch something, or that are only seen."""
        own = set(bodies)
        return [
            k
            for k in range(self.model.ngeom)
            if int(self.model.geom_bodyid[k]) in own
            and bool(self.model.geom_contype[k] or self.model.geom_conaffinity[k]) == colliding
            and int(self.model.geom_type[k]) != int(mujoco.mjtGeom.mjGEOM_PLANE)
        ]

    def planes(self, bodies: Iterable[int]) -> bool:
        """Whether all that some bodies have is a plane without end."""
        own = set(bodies)
        plane = int(mujoco.mjtGeom.mjGEOM_PLANE)
        kinds = [
            int(self.model.geom_type[k])
            for k in range(self.model.ngeom)
            if int(self.model.geom_bodyid[k]) in own
        ]
        return bool(kinds) and all(kind == plane for kind in kinds)

    def solid_geoms(self, bodies: Sequence[int]) -> list[int]:
        """What some bodies collide by; where that is nothing, what is seen of them."""
        return self.geoms(bodies, colliding=True) or self.geoms(bodies, colliding=False)

    def corners(self, geom: int) -> Array:
        """Corners of a geom's hull in the world, shape (n, 3), m."""
        rotation = self.data.geom_xmat[geom].reshape(3, 3)
        return np.asarray(_local(self.model, geom) @ rotation.T + self.data.geom_xpos[geom])

    def triangles(self, geom: int) -> tuple[Array, Indices]:
        """What is seen of a geom that is a mesh: vertices in the world, shape (n, 3), and faces."""
        mesh = int(self.model.geom_dataid[geom])
        if int(self.model.geom_type[geom]) != int(mujoco.mjtGeom.mjGEOM_MESH) or mesh < 0:
            return np.zeros((0, 3)), np.zeros((0, 3), np.int64)
        first, count = int(self.model.mesh_faceadr[mesh]), int(self.model.mesh_facenum[mesh])
        rotation = self.data.geom_xmat[geom].reshape(3, 3)
        vertices = _mesh_vertices(self.model, mesh) @ rotation.T + self.data.geom_xpos[geom]
        return vertices, np.asarray(self.model.mesh_face[first : first + count], np.int64)

    def says_color(self, geom: int) -> bool:
        """Whether the file says one, of it or of its material."""
        plain = bool(np.allclose(self.model.geom_rgba[geom], _UNSAID))
        return int(self.model.geom_matid[geom]) >= 0 or not plain

    def color(self, geom: int) -> tuple[float, float, float]:
        """Red, green, blue in [0, 1]; of what has a picture, what it is multiplied by."""
        material = int(self.model.geom_matid[geom])
        rgba = self.model.geom_rgba[geom] if material < 0 else self.model.mat_rgba[material]
        red, green, blue = (float(value) for value in rgba[:3])
        return red, green, blue


def read_foreign(file: Path) -> Foreign:
    """Compile an MJCF or URDF file.

    Raises:
        CannotImportError: It cannot be read, or the simulator refuses it; with its reason.
    """
    made = compiled(file)
    model = made.model
    data = mujoco.MjData(model)
    if model.nkey:
        mujoco.mj_resetDataKeyframe(model, data, 0)
    mujoco.mj_kinematics(model, data)
    return Foreign(model, data, file, made.mends, made.are_drawn)


def label_of_body(name: str, fixed: bool = False) -> str:
    """What people call a body: "alphabet_soup_1_main" is "alphabet soup".

    Args:
        name: The body's.
        fixed: It does not move: then "ovenroot" and "oven1" are "oven", where "beetroot" is no beet.
    """
    said = _ENDINGS.sub("", re.sub(r"(?<=[a-z])(?=[A-Z])", " ", name).lower())
    said = (_GLUED.sub("", said) or said) if fixed else said
    return " ".join(re.sub(r"[_\-./:]+", " ", said).split()) or name


def _local(model: Any, geom: int) -> Array:
    """Corners of a geom's hull in its own frame."""
    size = model.geom_size[geom]
    match mujoco.mjtGeom(int(model.geom_type[geom])):
        case mujoco.mjtGeom.mjGEOM_BOX:
            return np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]) * np.asarray(
                size, np.float64
            )
        case mujoco.mjtGeom.mjGEOM_CYLINDER:
            ring = _ring(float(size[0]))
            return np.concatenate([ring + (0, 0, z) for z in (-size[1], size[1])])  # noqa: RUF005
        case mujoco.mjtGeom.mjGEOM_SPHERE:
            return float(size[0]) * _ball()
        case mujoco.mjtGeom.mjGEOM_ELLIPSOID:
            return np.asarray(_ball() * size, np.float64)
        case mujoco.mjtGeom.mjGEOM_CAPSULE:
            ends = np.array([[0.0, 0.0, -size[1]], [0.0, 0.0, size[1]]])
            return np.concatenate([float(size[0]) * _ball() + end for end in ends])
        case mujoco.mjtGeom.mjGEOM_MESH:
            return _mesh_vertices(model, int(model.geom_dataid[geom]))
        case _:
            return np.zeros((0, 3))


def _mesh_vertices(model: Any, mesh: int) -> Array:
    first, count = int(model.mesh_vertadr[mesh]), int(model.mesh_vertnum[mesh])
    return np.asarray(model.mesh_vert[first : first + count], np.float64)


def _ring(radius: float) -> Array:
    angles = 2.0 * np.pi * np.arange(_AROUND) / _AROUND
    return radius * np.column_stack([np.cos(angles), np.sin(angles), np.zeros(_AROUND)])


def _ball() -> Array:
    heights = np.cos(np.pi * np.arange(1, _STORIES) / _STORIES)
    rings = [_ring(float(np.sqrt(1.0 - z * z))) + np.array([0.0, 0.0, z]) for z in heights]
    return np.concatenate([*rings, np.array([[0.0, 0.0, -1.0], [0.0, 0.0, 1.0]])])
