"""Plan to stretch an arm towards something."""

from __future__ import annotations

from typing import Any

from kinematics.requests.gesture import PointRequest
from kinematics.requests.move import MovePlan
from kinematics.requests.step import NoPlan
from trees.beliefs.grounding.destination import Place
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.job_leaf import JobLeaf
from trees.nodes.plan_failures import no_plan_failure
from trees.nodes.ports import ports
from trees.port_values import Step
from trees.readings.free_hand import free_hands
from trees.tasks import PointAtTask


class PlanPointing(JobLeaf):
    """Have the planner stretch a free arm towards what the task means; it tries the nearer arm first."""

    INPUT_PORTS = ports(task=PointAtTask, place=Place)
    OUTPUT_PORTS = ports(reach=Step)
    CONTRACT = Contract(
        precondition="what is meant was seen; a hand is free; the robot is at rest",
        postcondition="the motion starts at the reference and is for the present scene; at its end the line "
        "through forearm and hand meets what is meant",
        deadline_s=20.0,
    )

    def request(self) -> PointRequest | Failure:
        """Point with any free hand."""
        toolbox = self.toolbox
        free = free_hands(toolbox, self.get_input("task").hand)
        if isinstance(free, Failure):
            return free
        self._world_version = toolbox.world.scene.version
        x, y, z = (float(value) for value in self.get_input("place").aim_m)
        return PointRequest(
            q_start=toolbox.motion.reference(),
            stance=toolbox.motion.stance(),
            scene=toolbox.world.scene,
            target_m=(x, y, z),
            hands=free,
            seed=int(toolbox.rng.integers(2**31)),
        )

    def accept(self, answer: Any) -> Failure | None:
        """Write the step."""
        if isinstance(answer, NoPlan):
            return no_plan_failure(answer)
        if not isinstance(answer, MovePlan):
            raise TypeError(f"the planner answered {type(answer).__name__} to {self.name}")
        step = answer.step
        self._set_output("reach", Step.of(step, self._world_version))
        return None
