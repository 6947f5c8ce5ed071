"""A hand without an arm: two boxes of rubber that close on a thing with one force and lift it."""

import mujoco
import numpy as np

from kinematics.arrays import Array
from kinematics.geometry.convex_parts import ConvexParts
from kinematics.geometry.poses import quaternion_from_rotation

FORCE_N = 25.0
LIFT_M, LIFT_S, HOLD_S = 0.12, 0.6, 1.0


def holds(
    parts: ConvexParts,
    object_T_tcp: Array,
    opening_m: float,
    pads_m: tuple[float, float],
    mass_kg: float = 0.3,
    friction: float = 0.6,
) -> bool:
    """Whether a hand at a pose in the thing's frame lifts it; gravity is along the thing's own -z.

    Args:
        parts: What the thing is made of.
        object_T_tcp: Where the hand really is, shape (4, 4).
        opening_m: How far it is open when it begins.
        pads_m: Half-sizes of a pad: along the approach, across it.
        mass_kg, friction: Of the thing.
    """
    spec = mujoco.MjSpec()
    spec.option.cone = mujoco.mjtCone.mjCONE_ELLIPTIC
    spec.option.impratio = 100.0
    spec.option.integrator = mujoco.mjtIntegrator.mjINT_IMPLICITFAST
    spec.option.timestep = 0.001
    low = float(parts.corners[:, 2].min())
    spec.worldbody.add_geom(
        name="floor", type=mujoco.mjtGeom.mjGEOM_BOX, size=[1, 1, 0.05], pos=[0, 0, low - 0.05]
    )
    thing = spec.worldbody.add_body(name="thing")
    thing.add_freejoint()
    for number, hull in enumerate(parts.hulls):
        mesh = spec.add_mesh(name=f"part {number}")
        mesh.uservert, mesh.inertia = hull.ravel(), mujoco.mjtMeshInertia.mjMESH_INERTIA_CONVEX
        thing.add_geom(
            name=f"part {number}",
            type=mujoco.mjtGeom.mjGEOM_MESH,
            meshname=f"part {number}",
            mass=mass_kg / len(parts.hulls),
            condim=4,
            friction=[friction, 0.01, 0.0005],
        )
    x, y, z, w = quaternion_from_rotation(object_T_tcp[:3, :3])
    carrier = spec.worldbody.add_body(name="carrier", pos=object_T_tcp[:3, 3], quat=[w, x, y, z])
    carrier.gravcomp = 1.0
    carrier.add_joint(name="lift", type=mujoco.mjtJoint.mjJNT_SLIDE, axis=object_T_tcp[2, :3])
    carrier.add_geom(type=mujoco.mjtGeom.mjGEOM_SPHERE, size=[0.01, 0, 0], mass=2.0, contype=0, conaffinity=0)
    servo = spec.add_actuator(name="servo", target="lift")
    servo.trntype = mujoco.mjtTrn.mjTRN_JOINT
    servo.set_to_position(kp=20000.0, kv=400.0)
    along, across = pads_m
    for side in (-1.0, 1.0):
        pad = carrier.add_body(name=f"pad {side}", pos=[0, side * (0.5 * opening_m + 0.008), 0])
        pad.gravcomp = 1.0
        joint = pad.add_joint(type=mujoco.mjtJoint.mjJNT_SLIDE, axis=[0, -side, 0], name=f"slide {side}")
        joint.damping = [20.0, 0.0, 0.0]
        pad.add_geom(
            name=f"pad {side}",
            type=mujoco.mjtGeom.mjGEOM_BOX,
            size=[along, 0.008, across],
            mass=0.1,
            condim=4,
            friction=[friction, friction * 0.02, 0.0005],
            priority=1,
            solref=[0.01, 1.0],
            solimp=[0.9, 0.97, 0.002, 0.5, 2.0],
        )
        motor = spec.add_actuator(name=f"motor {side}", target=f"slide {side}")
        motor.trntype = mujoco.mjtTrn.mjTRN_JOINT
    # both pads keep one middle, as fingers of one drive do
    both = spec.add_equality(type=mujoco.mjtEq.mjEQ_JOINT, name1="slide 1.0", name2="slide -1.0")
    both.data[:2] = [0.0, 1.0]
    both.solref = [0.004, 1.0]
    model = spec.compile()
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    start = data.body("thing").xpos.copy()
    data.ctrl[1:] = FORCE_N
    closing = 0.8
    end_s = closing + LIFT_S + HOLD_S
    while data.time < end_s:
        share = np.clip((data.time - closing) / LIFT_S, 0.0, 1.0)
        data.ctrl[0] = LIFT_M * share
        mujoco.mj_step(model, data)
    return bool(data.body("thing").xpos[2] - start[2] > 0.7 * LIFT_M)
