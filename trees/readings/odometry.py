"""Where the robot is by its odometry, and what is believed to be around it from there."""

from __future__ import annotations

import math

from kinematics.geometry.planar import PlanarPose
from kinematics.geometry.poses import Transform
from kinematics.scene.planning_scene import PlanningScene
from trees.beliefs.grounding.destination import Place
from trees.beliefs.scene.believed_thing import Surroundings, surroundings
from trees.toolbox import Toolbox


def body_pose(toolbox: Toolbox) -> PlanarPose:
    """Where the base is believed to be in the odometry frame, and where it heads."""
    x, y, _, qx, qy, qz, qw = toolbox.sensing.state().q[:7].tolist()
    heading = math.atan2(2.0 * (qw * qz + qx * qy), 1.0 - 2.0 * (qy * qy + qz * qz))
    return PlanarPose(x, y, heading)


def feet_pose(toolbox: Toolbox) -> PlanarPose:
    """The middle between the feet that the robot stands on, and where they point; a mount without feet."""
    if toolbox.model.description.welded:
        return body_pose(toolbox)
    soles = [PlanarPose.of(pose) for _, pose in toolbox.motion.stance().soles]
    return PlanarPose.between(soles[0], soles[-1])


def bearing_rad(toolbox: Toolbox, place: Place) -> float:
    """Where a place is from where the feet point, to the left, in (-pi, pi]."""
    x_m, y_m = place.odom_T_place[:2, 3].tolist()
    there = feet_pose(toolbox).to(PlanarPose(x_m, y_m))
    return math.atan2(there.y_m, there.x_m)


def what_is_around(toolbox: Toolbox, scene: PlanningScene | None = None) -> Surroundings:
    """What is believed, from where the robot stands, with what "the other one" is other than.

    Words are grounded in this alone: two that ask at the same moment mean the same by "the other table".

    Args:
        toolbox: Knows the world model, and where the robot is.
        scene: What is believed, where that is another scene than the world model's.
    """
    world = toolbox.world
    return surroundings(
        world.scene if scene is None else scene,
        base_pose(toolbox),
        toolbox.policy.support_gap_m,
        world.last_acted_on,
        world.asked_at,
        world.sent_to,
    )


def base_pose(toolbox: Toolbox) -> Transform:
    """Pose of the robot's base in the odometry frame, shape (4, 4)."""
    model = toolbox.model
    return model.frame_pose(toolbox.sensing.state().q, model.description.base_link)


def away_m(toolbox: Toolbox, place: Place) -> float:
    """How far the middle of a place is from the body, along the floor."""
    x_m, y_m = place.odom_T_place[:2, 3].tolist()
    return body_pose(toolbox).distance_m(PlanarPose(x_m, y_m))
