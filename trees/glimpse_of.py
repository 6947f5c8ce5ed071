"""A picture as a look: from where, and past which parts of the robot, for they hide things."""

from __future__ import annotations

from kinematics.pointing import elbow_frame
from kinematics.robot_description import HANDS
from trees.look_leaf import View
from trees.sight import Glimpse
from trees.toolbox import Toolbox


def glimpse_of(toolbox: Toolbox, view: View) -> Glimpse:
    """What a picture shows, with hands, forearms and held things in the way where they were then."""
    model = toolbox.model
    q = toolbox.sensing.state_at(view.frame.stamp_s).q
    parts = []
    for hand in HANDS:
        elbow, tcp = model.frame_poses(q, [elbow_frame(model, hand), model.description.tcp_frames[hand]])
        parts += [tcp[:3, 3], 0.5 * (elbow[:3, 3] + tcp[:3, 3])]
    held = toolbox.world.scene.attached.values()
    parts += [(model.frame_pose(q, body.frame) @ body.frame_T_object)[:3, 3] for body in held]
    return Glimpse(view.odom_T_camera, tuple(parts))
