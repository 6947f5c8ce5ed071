"""Which motor is which joint: the order of the wire, and that of the control loop."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from kinematics.model.robot_description import Hand
from robots.errors import DescriptionError

_LEG = ("hip_pitch", "hip_roll", "hip_yaw", "knee", "ankle_pitch", "ankle_roll")
_ARM = ("shoulder_pitch", "shoulder_roll", "shoulder_yaw", "elbow", "wrist_roll", "wrist_pitch", "wrist_yaw")
G1 = (
    *(f"left_{name}_joint" for name in _LEG),
    *(f"right_{name}_joint" for name in _LEG),
    "waist_yaw_joint",
    "waist_roll_joint",
    "waist_pitch_joint",
    *(f"left_{name}_joint" for name in _ARM),
    *(f"right_{name}_joint" for name in _ARM),
)
"""Joints of a G1 with 29 motors by the motor's number."""
ARM_WEIGHT = 29
"""The place whose position is the weight of ``arm_sdk``: 1 takes arms and waist over, 0 gives them back."""
LEGS = range(12)
"""Motors of the legs, which stay the maker's under ``arm_sdk``."""

DEX3 = ("thumb_0", "thumb_1", "thumb_2", "middle_0", "middle_1", "index_0", "index_1")
"""Joints of a hand by the motor's number, the same of both hands."""

Motors = NDArray[np.intp]


def motors_of(joints: Sequence[str]) -> Motors:
    """The motor of each joint, shape (n,).

    Raises:
        DescriptionError: A joint has no motor on this wire; the message names it.
    """
    missing = [name for name in joints if name not in G1]
    if missing:
        raise DescriptionError(
            f"joint {missing[0]!r} has no motor on the low-level interface of a G1; its {len(G1)} are "
            f"{G1[0]} to {G1[-1]}"
        )
    return np.array([G1.index(name) for name in joints], dtype=np.intp)


def hand_motors_of(joints: Sequence[str], hand: Hand) -> Motors:
    """The motor of each joint of a hand, shape (n,).

    Raises:
        DescriptionError: A joint has no motor there; the message names it.
    """
    names = [f"{hand}_hand_{name}_joint" for name in DEX3]
    missing = [name for name in joints if name not in names]
    if missing:
        raise DescriptionError(f"joint {missing[0]!r} has no motor in a Dex3; its {len(names)} are {names}")
    return np.array([names.index(name) for name in joints], dtype=np.intp)
