"""One planned step, and no plan with the reason."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from kinematics.motion.trajectory import Trajectory
from kinematics.requests.check import CheckRequest
from kinematics.scene.concessions import Concession
from kinematics.scene.planning_scene import PlanningScene


@dataclass(frozen=True, slots=True)
class PlannedStep:
    """A trajectory with the scene that it is to be judged in.

    Attributes:
        name: "reach", "approach", ...
        trajectory: The motion.
        scene: As it was given to the planner; of a lift, with the object in the hand.
        concessions: Where the motion does not keep that scene's margins, and why.
    """

    name: str
    trajectory: Trajectory
    scene: PlanningScene
    concessions: tuple[Concession, ...] = ()

    @property
    def question(self) -> CheckRequest:
        """What the checker is to be asked."""
        return CheckRequest(self.trajectory, self.scene, self.concessions)


@dataclass(frozen=True, slots=True)
class NoPlan:
    """An honest "no".

    Attributes:
        message: One sentence for people.
        reasons: How many candidates failed for which reason.
        numbers: Figures behind the message, keys with their unit.
    """

    message: str
    reasons: Mapping[str, int]
    numbers: Mapping[str, float] = field(default_factory=dict)
