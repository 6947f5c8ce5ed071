"""What every request to the motion planner has, and that its answer has the request's type."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Generic, TypeVar

from kinematics.arrays import Array, Sealed
from kinematics.model.stance import Stance
from kinematics.scene.planning_scene import PlanningScene

Answer = TypeVar("Answer", covariant=True)


@dataclass(frozen=True, slots=True)
class Request(Sealed, Generic[Answer]):
    """What is asked of the motion planner: a frozen value, so that it can be sent to a worker process.

    Its parameter is the type of what it is answered by: a ``Request[PickPlan | NoPlan]`` has a pick's plan
    for an answer, or an honest "no", wherever it is answered.

    Attributes:
        q_start: Configuration to start from (the commanded reference), shape (nq,).
        stance: Where the feet stand.
        scene: What is around, and what is in the hands.
    """

    q_start: Array
    stance: Stance
    scene: PlanningScene
