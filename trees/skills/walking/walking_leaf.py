"""Leaves that walk, or look with the range sensor and then walk, and leave the robot standing."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from py_trees.common import Status

from kinematics.arrays import Array
from kinematics.geometry import poses
from kinematics.geometry.shapes import Box
from kinematics.model.walking_settings import WalkingSettings
from kinematics.walking.pattern.steering import Steering
from kinematics.walking.route.room import WalkingRoom
from robots.control.motion_handle import MotionHandle
from trees.failures import Failure, Reason
from trees.nodes.leaf import DONE, RUNNING, Leaf
from trees.nodes.motion_leaf import motion_failure
from trees.readings.odometry import body_pose
from trees.toolbox import Toolbox


class WalkingLeaf(Leaf):
    """A leaf that makes one walk at a time, and leaves the robot standing whatever happens.

    When it ends early, the walk stops within its last steps.
    """

    _handle: MotionHandle | None = None

    def begin(self) -> None:
        """Forget the walk of an earlier run."""
        self._handle = None

    def ended_early(self, handle: MotionHandle) -> Status | Failure | None:
        """Why a walk ended before its time, once its last steps are made: nothing else moves before."""
        ended = motion_failure(handle)
        if ended is not None and self.toolbox.walking is not None and self.toolbox.walking.active:
            return RUNNING
        return ended

    def release(self, reason: str) -> None:
        """Stop within the last steps."""
        if self._handle is not None and self.toolbox.walking is not None:
            self.toolbox.walking.cancel(self._handle, reason)


_AROUND_M = 0.12
"""A held thing is within this of where it is believed to be, with what the sensor's noise adds."""


def without_held(toolbox: Toolbox, scan: Array) -> Array:
    """The points of a scan, shape (n, 3), that are none of what hangs on a hand.

    Args:
        toolbox: Knows what is attached, and where the hands are.
        scan: In a level frame at the base, x ahead, z up from the floor.
    """
    attached = toolbox.world.scene.attached
    if not attached:
        return scan
    model, q = toolbox.model, toolbox.sensing.state().q
    level = poses.inverse(body_pose(toolbox).transform())
    for name in sorted(attached):
        item = attached[name]
        x, y, z = (level @ model.frame_pose(q, item.frame) @ item.frame_T_object)[:3, 3]
        shape = item.body.shape
        radius_m = (
            0.5 * float(np.hypot(*shape.size_m[:2])) if isinstance(shape, Box) else float(shape.radius_m)
        )
        beside = np.hypot(scan[:, 0] - x, scan[:, 1] - y) <= radius_m + _AROUND_M
        level_with = np.abs(scan[:, 2] - z) <= 0.5 * shape.height_m + _AROUND_M
        scan = scan[~(beside & level_with)]
    return scan


def hands_have_room(toolbox: Toolbox) -> bool | None:
    """Whether drawn-in hands have room to come out here: somebody may stand there unknown.

    None where the range sensor does not tell; a robot without one has to believe it.
    """
    settings = toolbox.model.description.walking
    if toolbox.ranging is None or settings is None:
        return True
    scan = toolbox.ranging.scan()
    if scan is None:
        return None
    return WalkingRoom(settings).turn_meets(without_held(toolbox, scan), 0.0) is None


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
