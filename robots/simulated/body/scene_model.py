"""A scene as MuJoCo bodies: floor, furniture, objects, persons, and who grips what how well."""

from __future__ import annotations

from collections.abc import Sequence

import mujoco
import numpy as np

from kinematics.geometry.poses import Transform, quaternion_from_rotation
from kinematics.geometry.shapes import Ball, Box, Cylinder, Shape
from kinematics.model.robot_description import RobotDescription
from robots.scenes import furniture
from robots.scenes.hollow import hollow_parts
from robots.scenes.moving_parts import moving_parts
from robots.scenes.scene_description import SceneDescription, SceneItem
from robots.scenes.scene_words import COLORS
from robots.simulated.body.body_model import (
    PAD_SOLIMP,
    PAD_SOLREF,
    PAD_SOLREF_FRICTION,
    PATCH_RADIUS_M,
    pad_name,
    set_role,
)
from robots.simulated.body.control_model import add_controls
from robots.simulated.body.furniture_model import add_moving_part
from robots.simulated.body.geom_roles import WORLD_GROUP, Role, in_simulator
from robots.simulated.body.mesh_model import add_mesh_object, part_names
from robots.simulated.body.person_model import add_person

FLOOR = "floor"
FLOOR_FRICTION = 0.8
REST_PATCH_M = 0.01
"""The same for an object that stands on something hard."""
ROLLING_M = 0.0005
"""Rolling friction of a ball: a felt-covered table."""


def joint_name(item: str) -> str:
    """Name of an object's free joint."""
    return in_simulator(f"{item}/free")


def pair_name(first: str, second: str) -> str:
    """Name of the contact pair of two geoms, by the simulator's names."""
    return f"{first}|{second}"


def friction_row(sliding: float, patch_m: float) -> list[float]:
    """MuJoCo's five friction coefficients of a pair from the one of sliding."""
    return [sliding, sliding, sliding * patch_m, ROLLING_M, ROLLING_M]


def add_scene(spec: mujoco.MjSpec, scene: SceneDescription, description: RobotDescription) -> None:
    """Put everything but the robot into its world."""
    _add_floor(spec)
    for piece in scene.furniture:
        for solid in furniture.solids(piece):
            geom = spec.worldbody.add_geom(
                name=in_simulator(solid.name), rgba=[0.62, 0.47, 0.32, 1.0], group=WORLD_GROUP
            )
            _shape(geom, solid.shape)
            _place(geom, solid.world_T_solid)
            set_role(geom, Role.FURNITURE)
            geom.friction = [piece.friction, 0.005, 0.0001]
        for moving in moving_parts(piece):
            add_moving_part(spec, piece, moving, description)
        add_controls(spec, piece, description)
    for person in scene.people:
        add_person(spec, person)
    for item in scene.objects:
        _add_object(spec, item)
    pads = [link for gripper in description.grippers.values() for link in gripper.pad_links]
    for item in scene.objects:
        for part in part_names(item):
            _add_pairs(spec, scene, item, in_simulator(part), pads)


def _add_pairs(
    spec: mujoco.MjSpec, scene: SceneDescription, item: SceneItem, geom: str, pads: Sequence[str]
) -> None:
    """How pads and furniture touch a solid of an object."""
    for link in pads:
        spec.add_pair(
            name=pair_name(pad_name(link), geom),
            geomname1=pad_name(link),
            geomname2=geom,
            condim=4,
            friction=friction_row(item.friction, PATCH_RADIUS_M),
            solref=list(PAD_SOLREF),
            solreffriction=list(PAD_SOLREF_FRICTION),
            solimp=list(PAD_SOLIMP),
        )
    for piece in scene.furniture:
        for solid in furniture.solids(piece):
            spec.add_pair(
                name=pair_name(in_simulator(solid.name), geom),
                geomname1=in_simulator(solid.name),
                geomname2=geom,
                condim=6 if rolls(item) else 4,
                friction=friction_row(piece.friction, REST_PATCH_M),
            )


def rolls(item: SceneItem) -> bool:
    """Whether an object is a ball."""
    return isinstance(item.shape, Ball) and item.model is None


def _add_floor(spec: mujoco.MjSpec) -> None:
    spec.add_texture(
        name="sky",
        type=mujoco.mjtTexture.mjTEXTURE_SKYBOX,
        builtin=mujoco.mjtBuiltin.mjBUILTIN_GRADIENT,
        width=256,
        height=256,
        rgb1=[0.86, 0.90, 0.94],
        rgb2=[0.62, 0.68, 0.74],
    )
    spec.visual.headlight.ambient = [0.35, 0.35, 0.35]
    spec.visual.headlight.diffuse = [0.45, 0.45, 0.45]
    spec.add_texture(
        name=FLOOR,
        type=mujoco.mjtTexture.mjTEXTURE_2D,
        builtin=mujoco.mjtBuiltin.mjBUILTIN_CHECKER,
        width=300,
        height=300,
        rgb1=[0.42, 0.46, 0.50],
        rgb2=[0.50, 0.54, 0.58],
    )
    material = spec.add_material(name=FLOOR, texrepeat=[2, 2], texuniform=True)
    textures = list(material.textures)
    textures[int(mujoco.mjtTextureRole.mjTEXROLE_RGB)] = FLOOR
    material.textures = textures
    floor = spec.worldbody.add_geom(
        name=FLOOR,
        type=mujoco.mjtGeom.mjGEOM_PLANE,
        size=[12.0, 12.0, 0.1],
        material=FLOOR,
        friction=[FLOOR_FRICTION, 0.01, 0.0001],
        group=WORLD_GROUP,
    )
    set_role(floor, Role.FLOOR)
    spec.worldbody.add_light(pos=[0.5, -1.5, 3.0], dir=[0.0, 0.4, -1.0], diffuse=[0.45, 0.45, 0.45])
    spec.worldbody.add_light(
        pos=[1.8, 1.8, 3.0], dir=[-0.4, -0.4, -1.0], castshadow=False, diffuse=[0.3, 0.3, 0.3]
    )


def _add_object(spec: mujoco.MjSpec, item: SceneItem) -> None:
    body = spec.worldbody.add_body(name=in_simulator(item.name))
    _place(body, item.world_T_object)
    body.add_freejoint(name=joint_name(item.name))
    if item.model is not None:
        friction = [item.friction, item.friction * REST_PATCH_M, ROLLING_M]
        add_mesh_object(spec, body, item, item.model, friction)
        return
    color = COLORS.get(item.color or "", COLORS["grey"])
    parts = hollow_parts(item)
    for name, shape, item_T_part, share in parts or [(item.name, item.shape, np.eye(4), 1.0)]:
        geom = body.add_geom(
            name=in_simulator(name),
            mass=item.mass_kg * share,
            rgba=[*color, 1.0],
            condim=6 if rolls(item) else 4,
            friction=[item.friction, item.friction * REST_PATCH_M, ROLLING_M],
            group=WORLD_GROUP,
        )
        _shape(geom, shape)
        _place(geom, item_T_part)
        set_role(geom, Role.OBJECT)


def _shape(geom: mujoco.MjsGeom, shape: Shape) -> None:
    match shape:
        case Box(size_m=size):
            geom.type, geom.size = mujoco.mjtGeom.mjGEOM_BOX, [0.5 * value for value in size]
        case Cylinder(radius_m=radius, height_m=height):
            geom.type, geom.size = mujoco.mjtGeom.mjGEOM_CYLINDER, [radius, 0.5 * height, 0.0]
        case Ball(radius_m=radius):
            geom.type, geom.size = mujoco.mjtGeom.mjGEOM_SPHERE, [radius, 0.0, 0.0]


def _place(item: mujoco.MjsBody | mujoco.MjsGeom, world_T_item: Transform) -> None:
    x, y, z, w = quaternion_from_rotation(world_T_item[:3, :3])
    item.pos, item.quat = world_T_item[:3, 3], [w, x, y, z]
