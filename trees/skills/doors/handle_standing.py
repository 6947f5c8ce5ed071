"""Where to stand to open or close something, and the walk there."""

from __future__ import annotations

import math

from kinematics.geometry.planar import PlanarPose
from kinematics.model.handle_settings import Pushing
from kinematics.model.robot_description import RobotDescription
from kinematics.scene.opening_path import DoorArc, DrawerLine
from trees.beliefs.openings.handles import HandleTarget
from trees.nodes.contract import Contract
from trees.nodes.ports import ports
from trees.skills.walking.walk_to import WalkTo


def handle_standing_place(target: HandleTarget, body: PlanarPose, robot: RobotDescription) -> PlanarPose:
    """The pose of the body from which a handle's whole way is within reach.

    Args:
        target: The handle; its path is in the odometry frame.
        body: Where the body is now: a drawer is taken by the hand that is nearer then.
        robot: Says how it stands before such things.

    Raises:
        TypeError: The path is that of nothing known.
    """
    path, where, pushing = target.path, robot.handles, robot.pushing
    if target.pushed and pushing.before_m is not None:
        return _before_front(target, pushing, pushing.before_m)
    if isinstance(path, DoorArc):
        hinge = PlanarPose(float(path.hinge_m[0]), float(path.hinge_m[1]), path.closed_yaw_rad)
        aside_m = where.hinge_aside_m
        if where.upright_aside_m is not None:
            aside_m = where.upright_aside_m + path.radius_m
        seen = PlanarPose(where.hinge_ahead_m, path.side * aside_m, path.side * where.door_turned_rad)
        return hinge @ seen.inverse()
    if isinstance(path, DrawerLine):
        bar = PlanarPose(float(path.closed_m[0]), float(path.closed_m[1]), path.yaw_rad)
        places = [bar @ PlanarPose(-where.bar_ahead_m, side * where.bar_aside_m) for side in (-1.0, 1.0)]
        return min(places, key=body.distance_m)
    raise TypeError(f"nothing is known about {type(path).__name__}")


def _before_front(target: HandleTarget, pushing: Pushing, before_m: float) -> PlanarPose:
    """Square to what will be shut, before where the front is pushed as it is now."""
    path, opening = target.path, target.opening
    if isinstance(path, DoorArc):
        hinge = PlanarPose(float(path.hinge_m[0]), float(path.hinge_m[1]), path.closed_yaw_rad)
        out_m = pushing.places_m[0][0] * math.sin(opening)
        return hinge @ PlanarPose(-out_m - before_m, path.side * pushing.beyond_hinge_m)
    if isinstance(path, DrawerLine):
        front = PlanarPose(float(path.closed_m[0]), float(path.closed_m[1]), path.yaw_rad)
        return front @ PlanarPose(-opening - before_m)
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
        return handle_standing_place(self._target, body, self.toolbox.model.description)
