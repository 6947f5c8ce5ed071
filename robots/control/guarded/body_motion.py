"""Guarded motions of the whole body: feet planted, everything else may move."""

from __future__ import annotations

from typing import Protocol, runtime_checkable

from kinematics.motion.sampler import MotionSample
from kinematics.scene.planning_scene import PlanningScene
from robots.control.guarded.guarded_motion import GuardedMotion


@runtime_checkable
class BodyMotion(GuardedMotion, Protocol):
    """A guarded motion that says where the base is, and what it must not touch.

    The online checker judges ``body`` after each ``sample`` against ``scene``.
    """

    @property
    def body(self) -> MotionSample:
        """The last sample with base and accelerations; its joints are those that ``sample`` gave."""
        ...

    @property
    def in_contact(self) -> bool:
        """Whether a hand holds, or meets, something that may not move."""
        ...

    @property
    def scene(self) -> PlanningScene:
        """What is around now, and which pairs may touch."""
        ...
