"""Kinds of joints with gains and limits: from the inertia that a joint moves and what gravity asks of it."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import pinocchio as pin

from tools.robot_data.drafting.anatomy import Anatomy
from tools.robot_data.drafting.guesses import Guesses
from tools.robot_data.drafting.limbs import Limbs

_FREQUENCY_RAD_S = 40.0
_SAG_RAD = 0.01
"""A servo alone gives way so much under a limb's own weight, at most."""
_STIFFEST = 10_000.0
_PER_RAD = 40.0
"""Stiffness over effort, at most: a servo a millisecond behind a quick motion is not to seem weak."""
_DAMPING_S = 0.02
"""Damping over stiffness, of TALOS's arms as of Panda's."""
_STANDING = 6.0
"""Stiffness of a leg's joint over what the weight asks for when the body tips (m g h): TALOS's."""
_ARMATURE = 0.05
"""Rotor inertia over what a joint moves."""
_STRONGEST_POSTURES = 300
_SPARE = 1.5
"""Effort over the most that gravity asks for."""
_VELOCITY_RAD_S = 2.0
_FASTEST_RAD_S = 10.0
ACCELERATION_RAD_S2 = 8.0
JERK_RAD_S3 = 120.0
_GRAVITY_M_S2 = 9.81


@dataclass(frozen=True, slots=True)
class Kind:
    """Joints of one kind.

    Attributes:
        name: "arm", "wrist", "torso", ...
        joints: Of it.
        stiffness, damping, armature: Of their servos, Nm/rad, Nm s/rad, kg m^2.
        velocity, effort: Limits over the URDF's, rad/s and Nm; None where those will do.
    """

    name: str
    joints: tuple[str, ...]
    stiffness: float
    damping: float
    armature: float
    velocity: float | None
    effort: float | None


def kinds_of(anatomy: Anatomy, limbs: Limbs, guesses: Guesses) -> list[Kind]:
    """Sort the joints that move into kinds, and give each what its strongest member needs."""
    members = _members(anatomy, limbs)
    moved, gravity = _loads(anatomy, limbs)
    standing = _tipping_nm(anatomy) * _STANDING
    kinds = []
    for name, joints in members.items():
        inertia = max(moved[joint] for joint in joints)
        bent = max(gravity[joint] for joint in joints) / _SAG_RAD
        velocity = _velocity(anatomy, joints)
        effort = _effort(anatomy, joints, gravity, name)
        strength = effort or min(anatomy.joints[joint].effort for joint in joints)
        stiffness = _round(min(max(_FREQUENCY_RAD_S**2 * inertia, bent, 1.0), _STIFFEST, _PER_RAD * strength))
        if _stands(name):
            stiffness = _round(max(stiffness, standing))
        kinds.append(
            Kind(
                name,
                tuple(joints),
                stiffness,
                _round(stiffness * _DAMPING_S),
                _round(min(max(_ARMATURE * inertia, 1e-4), 0.1)),
                velocity,
                effort,
            )
        )
        guesses.add(
            f"gains.{name}", f"stiffness {stiffness:g}", "from the inertia moved, and of legs the weight"
        )
        guesses.add(
            f"limits.acceleration.{name}",
            f"{ACCELERATION_RAD_S2:g}, jerk {JERK_RAD_S3:g}",
            "those of TALOS's arms",
        )
        if velocity is not None:
            guesses.add(
                f"limits.velocity.{name}", f"{velocity:g}", "the URDF has none, or one that nothing reaches"
            )
        if effort is not None:
            guesses.add(
                f"limits.effort.{name}", f"{effort:g}", "the URDF's do not bear the limb's own weight"
            )
    return kinds


def _members(anatomy: Anatomy, limbs: Limbs) -> dict[str, list[str]]:
    """Joints of a limb that are as strong as one another are of one kind, on both sides."""
    sorted_by: dict[tuple[str, float], list[str]] = {}
    for group, joints in limbs.groups.items():
        limb = group.removeprefix("left_").removeprefix("right_")
        for place, joint in enumerate(joints):
            part = "ankle" if limb == "leg" and place >= len(joints) - 2 else limb
            sorted_by.setdefault((part, anatomy.joints[joint].effort), []).append(joint)
    members: dict[str, list[str]] = {}
    for (part, _), alike in sorted_by.items():
        count = sum(name.partition("_")[0] == part for name in members)
        members[f"{part}_{count + 1}"] = alike
    return members


def _stands(kind: str) -> bool:
    return kind.partition("_")[0] in ("leg", "ankle")


def _loads(anatomy: Anatomy, limbs: Limbs) -> tuple[dict[str, float], dict[str, float]]:
    """By joint: the most inertia that it moves, kg m^2, and the most that gravity asks of it, Nm."""
    model, data = anatomy.model, anatomy.model.createData()
    rng = np.random.default_rng(0)
    moving = [joint for joints in limbs.groups.values() for joint in joints]
    rows = np.array([model.joints[model.getJointId(joint)].idx_v for joint in moving])
    low = np.array([max(anatomy.joints[joint].lower, -math.pi) for joint in moving])
    high = np.array([min(anatomy.joints[joint].upper, math.pi) for joint in moving])
    inertia, gravity = np.zeros(len(moving)), np.zeros(len(moving))
    for _ in range(_STRONGEST_POSTURES):
        q = anatomy.q.copy()
        q[rows] = rng.uniform(low, high)
        inertia = np.maximum(inertia, np.diag(pin.crba(model, data, q))[rows])
        gravity = np.maximum(gravity, np.abs(pin.computeGeneralizedGravity(model, data, q))[rows])
    return dict(zip(moving, inertia.tolist(), strict=True)), dict(zip(moving, gravity.tolist(), strict=True))


def _tipping_nm(anatomy: Anatomy) -> float:
    """What the weight asks for a radian out of balance, Nm."""
    com = pin.centerOfMass(anatomy.model, anatomy.model.createData(), anatomy.q)
    height = float(com[2] - anatomy.everything()[:, 2].min())
    return float(pin.computeTotalMass(anatomy.model)) * _GRAVITY_M_S2 * height


def _velocity(anatomy: Anatomy, joints: list[str]) -> float | None:
    told = [anatomy.joints[joint].velocity for joint in joints]
    if min(told) < 0.05:
        return _VELOCITY_RAD_S
    return _FASTEST_RAD_S if max(told) > 100.0 else None


def _effort(anatomy: Anatomy, joints: list[str], gravity: dict[str, float], kind: str) -> float | None:
    told = {joint: anatomy.joints[joint].effort for joint in joints}
    if _stands(kind):  # what they bear is the body above
        return None if min(told.values()) > 1.0 else _round(0.5 * _tipping_nm(anatomy))
    needed = {joint: max(_SPARE * gravity[joint], 0.5) for joint in joints}
    if all(told[joint] >= needed[joint] for joint in joints):
        return None
    return _round(max(max(told.values()), *needed.values(), 2.0 * max(gravity[joint] for joint in joints)))


def _round(value: float) -> float:
    """To two digits."""
    digits = 1 - math.floor(math.log10(abs(value))) if value else 0
    return round(value, digits)
