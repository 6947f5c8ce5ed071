"""The head of a robot that walks: it turns to where a walk is told to look, within its joints' limits."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from kinematics.arrays import Array
from kinematics.model.robot_model import RobotModel
from robots.control.grip.joint_tracker import JointTracker

_SPEED_RAD_S = 1.2
_ACCELERATION_RAD_S2 = 4.0
_JERK_RAD_S3 = 40.0
"""Gentler than the joints could: a head that jerks shakes the picture, and is felt at the neck as a push."""


class WalkingHead:
    """Moves the joints that aim the camera, one control period after the other.

    Attributes:
        columns: Of its joints in a configuration, shape (n,).
    """

    def __init__(self, model: RobotModel, q: Array, period_s: float) -> None:
        """Rest where it is.

        Args:
            model: The robot; without joints that aim its camera nothing moves.
            q: Configuration now, shape (nq,).
            period_s: The control period.
        """
        camera, limits = model.description.head_camera, model.description.limits
        self._names = [] if camera is None or camera.neck is None else list(camera.neck)
        self.columns: NDArray[np.intp] = np.array(
            [7 + model.joint_index(name) for name in self._names], dtype=np.intp
        )
        margin = model.description.planning_margin_rad
        self._range = [
            (limits[name].position[0] + margin, limits[name].position[1] - margin) for name in self._names
        ]
        self._trackers = [
            JointTracker(
                float(q[column]),
                min(_SPEED_RAD_S, limits[name].velocity),
                min(_ACCELERATION_RAD_S2, limits[name].acceleration),
                period_s,
                min(_JERK_RAD_S3, limits[name].jerk),
            )
            for name, column in zip(self._names, self.columns.tolist(), strict=True)
        ]
        self._wanted: list[float] | None = None

    @property
    def at_rest(self) -> bool:
        """Whether it does not move."""
        return not any(tracker.moving for tracker in self._trackers)

    def look(self, pan_rad: float, tilt_rad: float) -> None:
        """Turn there; as far as the joints go."""
        self._wanted = [
            min(max(wanted, low), high)
            for wanted, (low, high) in zip((pan_rad, tilt_rad), self._range, strict=False)
        ]

    def advance(self, *, resting: bool) -> Array | None:
        """Go on by a period.

        Args:
            resting: Whether the walk comes to rest: then the head stays where it can stop.

        Returns:
            Where its joints are then, shape (n,); None while nobody has told it to look anywhere.
        """
        if self._wanted is None:
            return None
        for tracker, wanted in zip(self._trackers, self._wanted, strict=True):
            if resting:
                tracker.step_to_rest()
            else:
                tracker.step_towards(wanted)
        return np.array([tracker.q_rad for tracker in self._trackers])
