"""Knobs and buttons as MuJoCo bodies: a joint, and one solid that fingers hold or push."""

from __future__ import annotations

import mujoco

from kinematics.geometry.poses import quaternion_from_rotation
from kinematics.model.robot_description import RobotDescription
from robots.scenes.fixture import Control, control_solid
from robots.scenes.furniture import floor_pose
from robots.scenes.furniture_names import KNOB
from robots.scenes.scene_description import Furniture
from robots.simulated.body.body_model import PAD_SOLIMP, PAD_SOLREF, PATCH_RADIUS_M, pad_name, set_role
from robots.simulated.body.geom_roles import WORLD_GROUP, Role, in_simulator

CONTROL_FRICTION = 0.9
"""Of a knob with finger pads: ribbed plastic."""
_MASS_KG = 0.05
_DAMPING = {"knob": 0.01, "button": 5.0}
_ARMATURE = {"knob": 0.005, "button": 0.5}
"""Nm s2/rad and kg: what is lighter has limits that give way."""
_LIMIT_SOLREF = (0.004, 1.0)
_PRELOAD = 0.3
"""Of a button's force: its spring holds it out by so much."""


def control_name(piece: Furniture, control: Control) -> str:
    """Name of a knob or button in its scene: "stove/knob"."""
    return f"{piece.name}/{control.name}"


def control_joint(piece: Furniture, control: Control) -> str:
    """Name of the joint that it moves on."""
    return in_simulator(f"{control_name(piece, control)}/moves")


def control_body(piece: Furniture, control: Control) -> str:
    """Name of its body."""
    return in_simulator(f"{control_name(piece, control)}/part")


def add_controls(spec: mujoco.MjSpec, piece: Furniture, description: RobotDescription) -> None:
    """Put the knobs and buttons of a fixture into the world."""
    for control in piece.controls:
        knob, solid = control.kind == KNOB, control_solid(control)
        body = spec.worldbody.add_body(name=control_body(piece, control))
        pose = floor_pose(piece) @ solid.furniture_T_solid
        x, y, z, w = quaternion_from_rotation(pose[:3, :3])
        body.pos, body.quat = pose[:3, 3], [w, x, y, z]
        joint = body.add_joint(
            name=control_joint(piece, control),
            type=mujoco.mjtJoint.mjJNT_HINGE if knob else mujoco.mjtJoint.mjJNT_SLIDE,
            axis=[1.0, 0.0, 0.0],
            range=[0.0, control.travel],
            limited=True,
            frictionloss=control.resistance if knob else 0.1,
            damping=[_DAMPING[control.kind], 0.0, 0.0],
            armature=_ARMATURE[control.kind],
        )
        joint.solref_limit = list(_LIMIT_SOLREF)
        spec.add_exclude(bodyname1=control_body(piece, control), bodyname2="world")
        if not knob:
            stiffness = (1.0 - _PRELOAD) * control.resistance / control.travel
            joint.stiffness = [stiffness, 0.0, 0.0]
            joint.springref = -_PRELOAD * control.resistance / stiffness
        name = in_simulator(control_name(piece, control))
        geom = body.add_geom(
            name=name,
            mass=_MASS_KG,
            type=mujoco.mjtGeom.mjGEOM_BOX,
            size=[0.5 * value for value in solid.shape.size_m],
            rgba=[0.15, 0.15, 0.17, 1.0] if knob else [0.75, 0.12, 0.1, 1.0],
            friction=[CONTROL_FRICTION, 0.005, 0.0001],
            group=WORLD_GROUP,
        )
        set_role(geom, Role.HANDLE)
        for gripper in description.grippers.values():
            for link in gripper.pad_links:
                spec.add_pair(
                    name=f"{pad_name(link)}|{name}",
                    geomname1=pad_name(link),
                    geomname2=name,
                    condim=4,
                    friction=[
                        CONTROL_FRICTION,
                        CONTROL_FRICTION,
                        CONTROL_FRICTION * PATCH_RADIUS_M,
                        5e-4,
                        5e-4,
                    ],
                    solref=list(PAD_SOLREF),
                    solimp=list(PAD_SOLIMP),
                )
