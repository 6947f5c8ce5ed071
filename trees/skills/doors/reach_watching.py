"""Reach for a door or drawer, and stop when it moves before the hand is there."""

from __future__ import annotations

from py_trees.common import Status

from trees.beliefs.openings.handles import HandleTarget
from trees.failures import Failure
from trees.leaves.stream_motion import StreamMotion
from trees.nodes.contract import Contract
from trees.nodes.leaf import RUNNING
from trees.nodes.ports import ports
from trees.port_values import CheckedStep
from trees.skills.doors.front_watch import MOVED_M, FrontWatch


class ReachWatching(StreamMotion):
    """Stream the reach to a door or drawer, and stop when it is seen to move.

    A door that swings meanwhile would be met at full speed.
    """

    INPUT_PORTS = ports(checked=CheckedStep, handle=HandleTarget)
    OUTPUT_PORTS = ports()
    CONTRACT = Contract(
        precondition="the step was checked for the present scene and starts at the reference",
        postcondition="every joint is measured to be at the trajectory's end; as far as it was in view, the "
        "front stayed where it was",
        deadline_s=5.0,
        moves="body",
        on_success="the robot holds the end of the trajectory",
    )

    def begin(self) -> None:
        """Watch anew."""
        super().begin()
        self._watch = FrontWatch(self.toolbox, self.get_input("handle"))

    def step(self) -> Status | Failure:
        """Follow the motion, and look."""
        outcome = super().step()
        moved_m = self._watch.moved_m()
        if outcome is RUNNING and moved_m is not None:
            target: HandleTarget = self.get_input("handle")
            return Failure.postcondition(
                f"the {target.part} moved while the hand was on its way to it",
                moved_m=moved_m,
                tolerance_m=MOVED_M,
            )
        return outcome
