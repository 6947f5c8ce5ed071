"""Plan to stretch an arm towards something."""

from __future__ import annotations

from kinematics.requests.gesture import PointRequest
from kinematics.requests.move import MovePlan
from trees.beliefs.grounding.destination import Place
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.job_leaf import PlanningLeaf
from trees.nodes.ports import ports
from trees.port_values import Step
from trees.readings.held import free_hands
from trees.tasks import PointAtTask


class PlanPointing(PlanningLeaf[MovePlan]):
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
        x, y, z = (float(value) for value in self.get_input("place").aim_m)
        return PointRequest(
            q_start=toolbox.motion.reference(),
            stance=toolbox.motion.stance(),
            scene=toolbox.world.scene,
            target_m=(x, y, z),
            hands=free,
            seed=int(toolbox.rng.integers(2**31)),
        )

    def planned(self, plan: MovePlan) -> None:
        """Write the step."""
        self.write_step("reach", plan.step)
