"""Carry out a checked step."""

from __future__ import annotations

from py_trees.common import Status

from robots.control.motion_handle import MotionHandle
from trees.failures import Failure
from trees.nodes.arrival import arrival
from trees.nodes.contract import Contract
from trees.nodes.motion_leaf import MotionLeaf
from trees.nodes.plan_failures import why_stale
from trees.nodes.ports import ports
from trees.port_values import CheckedStep


class StreamMotion(MotionLeaf):
    """Stream the trajectory of one checked step, and measure that the joints have arrived at its end."""

    INPUT_PORTS = ports(checked=CheckedStep)
    OUTPUT_PORTS = ports()
    CONTRACT = Contract(
        precondition="the step was checked for the present scene and starts at the reference",
        postcondition="every joint is measured to be at the trajectory's end",
        deadline_s=5.0,
        moves="body",
        on_success="the robot holds the end of the trajectory",
    )

    def start(self) -> MotionHandle | Failure:
        """Start, unless the world model has changed since the check."""
        step: CheckedStep = self.get_input("checked")
        if (stale := why_stale(step.name, step.world_version, self.toolbox.world.scene.version)) is not None:
            return stale
        self._step = step
        return self.toolbox.motion.start(step.checked)

    def finish(self) -> Status | Failure:
        """Wait for the joints to settle at the end."""
        duration_s = self._step.checked.trajectory.duration_s
        return arrival(self, self._step.checked, duration_s + self.toolbox.policy.motion_slack_s)

    @property
    def deadline_s(self) -> float:
        """The contract's deadline, longer by the motion's duration."""
        step: CheckedStep | None = self.optional("checked")
        return self.CONTRACT.deadline_s + (0.0 if step is None else step.checked.trajectory.duration_s)
