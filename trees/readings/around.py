"""What is around the robot, as everybody who asks for it is told."""

from __future__ import annotations

from kinematics.geometry.poses import Transform
from kinematics.scene.planning_scene import PlanningScene
from trees.beliefs.scene.believed_thing import Surroundings, surroundings
from trees.toolbox import Toolbox


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
