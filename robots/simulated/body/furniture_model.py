"""Doors and drawers as MuJoCo bodies: a joint, a front, a handle that only finger pads can hold."""

from __future__ import annotations

from dataclasses import dataclass

import mujoco
import numpy as np

from kinematics.geometry.poses import Transform, quaternion_from_rotation
from kinematics.geometry.shapes import Box
from kinematics.model.robot_description import RobotDescription
from robots.scenes import articulated, furniture
from robots.scenes.moving_parts import Moving, moving_parts
from robots.scenes.scene_description import Furniture, SceneDescription
from robots.simulated.body.body_model import PAD_SOLIMP, PAD_SOLREF, PATCH_RADIUS_M, pad_name, set_role
from robots.simulated.body.control_model import control_joint, control_name
from robots.simulated.body.geom_roles import WORLD_GROUP, Role, in_simulator

DOOR_DAMPING = 0.2
"""Nm s/rad of a hinge: grease."""
DRAWER_DAMPING = 2.0
"""N s/m of a slide."""
LIMIT_SOLREF = (0.01, 1.0)
LOCKED_PLAY = 0.0005
"""How far a locked part gives, rad or m. A huge friction would creep instead."""
SEAL_HOLDS_RAD, SEAL_ENDS_RAD = np.deg2rad(1.0), np.deg2rad(3.0)
"""A magnetic seal pulls fully up to the first angle, and fades out to the second."""


def part_joint(moving: Moving) -> str:
    """Name of the joint that a door or drawer moves on."""
    return in_simulator(f"{moving.name}/opens")


def part_body(moving: Moving) -> str:
    """Name of the body of a door or drawer."""
    return in_simulator(f"{moving.name}/part")


def add_moving_part(
    spec: mujoco.MjSpec, piece: Furniture, moving: Moving, description: RobotDescription
) -> None:
    """Put a door or drawer of a piece of furniture into the world."""
    part, door, solids = moving.part, moving.part.hinge is not None, moving.solids
    body = spec.worldbody.add_body(name=part_body(moving))
    _place(body, furniture.floor_pose(piece) @ moving.furniture_T_part)
    kind = mujoco.mjtJoint.mjJNT_HINGE if door else mujoco.mjtJoint.mjJNT_SLIDE
    axis = [0.0, 0.0, -moving.side] if door else [-1.0, 0.0, 0.0]
    farthest = LOCKED_PLAY if part.locked else moving.travel
    joint = body.add_joint(
        name=part_joint(moving),
        type=kind,
        axis=axis,
        range=[0.0, farthest],
        limited=True,
        frictionloss=part.friction,
        damping=[DOOR_DAMPING if door else DRAWER_DAMPING, 0.0, 0.0],
    )
    joint.solref_limit = list(LIMIT_SOLREF)
    volume = sum(_volume(solid.shape) for solid in solids if not solid.grasped)
    for solid in solids:
        bar = solid.kind == articulated.HANDLE
        mass = articulated.BAR_MASS_KG if bar else part.mass_kg * _volume(solid.shape) / volume
        geom = body.add_geom(
            name=in_simulator(solid.name),
            mass=0.01 if solid.grasped and not bar else mass,
            rgba=[0.22, 0.22, 0.25, 1.0] if solid.grasped else [0.88, 0.90, 0.92, 1.0],
            friction=[part.handle_friction if solid.grasped else piece.friction, 0.005, 0.0001],
            group=WORLD_GROUP,
        )
        if isinstance(solid.shape, Box):
            geom.type, geom.size = mujoco.mjtGeom.mjGEOM_BOX, [0.5 * value for value in solid.shape.size_m]
        else:
            geom.type = mujoco.mjtGeom.mjGEOM_CYLINDER
            geom.size = [solid.shape.radius_m, 0.5 * solid.shape.height_m, 0.0]
        _place(geom, solid.part_T_solid)
        set_role(geom, Role.HANDLE if solid.grasped else Role.FURNITURE)
        if solid.grasped:
            _add_grip(spec, in_simulator(solid.name), part.handle_friction, description)


def _add_grip(spec: mujoco.MjSpec, name: str, friction: float, description: RobotDescription) -> None:
    """Who holds a handle holds it by its pads, with the handle's friction."""
    for gripper in description.grippers.values():
        for link in gripper.pad_links:
            spec.add_pair(
                name=f"{pad_name(link)}|{name}",
                geomname1=pad_name(link),
                geomname2=name,
                condim=4,
                friction=[friction, friction, friction * PATCH_RADIUS_M, 0.0005, 0.0005],
                solref=list(PAD_SOLREF),
                solimp=list(PAD_SOLIMP),
            )


def _volume(shape: object) -> float:
    return float(np.prod(shape.size_m)) if isinstance(shape, Box) else 0.0


def _place(item: mujoco.MjsBody | mujoco.MjsGeom, pose: Transform) -> None:
    x, y, z, w = quaternion_from_rotation(pose[:3, :3])
    item.pos, item.quat = pose[:3, 3], [w, x, y, z]


@dataclass(frozen=True, slots=True)
class _Gasket:
    qpos: int
    dof: int
    torque_nm: float


class FurnitureForces:
    """What doors do by themselves: their seals pull, their joints start where the scene says."""

    def __init__(self, model: mujoco.MjModel, data: mujoco.MjData, scene: SceneDescription) -> None:
        self._data = data
        self.qpos: dict[str, int] = {}
        self.dof: dict[str, int] = {}
        self._seals: list[_Gasket] = []
        for piece in scene.furniture:
            for control in piece.controls:
                name = control_joint(piece, control)
                found = int(mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_JOINT, name))
                self.qpos[control_name(piece, control)] = int(model.jnt_qposadr[found])
                data.qpos[int(model.jnt_qposadr[found])] = control.at
            for moving in moving_parts(piece):
                joint = int(mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_JOINT, part_joint(moving)))
                qpos, dof = int(model.jnt_qposadr[joint]), int(model.jnt_dofadr[joint])
                self.qpos[moving.name], self.dof[moving.name] = qpos, dof
                data.qpos[qpos] = moving.part.opening
                if moving.part.seal_n > 0.0:
                    self._seals.append(_Gasket(qpos, dof, moving.part.seal_n * moving.lever_m))

    def apply(self) -> None:
        """Set the seals' pull for the next control period."""
        for seal in self._seals:
            angle = float(self._data.qpos[seal.qpos])
            share = (SEAL_ENDS_RAD - angle) / (SEAL_ENDS_RAD - SEAL_HOLDS_RAD)
            self._data.qfrc_applied[seal.dof] = -seal.torque_nm * min(max(share, 0.0), 1.0)
