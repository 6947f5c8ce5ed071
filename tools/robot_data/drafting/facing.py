"""Which way a robot's root link stands in the world: some look along -x, and some have y up."""

from __future__ import annotations

import numpy as np

from kinematics.arrays import Array
from tools.robot_data.drafting.anatomy import Anatomy
from tools.robot_data.drafting.limbs import Limbs

_SURE = 0.8
"""Share of a direction along one axis that counts as along it."""


def level_turn(anatomy: Anatomy, limbs: Limbs) -> Array:
    """Rotation from the root link's axes to a frame with z up and x ahead, shape (3, 3).

    Legs tell what is up, limbs that are called left and right what is left.
    """
    up = np.array([0.0, 0.0, 1.0])
    feet = [limbs.groups[group] for group in limbs.groups if group.endswith("_leg")]
    if feet:
        steps = [anatomy.place(leg[0])[:3, 3] - anatomy.place(leg[-1])[:3, 3] for leg in feet]
        up = _axis(np.sum(steps, axis=0), up)
    left = _left(anatomy, limbs, up)
    return np.array([np.cross(left, up), left, up])


def _left(anatomy: Anatomy, limbs: Limbs, up: Array) -> Array:
    for limb in ("arm", "leg"):
        pair = [limbs.groups.get(f"{side}_{limb}") for side in ("left", "right")]
        if pair[0] is not None and pair[1] is not None:
            apart = anatomy.place(pair[0][0])[:3, 3] - anatomy.place(pair[1][0])[:3, 3]
            usual = np.array([0.0, 1.0, 0.0])
            return _axis(
                apart - up * (up @ apart), usual if abs(up[1]) < _SURE else np.array([0.0, 0.0, -1.0])
            )
    usual = np.array([0.0, 1.0, 0.0])
    return usual if abs(up[1]) < _SURE else np.array([0.0, 0.0, -1.0])


def _axis(way: Array, usual: Array) -> Array:
    """The axis that a direction is along; the usual one when it is along none."""
    length = float(np.linalg.norm(way))
    if length < 1e-6 or float(np.abs(way).max()) < _SURE * length:
        return usual
    found = np.zeros(3)
    k = int(np.abs(way).argmax())
    found[k] = np.sign(way[k])
    return found
