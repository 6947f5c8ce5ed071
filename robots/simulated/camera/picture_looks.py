"""Pictures on things: around a can once, and on each upright side of a box, as a camera sees them."""

from __future__ import annotations

import math

import mujoco
import numpy as np
from PIL import Image

from kinematics.arrays import Array
from kinematics.geometry.shapes import Box, Cylinder
from robots.scenes.scene_description import SceneItem
from robots.scenes.scene_words import COLORS
from robots.simulated.body.geom_roles import WORLD_GROUP, in_simulator

MOST_PX = 1024
"""Longer sides of a picture are drawn smaller."""
_AROUND = 48
_OUT_M = 0.0002
"""A picture is this far outside of what it is on, so that the two are not drawn through each other."""


def add_picture(spec: mujoco.MjSpec, item: SceneItem) -> bool:
    """Put an object's picture on it, if it has one; tells whether it has.

    Bottom and top stay in the object's own colour.
    """
    if item.texture is None or not isinstance(item.shape, Box | Cylinder):
        return False
    name = in_simulator(f"{item.name}/picture")
    with Image.open(item.texture) as file:
        image = file.convert("RGB")
    image.thumbnail((MOST_PX, MOST_PX))
    texture = spec.add_texture(name=name, type=mujoco.mjtTexture.mjTEXTURE_2D)
    texture.width, texture.height, texture.nchannel = image.width, image.height, 3
    texture.data = image.tobytes()
    material = spec.add_material(name=name, specular=0.1)
    textures = list(material.textures)
    textures[int(mujoco.mjtTextureRole.mjTEXROLE_RGB)] = name
    material.textures = textures
    places, faces, on_picture = _box(item.shape) if isinstance(item.shape, Box) else _can(item.shape)
    mesh = spec.add_mesh(name=name)
    mesh.uservert, mesh.userface = places.ravel(), faces.ravel()
    mesh.usertexcoord, mesh.userfacetexcoord = on_picture.ravel(), faces.ravel()
    mesh.inertia = mujoco.mjtMeshInertia.mjMESH_INERTIA_SHELL
    body = spec.body(in_simulator(item.name))
    geom = body.add_geom(
        name=name,
        type=mujoco.mjtGeom.mjGEOM_MESH,
        meshname=name,
        mass=0.0,
        contype=0,
        conaffinity=0,
        material=name,
        group=WORLD_GROUP,
    )
    geom.rgba = [*COLORS["white"], 1.0]
    return True


def _can(shape: Cylinder) -> tuple[Array, Array, Array]:
    """The side: vertices, shape (n, 3), faces, (m, 3), and where each vertex is on the picture, (n, 2)."""
    turns = np.linspace(0.0, 1.0, _AROUND + 1)
    angles = 2.0 * math.pi * turns
    radius, half = shape.radius_m + _OUT_M, 0.5 * shape.height_m
    ring = radius * np.column_stack([np.cos(angles), np.sin(angles)])
    low, high = (np.column_stack([ring, np.full(len(ring), z)]) for z in (-half, half))
    here = np.arange(_AROUND)
    after, above = here + 1, len(ring)
    faces = np.concatenate(
        [
            np.column_stack([here, after, above + after]),
            np.column_stack([here, above + after, above + here]),
        ]
    )
    on_picture = np.concatenate([np.column_stack([turns, np.full(len(turns), v)]) for v in (1.0, 0.0)])
    return np.concatenate([low, high]), faces, on_picture


def _box(shape: Box) -> tuple[Array, Array, Array]:
    """The four upright sides, as of a can."""
    a, b, half = (0.5 * value for value in shape.size_m)
    places, faces, on_picture = [], [], []
    for k, (reach, wide) in enumerate(((a, b), (b, a), (a, b), (b, a))):
        angle = 0.5 * math.pi * k
        out, along = (
            np.array([math.cos(angle), math.sin(angle)]),
            np.array([-math.sin(angle), math.cos(angle)]),
        )
        for side, z, uv in ((-1, -half, (0, 1)), (1, -half, (1, 1)), (1, half, (1, 0)), (-1, half, (0, 0))):
            places.append([*((reach + _OUT_M) * out + side * wide * along), z])
            on_picture.append(uv)
        start = 4 * k
        faces += [[start, start + 1, start + 2], [start, start + 2, start + 3]]
    return np.array(places), np.array(faces), np.array(on_picture, dtype=np.float64)
