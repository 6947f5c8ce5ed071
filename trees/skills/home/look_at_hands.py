"""Look at where the hands are."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from kinematics.ik.gaze import gaze_joints
from trees.nodes.ports import ports
from trees.skills.looking.aiming_leaf import AimingLeaf


class LookAtHands(AimingLeaf):
    """Turn the head to between the hands, and move nothing else.

    What is around the trunk is not known yet, so it must not move.
    """

    INPUT_PORTS = ports()
    OUTPUT_PORTS = ports()

    def joints(self) -> Mapping[str, float]:
        """The head joints' goal, rad."""
        model, q = self.toolbox.model, self.toolbox.motion.reference()
        places = [model.frame_pose(q, frame)[:3, 3] for frame in model.description.tcp_frames.values()]
        return gaze_joints(model, q, np.mean(places, axis=0))
