"""Turn the head to where the object was put."""

from __future__ import annotations

from collections.abc import Mapping

from kinematics.gaze import gaze_joints
from trees.leaves.look_at import LookAt
from trees.policy import Gaze
from trees.ports import ports
from trees.steps import Placement
from trees.toolbox import Toolbox


class LookAtPlacement(LookAt):
    """Bring the placement to the middle of the picture."""

    INPUT_PORTS = ports(placement=Placement)
    OUTPUT_PORTS = ports()

    def __init__(self, name: str, toolbox: Toolbox) -> None:
        super().__init__(name, toolbox, Gaze("placement", tilt_rad=0.0))

    def joints(self) -> Mapping[str, float]:
        """The head joints' goal, rad."""
        place = self.get_input("placement").odom_T_object[:3, 3]
        return gaze_joints(self.toolbox.model, self.toolbox.motion.reference(), place)
