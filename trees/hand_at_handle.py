"""A hand that is about a handle: what the next task has to know."""

from __future__ import annotations

from dataclasses import dataclass

from kinematics.requests import Grasp
from trees.handles import HandleTarget


@dataclass(frozen=True, slots=True)
class HandAtHandle:
    """A hand that is about a handle, or on its last piece of way to it; it outlives the task.

    Attributes:
        target: Which handle.
        grasp: Which hand, and how.
    """

    target: HandleTarget
    grasp: Grasp
