"""A leaf that turns the eyes somewhere."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from kinematics.arrays import Array
from kinematics.ik.body_gaze import pelvis_offset, with_joints
from kinematics.ik.held_upright import arm_that_goes_along
from kinematics.model.standing_robot import StandingRobot
from kinematics.requests.move import MoveRequest
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.planned_motion_leaf import PlannedMotionLeaf, move_from_here
from trees.readings.held import held_objects
from trees.toolbox import Toolbox

UNNOTICED_M = 0.02
"""A pelvis that is nearer than this to where it belongs is left where it is."""
_TILT_RAD = 0.12
"""What is carried spills where it leans farther than 10 degrees; a walk takes 3 of them."""


class AimingLeaf(PlannedMotionLeaf):
    """Turn the eyes to a gaze; other joints stay, but for those of arms that keep what they hold level."""

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

    def pelvis_m(self, joints: Mapping[str, float]) -> Array:
        """How far the pelvis goes beside, in the world, shape (3,), while those joints go there.

        Joints that aim at a point are reckoned for none.
        """
        ahead_m = counterpoise_m(self.toolbox, joints)
        return np.zeros(3) if ahead_m is None else ahead_m

    def goal(self) -> MoveRequest | Failure | None:
        """A motion of what aims alone, unless it looks there already."""
        toolbox = self.toolbox
        reference, joints = toolbox.motion.reference(), level_enough(toolbox, self.joints())
        if not joints:  # eyes that nothing aims
            return None
        index = 7 + toolbox.model.indices(tuple(joints))
        off = np.abs(reference[index] - list(joints.values()))
        x, y, z = (float(value) for value in self.pelvis_m(joints))
        if float(off.max()) <= toolbox.policy.gaze_tolerance_rad and not any((x, y, z)):
            return None
        return move_from_here(toolbox, joints, keep_others=True, pelvis_m=(x, y, z), level=True)


def counterpoise_m(toolbox: Toolbox, joints: Mapping[str, float]) -> Array | None:
    """How far the pelvis goes ahead while a trunk that aims bends back, so that the CoM stays over the soles.

    Returns:
        A way in the world, shape (3,); None where no trunk bends back.
    """
    model, q = toolbox.model, toolbox.motion.reference()
    trunk = model.description.camera.trunk
    if trunk is None or joints.get(trunk.bow_joint, 0.0) >= 0.0:
        return None
    home = StandingRobot.of(model, toolbox.motion.stance()).q_home
    ahead = pelvis_offset(home, (1.0, 0.0, 0.0))
    short_m = float(ahead @ (model.com(home) - model.com(with_joints(q, model, joints))))
    return short_m * ahead if short_m > UNNOTICED_M else np.zeros(3)


def level_enough(toolbox: Toolbox, joints: Mapping[str, float]) -> Mapping[str, float]:
    """The same, with what hands hold upright: their arms go along with a trunk that aims.

    Where an arm cannot, the trunk bends no farther from where it is than what is held may tilt.
    """
    trunk = toolbox.model.description.camera.trunk
    if trunk is None or trunk.bow_joint not in joints:
        return joints
    model, q = toolbox.model, toolbox.motion.reference()
    along: dict[str, float] = {}
    for one in held_objects(toolbox):
        arm = arm_that_goes_along(model, q, joints, one.hand, one.tcp_T_object)
        if arm is None:
            bow_rad = float(q[7 + model.joint_index(trunk.bow_joint)])
            bent = min(max(joints[trunk.bow_joint], bow_rad - _TILT_RAD), bow_rad + _TILT_RAD)
            return {**joints, trunk.bow_joint: bent}
        along |= arm
    return {**joints, **along}
