"""What things look like to a camera where their collision shapes do not tell it: cups are open at the top."""

from __future__ import annotations

import math

import mujoco
import numpy as np

from kinematics.arrays import Array
from kinematics.geometry.shapes import Cylinder
from robots.scenes.scene_description import SceneItem
from robots.scenes.scene_words import COLORS
from robots.simulated.body.geom_roles import WORLD_GROUP, in_simulator

CUP_WALL_M = 0.003
CUP_BOTTOM_M = 0.006
_AROUND = 48
_HIDDEN_GROUP = 5


def add_looks(spec: mujoco.MjSpec, item: SceneItem) -> bool:
    """Give an object the look of its kind; tells whether its collision shape is not to be drawn.

    A cup stays the solid cylinder that fingers feel, and is drawn as a beaker: same outline, with a rim.
    """
    if item.kind != "cup" or not isinstance(item.shape, Cylinder) or item.wall_m is not None:
        return False
    name = in_simulator(f"{item.name}/look")
    vertices, faces = _beaker(item.shape)
    mesh = spec.add_mesh(name=name)
    mesh.uservert, mesh.userface = vertices.ravel(), faces.ravel()
    mesh.inertia = mujoco.mjtMeshInertia.mjMESH_INERTIA_SHELL
    spec.body(in_simulator(item.name)).add_geom(
        name=name,
        type=mujoco.mjtGeom.mjGEOM_MESH,
        meshname=name,
        mass=0.0,
        contype=0,
        conaffinity=0,
        rgba=[*COLORS.get(item.color or "", COLORS["grey"]), 1.0],
        group=WORLD_GROUP,
    )
    return True


def hide(model: mujoco.MjModel, names: set[str]) -> None:
    """Draw the collision shapes of some objects no more."""
    for name in names:
        model.geom_group[model.geom(in_simulator(name)).id] = _HIDDEN_GROUP


def _beaker(shape: Cylinder) -> tuple[Array, Array]:
    """Outer wall, rim, inner wall and bottoms, as vertices, shape (n, 3), and faces, shape (m, 3)."""
    radius, half = shape.radius_m, 0.5 * shape.height_m
    inner, floor = radius - CUP_WALL_M, -half + CUP_BOTTOM_M
    angles = np.arange(_AROUND) * (2.0 * math.pi / _AROUND)
    around = np.column_stack([np.cos(angles), np.sin(angles)])

    def ring(r: float, z: float) -> Array:
        return np.column_stack([r * around, np.full(_AROUND, z)])

    # each surface has rings of its own, so that normals are not smoothed over its edges
    bands = [
        (ring(radius, -half), ring(radius, half)),
        (ring(radius, half), ring(inner, half)),
        (ring(inner, half), ring(inner, floor)),
        (ring(inner, floor), ring(1e-5, floor)),
        (ring(1e-5, -half), ring(radius, -half)),
    ]
    here = np.arange(_AROUND)
    after = (here + 1) % _AROUND
    vertices, faces = [], []
    for k, (low, high) in enumerate(bands):
        start = 2 * k * _AROUND
        vertices += [low, high]
        a, b, c, d = start + here, start + after, start + _AROUND + after, start + _AROUND + here
        faces += [np.column_stack([a, b, c]), np.column_stack([a, c, d])]
    return np.concatenate(vertices), np.concatenate(faces)
