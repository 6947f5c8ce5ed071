"""Turn the head to where the object was put, leaning over where that is not enough."""

from __future__ import annotations

from collections.abc import Mapping

from kinematics.body_gaze import body_gaze, off_axis_rad
from kinematics.gaze import gaze_joints
from trees.leaves.look_at import LookAt, turning_joint
from trees.policy import Gaze
from trees.ports import ports
from trees.steps import Placement
from trees.toolbox import Toolbox

# Nearer to the middle of the picture than this share of half of it, a thing is in it with all that it is.
_WELL_IN_VIEW = 0.6


class LookAtPlacement(LookAt):
    """Bring the placement to the middle of the picture.

    What stands at the near edge of a table is below the picture of who stands upright: trunk and head look
    at it together then.
    """

    INPUT_PORTS = ports(placement=Placement)
    OUTPUT_PORTS = ports()

    def __init__(self, name: str, toolbox: Toolbox) -> None:
        super().__init__(name, toolbox, Gaze("placement", tilt_rad=0.0))

    def joints(self) -> Mapping[str, float]:
        """The goal of the head's joints, and of the trunk's if need be, rad."""
        place = self.get_input("placement").odom_T_object[:3, 3]
        model, q = self.toolbox.model, self.toolbox.motion.reference()
        camera = model.description.camera
        head = gaze_joints(model, q, place)
        looking = q.copy()
        for joint, angle in head.items():
            looking[7 + model.joint_index(joint)] = angle
        seen_rad = _WELL_IN_VIEW * 0.5 * min(camera.horizontal_fov_rad, camera.vertical_fov_rad)
        if off_axis_rad(model, looking, place) <= seen_rad:
            return head
        gaze = body_gaze(model, q, place, turning_joint(model.description), seen_rad)
        return head if gaze is None else gaze.joints
