"""Walk to where a door or drawer can be opened."""

from __future__ import annotations

from kinematics.geometry.planar import PlanarPose
from trees.beliefs.openings.handles import HandleTarget
from trees.nodes.contract import Contract
from trees.nodes.ports import ports
from trees.skills.doors.handle_standing import handle_standing_place
from trees.skills.walking.walk_to import WalkTo


class WalkToHandle(WalkTo):
    """Walk to the place from which a door or drawer can be opened or closed."""

    INPUT_PORTS = ports(handle=HandleTarget)
    OUTPUT_PORTS = ports(goal=PlanarPose)
    CONTRACT = Contract(
        precondition="the handle was seen, and the robot stands upright with its hands at home",
        postcondition="the robot stands; by odometry within the policy's tolerance of its goal",
        deadline_s=120.0,
        moves="body",
        on_success="the robot stands in front of what is to be opened",
        on_failure="the robot stops within two steps and stands",
        on_cancel="the robot stops within two steps and stands",
    )

    def aim(self) -> None:
        """The handle, as it was seen last."""
        self._target: HandleTarget = self.get_input("handle")
        self._straight_m = 0.3

    def place(self, body: PlanarPose) -> PlanarPose:
        """Where the hinge, or the bar, is where the hand wants it."""
        return handle_standing_place(self._target, body)
