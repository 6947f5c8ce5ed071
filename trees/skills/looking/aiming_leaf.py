"""A leaf that turns the eyes somewhere."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from kinematics.requests.move import MoveRequest
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.planned_motion_leaf import PlannedMotionLeaf, move_from_here
from trees.toolbox import Toolbox

_TILT_RAD = 0.12
"""What is carried spills where it leans farther than 10 degrees; a walk takes 3 of them."""


class AimingLeaf(PlannedMotionLeaf):
    """Turn the eyes to a gaze; joints that do not aim the camera stay where they are."""

    CONTRACT = Contract(
        precondition="none",
        postcondition="the joints that aim the camera are at the gaze, and at rest",
        deadline_s=30.0,
        moves="body",
        on_success="the head holds the gaze",
    )

    def joints(self) -> Mapping[str, float]:
        """Goal positions of the joints that aim the camera, rad."""
        raise NotImplementedError

    def pelvis_m(self) -> tuple[float, float, float]:
        """How far the pelvis goes beside, in the world; joints that aim at a point are reckoned for none."""
        return (0.0, 0.0, 0.0)

    def goal(self) -> MoveRequest | Failure | None:
        """A motion of what aims alone, unless it looks there already."""
        toolbox = self.toolbox
        reference, joints = toolbox.motion.reference(), level_enough(toolbox, self.joints())
        if not joints:  # eyes that nothing aims
            return None
        index = 7 + toolbox.model.indices(tuple(joints))
        off = np.abs(reference[index] - list(joints.values()))
        pelvis_m = self.pelvis_m()
        if float(off.max()) <= toolbox.policy.gaze_tolerance_rad and not any(pelvis_m):
            return None
        return move_from_here(toolbox, joints, keep_others=True, pelvis_m=pelvis_m)


def level_enough(toolbox: Toolbox, joints: Mapping[str, float]) -> Mapping[str, float]:
    """The same, where a trunk that aims bends no farther than what a hand holds may tilt."""
    trunk = toolbox.model.description.camera.trunk
    if trunk is None or trunk.bow_joint not in joints or not toolbox.world.scene.attached:
        return joints
    return {**joints, trunk.bow_joint: min(max(joints[trunk.bow_joint], -_TILT_RAD), _TILT_RAD)}
