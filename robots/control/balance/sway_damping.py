"""Takes the swing out of a robot that stands: torques of the legs against speeds that nobody commands.

Body and servos are a mass on springs that hardly damp: pushed by 80 N for 0.1 s, or when a bar slips out of
the hand that pulls on it, TALOS swings at 1.3 to 3 Hz, and its legs still move by 0.03 rad/s half a second
later. With six times the servos' own damping, 0.005 rad/s; with four times an ankle still moved by 0.020
rad/s half a second after an arm that carried a box was cancelled. With eight the ankles of a robot that led
a door were asked for more than they gave, and taken for weak. The servos' own gains cannot be raised from
here, and their damping acts on the noise of a single period; this one is smoothed.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array
from kinematics.compiled.compiler import compiled
from robots.interface.hardware import RobotData

Indices = NDArray[np.intp]

_SHARE = 6.0
"""Of the servo's damping; standing still, its torque is noise of 0.3 Nm."""
_SMOOTH_S = 0.02
"""Speeds are averaged over this: a tenth of the swing's phase, a tenth of the encoders' noise."""
_MOST = 0.2
"""Of the effort limit."""


class SwayDamping:
    """The torques of one robot that stands."""

    def __init__(self, data: RobotData, period_s: float) -> None:
        """Prepare; a robot without legs gets none."""
        description, gains = data.description, data.hardware.gains
        joints = description.actuated
        legs = {
            name for group, names in description.groups.items() if group.endswith("_leg") for name in names
        }
        self._legs = np.array([k for k, name in enumerate(joints) if name in legs], dtype=np.intp)
        named = [joints[k] for k in self._legs]
        self._damping = _SHARE * np.array([gains[name].damping for name in named])
        self._limit = np.array([description.limits[name].effort for name in named])
        self._share = min(1.0, period_s / _SMOOTH_S)
        self._stray = np.zeros(len(named))

    def sense(self, measured_rad_s: Array, commanded_rad_s: Array) -> None:
        """Take in, once a control period, how the joints move and how they were told to, shape (n,)."""
        _smooth(self._stray, measured_rad_s, commanded_rad_s, self._legs, self._share)

    def forget(self) -> None:
        """The feet move, and somebody else balances: begin anew when the robot stands."""
        self._stray[:] = 0.0

    def add_to(self, efforts: Array) -> None:
        """Add the torques to the feed-forward of the actuated joints, Nm, shape (n,), within the limits."""
        _damp(efforts, self._stray, self._legs, self._damping, self._limit)


@compiled
def _smooth(stray: Array, measured: Array, commanded: Array, joints: Indices, share: float) -> None:
    """Draw averages, shape (k,), nearer to what the joints at these places do beyond what they were told."""
    for k in range(joints.shape[0]):
        j = joints[k]
        stray[k] += share * (measured[j] - commanded[j] - stray[k])


@compiled
def _damp(efforts: Array, stray: Array, joints: Indices, damping: Array, limit: Array) -> None:
    """Add torques against stray speeds to the efforts at these places; arrays of shape (k,) but the first."""
    for k in range(joints.shape[0]):
        j = joints[k]
        torque = min(max(-damping[k] * stray[k], -_MOST * limit[k]), _MOST * limit[k])
        room = max(limit[k], abs(efforts[j]))  # what is too much already is for the gate to say
        efforts[j] = min(max(efforts[j] + torque, -room), room)
