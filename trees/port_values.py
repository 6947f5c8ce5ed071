"""Values that travel between leaves: planned and checked steps, and the object that is meant."""

from __future__ import annotations

from dataclasses import dataclass

from kinematics.arrays import Sealed
from kinematics.geometry.poses import Transform
from kinematics.geometry.shapes import Shape
from kinematics.model.robot_description import Hand
from kinematics.motion.trajectory import Trajectory
from kinematics.motion.verdict import CheckedTrajectory
from kinematics.requests.check import CheckRequest
from kinematics.requests.step import PlannedStep
from kinematics.scene.concessions import Concession
from kinematics.scene.planning_scene import PlanningScene


@dataclass(frozen=True, slots=True)
class Target(Sealed):
    """The object that a task is about, as it was last seen.

    Attributes:
        name: Its name in the planning scene.
        kind, color: As perception tells them.
        shape: Its solid.
        odom_T_object: Its pose, shape (4, 4).
        confidence: Of the detection, in [0, 1].
    """

    name: str
    kind: str
    color: str | None
    shape: Shape
    odom_T_object: Transform
    confidence: float


@dataclass(frozen=True, slots=True)
class Step:
    """A planned motion with the scene it was made for.

    Attributes:
        name: What it is: "reach", "approach", "lift", ...
        trajectory: The motion.
        scene: The scene that it is to be judged in: as the world model has it.
        world_version: Version of the world model's scene that it was planned from; when the world
            model has moved on, the step is stale.
        concessions: Where the motion does not keep the scene's margins, and why.
    """

    name: str
    trajectory: Trajectory
    scene: PlanningScene
    world_version: int
    concessions: tuple[Concession, ...] = ()

    @property
    def question(self) -> CheckRequest:
        """What the checker is to be asked."""
        return CheckRequest(self.trajectory, self.scene, self.concessions)

    @classmethod
    def of(cls, planned: PlannedStep, world_version: int) -> Step:
        """What the planner found, with the version of the world model that it was asked about."""
        return cls(planned.name, planned.trajectory, planned.scene, world_version, planned.concessions)


@dataclass(frozen=True, slots=True)
class CheckedStep:
    """A planned step whose trajectory the checker has let pass."""

    name: str
    checked: CheckedTrajectory
    world_version: int


@dataclass(frozen=True, slots=True)
class Placement(Sealed):
    """Where a held object is to stand.

    Attributes:
        hand: The hand that holds it.
        odom_T_object: Its pose there, shape (4, 4).
        touches: Names of what it may touch there.
        spot: A name for the spot, by which later attempts recognize it and leave it out.
    """

    hand: Hand
    odom_T_object: Transform
    touches: tuple[str, ...]
    spot: tuple[float, float]
