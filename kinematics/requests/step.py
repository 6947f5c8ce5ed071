"""One planned step, and no plan with the reason."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import Enum

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


class WhyNoPlan(Enum):
    """Why there is no plan, as far as programs have to tell that apart; the value says it to people."""

    NO_WAY = "no motion to the goal was found that meets nothing and keeps the balance"
    NO_GRASP = "no grasp of the thing or handle was found that a hand can come to"
    TOO_WIDE = "the thing is wider than any hand opens"
    NO_SPOT_IS_REACHED = "the hand comes to none of the spots that were named with what it holds"


@dataclass(frozen=True, slots=True)
class NoPlan:
    """An honest "no".

    Attributes:
        message: One sentence for people.
        reasons: How many candidates failed for which reason, in words for people.
        numbers: Figures behind the message, for people; keys with their unit.
        why: What programs may decide by.
    """

    message: str
    reasons: Mapping[str, int]
    numbers: Mapping[str, float] = field(default_factory=dict)
    why: WhyNoPlan = WhyNoPlan.NO_WAY
