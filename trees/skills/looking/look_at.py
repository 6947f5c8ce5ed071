"""Turn the head."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from kinematics.arrays import Array
from kinematics.ik.body_gaze import body_gaze, off_axis_rad, pelvis_offset, with_joints
from kinematics.ik.gaze import gaze_joints
from kinematics.model.robot_description import RobotDescription
from kinematics.model.standing_robot import StandingRobot
from kinematics.requests.move import MoveRequest
from trees.beliefs.sight.sight import middle_of_most
from trees.failures import Failure
from trees.nodes.ports import ports
from trees.policy import Gaze
from trees.port_values import Target
from trees.skills.looking.aiming_leaf import UNNOTICED_M, AimingLeaf, counterpoise_m
from trees.skills.looking.hand_ways import UnseenPlaces
from trees.toolbox import Toolbox

_WELL_IN_VIEW = 0.6
"""Nearer to the middle of the picture than this share of half of it, a thing is in it with all that it is."""


class LookAt(AimingLeaf):
    """Turn the head to a gaze; if the gaze says so, the trunk leans or turns and the pelvis draws back."""

    INPUT_PORTS = ports()
    OUTPUT_PORTS = ports()

    def __init__(self, name: str, toolbox: Toolbox, gaze: Gaze) -> None:
        super().__init__(name, toolbox)
        self.gaze = gaze

    def joints(self) -> Mapping[str, float]:
        """The gaze's, inside their limits, rad."""
        return joints_of(self.gaze, self.toolbox.model.description)

    def pelvis_m(self, joints: Mapping[str, float]) -> Array:
        """To where the gaze has it; it does not stay behind without a lean, nor ahead once a trunk is up."""
        model, motion = self.toolbox.model, self.toolbox.motion
        if model.description.welded:
            return np.zeros(3)
        ahead_m = counterpoise_m(self.toolbox, joints)
        if ahead_m is not None:
            return ahead_m
        home, now = StandingRobot.of(model, motion.stance()).q_home, motion.reference()
        ahead = pelvis_offset(home, (1.0, 0.0, 0.0))
        behind_m = float(ahead @ (home[:3] - now[:3]))
        trunk_aims = model.description.camera.trunk is not None
        if not self.gaze.back_m and (abs(behind_m) if trunk_aims else behind_m) <= UNNOTICED_M:
            return np.zeros(3)
        return (behind_m - self.gaze.back_m) * ahead


def joints_of(gaze: Gaze, description: RobotDescription) -> Mapping[str, float]:
    """Positions of the joints that aim the camera, inside their limits, rad."""
    camera, margin = description.camera, description.planning_margin_rad
    wanted = camera.aimed(gaze.pan_rad, gaze.tilt_rad, gaze.lean_rad)
    turning = turning_joint(description)
    if turning is not None:
        wanted[turning] = wanted.get(turning, 0.0) + gaze.turn_rad
    inside = {}
    for joint, angle in wanted.items():
        lower, upper = description.limits[joint].position
        inside[joint] = min(max(angle, lower + margin), upper - margin)
    return inside


def turning_joint(description: RobotDescription) -> str | None:
    """The joint that turns the trunk: the first of the trunk that does not lean it, or None."""
    torso, lean = description.groups.get("torso", ()), description.camera.lean_joint
    return next((joint for joint in torso if joint != lean), None)


def joints_that_show(toolbox: Toolbox, point: Array, clear_m: float = 0.0) -> Mapping[str, float]:
    """How the head looks at a point in odom, shape (3,), with the trunk where it takes that, rad.

    Args:
        toolbox: Knows the robot.
        point: The point.
        clear_m: How far above it there is something to be seen. The trunk leans over nothing that would then
            be nearer than the camera tells depths of.
    """
    model, q = toolbox.model, toolbox.motion.reference()
    camera = model.description.camera
    head = gaze_joints(model, q, point)
    seen_rad = _WELL_IN_VIEW * 0.5 * min(camera.horizontal_fov_rad, camera.vertical_fov_rad)
    if off_axis_rad(model, with_joints(q, model, head), point) <= seen_rad:
        return head
    gaze = body_gaze(model, q, point, turning_joint(model.description), seen_rad)
    if gaze is None:
        return head
    eye = model.frame_pose(with_joints(q, model, gaze.joints), camera.frame)
    depth_m = float(eye[:3, 2] @ (point + clear_m * np.array([0.0, 0.0, 1.0]) - eye[:3, 3]))
    return head if clear_m > 0.0 and depth_m < camera.range_m[0] else gaze.joints


class LookAtTarget(AimingLeaf):
    """Turn the head so that the target is in the middle of the picture, where it was seen or in the hand.

    Attributes:
        leaning: Whether the trunk leans over where the head alone does not show what is not in a hand.
    """

    INPUT_PORTS = ports(target=Target)
    OUTPUT_PORTS = ports()

    def __init__(self, name: str, toolbox: Toolbox, leaning: bool = False) -> None:
        super().__init__(name, toolbox)
        self.leaning = leaning

    def joints(self) -> Mapping[str, float]:
        """The goal of the joints that aim the camera, rad."""
        target: Target = self.get_input("target")
        model, q = self.toolbox.model, self.toolbox.motion.reference()
        body = self.toolbox.world.scene.attached.get(target.name)
        if body is None and self.leaning:
            half_m = 0.5 * target.shape.height_m
            return joints_that_show(self.toolbox, target.odom_T_object[:3, 3], half_m)
        if body is None:
            return gaze_joints(model, q, target.odom_T_object[:3, 3])
        return gaze_joints(model, q, (model.frame_pose(q, body.frame) @ body.frame_T_object)[:3, 3])


class LookAtUnseen(AimingLeaf):
    """Look at places that a hand is to pass over and nobody has seen, leaning over where it must."""

    INPUT_PORTS = ports(unseen=UnseenPlaces)
    OUTPUT_PORTS = ports()

    def goal(self) -> MoveRequest | Failure | None:
        """None where all was looked at."""
        return super().goal() if len(self.get_input("unseen").points) else None

    def joints(self) -> Mapping[str, float]:
        """The goal of the joints that aim the camera, rad: where one picture shows most of those places."""
        model, points = self.toolbox.model, self.get_input("unseen").points
        camera = model.description.camera
        eye = model.frame_pose(self.toolbox.motion.reference(), camera.frame)[:3, 3]
        seen_rad = 0.5 * min(camera.horizontal_fov_rad, camera.vertical_fov_rad)
        return joints_that_show(self.toolbox, middle_of_most(points, eye, seen_rad))
