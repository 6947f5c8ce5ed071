"""Have a planned step judged."""

from __future__ import annotations

from kinematics.motion.verdict import CheckedTrajectory, Unsafe
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.job_leaf import JobLeaf
from trees.nodes.plan_failures import unsafe_failure, why_stale
from trees.nodes.ports import ports
from trees.port_values import CheckedStep, Step
from trees.toolbox import Job


class CheckTrajectory(JobLeaf[CheckedTrajectory | Unsafe]):
    """Have the trajectory checker judge one planned step, and hand it on if it is found safe."""

    INPUT_PORTS = ports(step=Step)
    OUTPUT_PORTS = ports(checked=CheckedStep)
    CONTRACT = Contract(
        precondition="the step was planned for the present scene",
        postcondition="the checker found no defect, and the scene has not changed meanwhile",
        deadline_s=10.0,
    )

    def job(self) -> Job[CheckedTrajectory | Unsafe]:
        """Judge the step's trajectory in the step's scene, with its concessions."""
        step: Step = self.get_input("step")
        self._judged = step
        return self.toolbox.planning.check(step.question)

    def accept(self, answer: CheckedTrajectory | Unsafe) -> Failure | None:
        """Write the checked step, unless it was made for a scene of the past."""
        step, version = self._judged, self.toolbox.world.scene.version
        if isinstance(answer, Unsafe):
            return unsafe_failure(step.name, answer)
        if (stale := why_stale(step.name, step.world_version, version)) is not None:
            return stale
        self._set_output("checked", CheckedStep(step.name, answer, step.world_version))
        self.feedback_message = f"{step.name} is safe"
        self.measured(
            step=step.name,
            duration_s=answer.trajectory.duration_s,
            min_distance_m=answer.min_distance_m,
            min_com_margin_m=answer.min_com_margin_m,
        )
        return None
