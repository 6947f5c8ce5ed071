"""A person as a mannequin: legs, trunk, arms and head that stand still, and one hand that can take things.

The hand is a body of its own that slides in the person's frame, turns about the forearm, and pinches
with two pads; its weight is carried. Forces move it: see ``person_hand``.
"""

from __future__ import annotations

from collections.abc import Iterable

import mujoco
import numpy as np

from kinematics.geometry.poses import quaternion_from_rotation, rotation_z, transform
from robots.scenes.person_solid import PERSON_HEIGHT_M
from robots.scenes.scene_description import Person
from robots.scenes.scene_words import COLORS
from robots.simulated.body.body_model import PAD_SOLIMP, PAD_SOLREF, set_role
from robots.simulated.body.geom_roles import WORLD_GROUP, Role, in_simulator

HAND_REST_M = (0.10, -0.28, 0.90)
"""Of the hand in the person's frame: beside the thigh."""
PINCH_M = (0.0, 0.16)
"""Of a pad from the middle of the hand: closed, and open."""
PAD_HALF_SIZE_M = (0.015, 0.010, 0.006)
"""As large as a fingertip."""
PAD_FRICTION = 1.0
HAND_DAMPING = 25.0
"""N s/m of the arm that carries the hand."""
FINGER_DAMPING = 150.0
"""N s/m: fingers that pinch with 22 N close at 0.15 m/s. Without it they clapped together at 5 m/s, and a
can flew off with thousands of newtons."""
_Point = tuple[float, float, float]
SKIN, _CLOTH = [0.85, 0.68, 0.55, 1.0], [0.30, 0.45, 0.60, 1.0]
_CAPSULES = (
    (0.08, (0.0, 0.10, 0.08), (0.0, 0.09, 0.85)),
    (0.08, (0.0, -0.10, 0.08), (0.0, -0.09, 0.85)),
    (0.13, (0.0, 0.0, 0.95), (0.0, 0.0, 1.35)),
    (0.05, (0.0, 0.19, 1.40), (0.0, 0.17, 0.85)),
    (0.05, (0.0, -0.19, 1.40), (0.0, -0.21, 1.08)),
)
_LEGS = 2
"""The first capsules of a body are its legs, the next its trunk, the last two its left and right arm."""
_ELBOW_M = _CAPSULES[-1][2]
HEAD_M = (0.0, 0.0, 1.62)
_SEAT_M = (-0.17, 0.0, -0.45)
"""From the trunk of who stands to that of who sits, about the middle of the solid."""
_RAISED_M = (0.12, 0.20, 1.66)
_POINTING_M = (0.0, 0.22, 1.38)
"""End of a left arm; a right one is its mirror image."""
_BED_M = 0.16
"""Height of the axis of who lies."""
_LEGS_WEAR = ("trousers", "jeans", "pants", "shorts", "skirt", "leggings")
_FOREARM_RADIUS_M = 0.04
_PALM_BEHIND_M = 0.08


def hand_body(person: str) -> str:
    """Name of the body of a person's hand."""
    return in_simulator(f"{person}/hand")


def hand_joint(person: str, axis: str) -> str:
    """Name of a joint of the hand: "x", "y", "z", "roll", "upper" or "lower"."""
    return in_simulator(f"{person}/hand/{axis}")


def pad_geom(person: str, side: str) -> str:
    """Name of the geom of a pad: "upper" or "lower"."""
    return in_simulator(f"{person}/{side}_pad")


def add_person(spec: mujoco.MjSpec, person: Person) -> None:
    """Put a person into the world."""
    body = spec.worldbody.add_body(name=in_simulator(person.name))
    pose = transform(rotation_z(person.yaw_rad), (*person.position_m, 0.0))
    x, y, z, w = quaternion_from_rotation(pose[:3, :3])
    body.pos, body.quat = pose[:3, 3], [w, x, y, z]
    if person.walks:
        body.mocap = True
    for i, (radius, start, end) in enumerate(limbs(person)):
        geom = body.add_geom(
            name=in_simulator(f"{person.name}/{i}"),
            type=mujoco.mjtGeom.mjGEOM_CAPSULE,
            size=[radius, 0.0, 0.0],
            fromto=[*start, *end],
            rgba=worn(person, legs=i < _legs(person)),
            group=WORLD_GROUP,
        )
        set_role(geom, Role.PERSON)
    head = body.add_geom(
        name=in_simulator(f"{person.name}/head"),
        type=mujoco.mjtGeom.mjGEOM_SPHERE,
        size=[0.11, 0.0, 0.0],
        pos=list(posed(person, HEAD_M)),
        rgba=SKIN,
        group=WORLD_GROUP,
    )
    set_role(head, Role.PERSON)
    if has_hand(person):
        _add_hand(spec, person)


def has_hand(person: Person) -> bool:
    """Whether a person has a hand that can take things: who stands still."""
    return person.posture == "standing" and not person.walks


def limbs(person: Person) -> list[tuple[float, _Point, _Point]]:
    """The capsules of a body, in the person's frame: radius and both ends."""
    standing = [(radius, start, end) for radius, start, end in _CAPSULES]
    for side, index in (("left", -2), ("right", -1)):
        sign = 1.0 if side == "left" else -1.0
        raised = person.gesture in (f"raising {side} arm", "waving" if side == "left" else None)
        if raised or person.gesture == f"pointing {side}":
            x, y, z = _RAISED_M if raised else _POINTING_M
            standing[index] = (standing[index][0], standing[index][1], (x, sign * y, z))
    bodies = [(radius, posed(person, start), posed(person, end)) for radius, start, end in standing]
    if person.posture != "sitting":
        return bodies
    back, knee = _SEAT_M[0], _SEAT_M[0] + 0.40
    legs = [
        (0.08, (at[0], y, at[1]), (knee, y, 0.50))
        for at in ((back, 0.50), (knee, 0.08))
        for y in (0.09, -0.09)
    ]
    return [*legs, *bodies[_LEGS:]]


def _legs(person: Person) -> int:
    return 2 * _LEGS if person.posture == "sitting" else _LEGS


def posed(person: Person, point: _Point) -> _Point:
    """A point of who stands, where it is in the posture of the person."""
    x, y, z = point
    match person.posture:
        case "sitting":
            return x + _SEAT_M[0], y + _SEAT_M[1], z + _SEAT_M[2]
        case "lying":
            return z - 0.5 * PERSON_HEIGHT_M, y, _BED_M + x
        case _:
            return point


def worn(person: Person, *, legs: bool) -> list[float]:
    """The colour of what covers legs or trunk."""
    for one in person.clothes:
        color, _, garment = one.partition(" ")
        if (garment in _LEGS_WEAR) is legs:
            return [*COLORS[color], 1.0]
    return _CLOTH


def draw_forearms(
    scene: mujoco.MjvScene, model: mujoco.MjModel, data: mujoco.MjData, people: Iterable[Person]
) -> None:
    """Draw what joins each person's elbow and hand; it is in the picture alone."""
    for person in filter(has_hand, people):
        if scene.ngeom >= scene.maxgeom:
            return
        elbow = transform(rotation_z(person.yaw_rad), (*person.position_m, 0.0)) @ [*_ELBOW_M, 1.0]
        body = model.body(hand_body(person.name)).id
        palm = data.xpos[body] - _PALM_BEHIND_M * data.xmat[body].reshape(3, 3)[:, 0]
        geom = scene.geoms[scene.ngeom]
        capsule = mujoco.mjtGeom.mjGEOM_CAPSULE
        mujoco.mjv_initGeom(
            geom,
            capsule,
            np.zeros(3),
            np.zeros(3),
            np.zeros(9),
            np.array(worn(person, legs=False), np.float32),
        )
        mujoco.mjv_connector(geom, capsule, _FOREARM_RADIUS_M, elbow[:3], palm)
        scene.ngeom += 1


def _add_hand(spec: mujoco.MjSpec, person: Person) -> None:
    pose = transform(rotation_z(person.yaw_rad), (*person.position_m, 0.0))
    x, y, z, w = quaternion_from_rotation(pose[:3, :3])
    hand = spec.worldbody.add_body(name=hand_body(person.name), gravcomp=1.0)
    hand.pos = (pose @ [*HAND_REST_M, 1.0])[:3]
    hand.quat = [w, x, y, z]
    for name, axis in (("x", [1.0, 0.0, 0.0]), ("y", [0.0, 1.0, 0.0]), ("z", [0.0, 0.0, 1.0])):
        hand.add_joint(
            name=hand_joint(person.name, name),
            type=mujoco.mjtJoint.mjJNT_SLIDE,
            axis=axis,
            damping=[HAND_DAMPING, 0.0, 0.0],
        )
    hand.add_joint(
        name=hand_joint(person.name, "roll"),
        type=mujoco.mjtJoint.mjJNT_HINGE,
        axis=[1.0, 0.0, 0.0],
        damping=[0.3, 0.0, 0.0],
        armature=0.005,
    )
    palm = hand.add_geom(
        name=in_simulator(f"{person.name}/palm"),
        type=mujoco.mjtGeom.mjGEOM_SPHERE,
        size=[0.035, 0.0, 0.0],
        pos=[-_PALM_BEHIND_M, 0.0, 0.0],
        mass=0.5,
        rgba=SKIN,
        group=WORLD_GROUP,
    )
    set_role(palm, Role.NONE)
    for name, side in (("upper", 1.0), ("lower", -1.0)):
        finger = hand.add_body(name=in_simulator(f"{person.name}/{name}"), gravcomp=1.0)
        finger.add_joint(
            name=hand_joint(person.name, name),
            type=mujoco.mjtJoint.mjJNT_SLIDE,
            axis=[0.0, 0.0, side],
            range=list(PINCH_M),
            limited=True,
            damping=[FINGER_DAMPING, 0.0, 0.0],
        )
        pad = finger.add_geom(
            name=pad_geom(person.name, name),
            type=mujoco.mjtGeom.mjGEOM_BOX,
            size=list(PAD_HALF_SIZE_M),
            mass=0.05,
            rgba=SKIN,
            condim=4,
            friction=[PAD_FRICTION, 0.02, 0.0001],
            solref=list(PAD_SOLREF),
            solimp=list(PAD_SOLIMP),
            group=WORLD_GROUP,
        )
        set_role(pad, Role.PERSON)
