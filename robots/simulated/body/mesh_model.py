"""An object that has a mesh as geoms: what is seen of it, and the convex parts that it touches with."""

from __future__ import annotations

import io
from collections.abc import Sequence

import mujoco
import numpy as np
from PIL import Image

from robots.scenes.meshes.object_model import ObjectModel
from robots.scenes.scene_description import SceneItem
from robots.scenes.scene_words import COLORS
from robots.simulated.body.body_model import set_role
from robots.simulated.body.geom_roles import HULL_GROUP, WORLD_GROUP, Role, in_simulator


def part_names(item: SceneItem) -> tuple[str, ...]:
    """What the solids are called whose contacts are an object's own: its convex parts, or itself."""
    if item.model is None:
        return (item.name,)
    rest = range(1, len(item.model.parts.ends))
    return (item.name, *(f"{item.name}/part_{k}" for k in rest))


def add_mesh_object(
    spec: mujoco.MjSpec,
    body: mujoco.MjsBody,
    item: SceneItem,
    model: ObjectModel,
    friction: Sequence[float],
) -> None:
    """Put what is seen of an object, and the convex parts that it touches with, on its body.

    Args:
        spec: The world.
        body: The object's.
        item: The object.
        model: What was made of its mesh.
        friction: Sliding, torsional, rolling.
    """
    name = in_simulator(item.name)
    hulls = model.parts.hulls
    volumes = [float(np.prod(np.ptp(hull, axis=0))) for hull in hulls]
    for part, hull, volume in zip(part_names(item), hulls, volumes, strict=True):
        mesh = spec.add_mesh(name=in_simulator(part))
        mesh.uservert = hull.ravel()
        mesh.inertia = mujoco.mjtMeshInertia.mjMESH_INERTIA_CONVEX
        geom = body.add_geom(
            name=in_simulator(part),
            type=mujoco.mjtGeom.mjGEOM_MESH,
            meshname=in_simulator(part),
            mass=item.mass_kg * volume / sum(volumes),
            condim=4,
            friction=list(friction),
            group=HULL_GROUP,
        )
        set_role(geom, Role.OBJECT)
    _add_looks(spec, body, f"{name}/looks", model)


def _add_looks(spec: mujoco.MjSpec, body: mujoco.MjsBody, name: str, model: ObjectModel) -> None:
    """What is seen of it, which touches nothing."""
    mesh = spec.add_mesh(name=name)
    mesh.uservert, mesh.userface = model.vertices.ravel(), model.faces.ravel()
    mesh.inertia = mujoco.mjtMeshInertia.mjMESH_INERTIA_SHELL
    geom = body.add_geom(
        name=name,
        type=mujoco.mjtGeom.mjGEOM_MESH,
        meshname=name,
        mass=0.0,
        contype=0,
        conaffinity=0,
        rgba=[*model.color, 1.0],
        group=WORLD_GROUP,
    )
    if model.on_picture is None:
        return
    mesh.usertexcoord = np.column_stack([model.on_picture[:, 0], 1.0 - model.on_picture[:, 1]]).ravel()
    mesh.userfacetexcoord = model.faces.ravel()
    with Image.open(io.BytesIO(model.picture)) as file:
        image = file.convert("RGB")
    texture = spec.add_texture(name=name, type=mujoco.mjtTexture.mjTEXTURE_2D)
    texture.width, texture.height, texture.nchannel = image.width, image.height, 3
    texture.data = image.tobytes()
    material = spec.add_material(name=name, specular=0.1)
    textures = list(material.textures)
    textures[int(mujoco.mjtTextureRole.mjTEXROLE_RGB)] = name
    material.textures = textures
    geom.material, geom.rgba = name, [*COLORS["white"], 1.0]
