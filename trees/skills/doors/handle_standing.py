"""Where to stand to open or close something, and the walk there; the numbers are from docs/notes/doors.md."""

from __future__ import annotations

from kinematics.geometry.planar import PlanarPose
from kinematics.scene.opening_path import DoorArc, DrawerLine
from trees.beliefs.openings.handles import HandleTarget
from trees.nodes.contract import Contract
from trees.nodes.ports import ports
from trees.skills.walking.walk_to import WalkTo

HINGE_AHEAD_M, HINGE_ASIDE_M, DOOR_TURNED_RAD = 0.80, 0.75, 0.15
"""The plane of a door's hinge ahead, the hinge to the side of the hand, and the door turned towards it."""
BAR_AHEAD_M, BAR_ASIDE_M = 0.66, 0.34
"""A drawer's bar, before the shoulder."""
NEAR_M, NEAR_RAD = 0.22, 0.25
"""A robot that stands so near to the place does not walk: the planner says whether the handle is in reach."""


def handle_standing_place(target: HandleTarget, body: PlanarPose) -> PlanarPose:
    """The pose of the body from which a handle's whole way is within reach.

    Args:
        target: The handle; its path is in the odometry frame.
        body: Where the body is now: a drawer is taken by the hand that is nearer then.

    Raises:
        TypeError: The path is that of nothing known.
    """
    path = target.path
    if isinstance(path, DoorArc):
        hinge = PlanarPose(float(path.hinge_m[0]), float(path.hinge_m[1]), path.closed_yaw_rad)
        seen = PlanarPose(HINGE_AHEAD_M, path.side * HINGE_ASIDE_M, path.side * DOOR_TURNED_RAD)
        return hinge @ seen.inverse()
    if isinstance(path, DrawerLine):
        bar = PlanarPose(float(path.closed_m[0]), float(path.closed_m[1]), path.yaw_rad)
        places = [bar @ PlanarPose(-BAR_AHEAD_M, side * BAR_ASIDE_M) for side in (-1.0, 1.0)]
        return min(places, key=body.distance_m)
    raise TypeError(f"nothing is known about {type(path).__name__}")


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
