"""A leaf that looks with the range sensor, then walks or turns once, and waits until the robot stands."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from py_trees.common import Status

from kinematics.model.walking_settings import WalkingSettings
from kinematics.walking.pattern.steering import Steering
from trees.failures import Failure, Reason
from trees.nodes.leaf import DONE, RUNNING
from trees.skills.walking.scan_without_load import without_held
from trees.skills.walking.walking_leaf import WalkingLeaf


class ScannedWalk(WalkingLeaf):
    """A leaf that looks with the range sensor, then walks or turns once, and waits until the robot stands.

    A subclass decides, from what the sensor has seen, where to walk.
    """

    def steering(self, settings: WalkingSettings, scan: NDArray[np.float64]) -> Steering | Failure | None:
        """The way to go; None where there is nothing to do.

        Args:
            settings: The sizes of a robot that walks.
            scan: What the range sensor sees about the robot without what it holds, shape (n, 3), m.
        """
        raise NotImplementedError

    def step(self) -> Status | Failure:
        """Set out once, and wait until the robot stands."""
        toolbox = self.toolbox
        settings = toolbox.model.description.walking
        if settings is None or toolbox.walking is None or toolbox.ranging is None:
            message = f"{toolbox.model.description.name} cannot walk here"
            return Failure.infeasible(message).because(Reason.CANNOT_WALK)
        if self._handle is None:
            scan = toolbox.ranging.scan()
            if scan is None:
                self.feedback_message = "waiting for the range sensor"
                return RUNNING
            steering = self.steering(settings, without_held(toolbox, scan))
            if steering is None:
                return DONE
            if isinstance(steering, Failure):
                return steering
            self._handle = toolbox.walking.walk(steering, "walk")
        if (ended := self.ended_early(self._handle)) is not None:
            return ended
        return DONE if self._handle.finished else RUNNING
