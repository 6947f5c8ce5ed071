"""A trajectory to be judged."""

from __future__ import annotations

from dataclasses import dataclass

from kinematics.motion.trajectory import Trajectory
from kinematics.scene.concessions import Concession
from kinematics.scene.planning_scene import PlanningScene


@dataclass(frozen=True, slots=True)
class CheckRequest:
    """Judge a trajectory against a scene; answered by CheckedTrajectory or Unsafe.

    Attributes:
        trajectory: The motion.
        scene: What is around and in the hands, as the world model has it.
        concessions: What the motion's planner asks to be overlooked; the checker says how much of it is.
    """

    trajectory: Trajectory
    scene: PlanningScene
    concessions: tuple[Concession, ...] = ()
