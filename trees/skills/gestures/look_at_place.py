"""Look at something, and see that it is in the middle of the picture."""

from __future__ import annotations

import math

import numpy as np
from py_trees.common import Status

from kinematics.ik.body_gaze import body_gaze, pelvis_offset
from kinematics.requests.move import MoveRequest
from trees.beliefs.grounding.destination import Place
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE
from trees.nodes.planned_motion_leaf import PlannedMotionLeaf, move_from_here
from trees.nodes.ports import ports
from trees.skills.gestures.settings import GestureSettings
from trees.skills.looking.aiming_leaf import level_enough
from trees.skills.looking.look_at import turning_joint


class LookAtPlace(PlannedMotionLeaf):
    """Turn the head to what the task means; where that is not enough, turn trunk and pelvis as well."""

    INPUT_PORTS = ports(place=Place)
    OUTPUT_PORTS = ports(evidence=dict)
    CONTRACT = Contract(
        precondition="what is meant was seen",
        postcondition="from the encoders, it is in the middle of the picture to within the policy's share",
        deadline_s=30.0,
        moves="body",
        on_success="the head holds the gaze",
    )

    def goal(self) -> MoveRequest | Failure:
        """A motion of head and trunk alone, unless these do not get there."""
        toolbox, place = self.toolbox, self.get_input("place")
        reference = toolbox.motion.reference()
        turning = turning_joint(toolbox.model.description)
        gaze = body_gaze(toolbox.model, reference, place.aim_m, turning)
        if gaze is None:
            return Failure.infeasible(f"no posture looks at the {place.name} from here")
        joints = level_enough(toolbox, gaze.joints)
        if any(joints[name] != angle for name, angle in gaze.joints.items()):
            return Failure.infeasible(f"to look at the {place.name} would tilt what the hand holds")
        x, y, z = (float(value) for value in pelvis_offset(reference, gaze.pelvis_m))
        return move_from_here(toolbox, joints, keep_others=True, pelvis_m=(x, y, z), level=True)

    def step(self) -> Status | Failure:
        """Move, then measure how far from the picture's centre it is."""
        outcome = super().step()
        if outcome is not DONE:
            return outcome
        camera = self.toolbox.model.description.camera
        pose = self.toolbox.model.frame_pose(self.toolbox.sensing.state().q, camera.frame)
        x, y, z = pose[:3, :3].T @ (self.get_input("place").aim_m - pose[:3, 3])
        half = np.tan([0.5 * camera.horizontal_fov_rad, 0.5 * camera.vertical_fov_rad])
        off = math.inf if z <= 0.0 else float(np.max(np.abs(np.array([x, y]) / z) / half))
        self.measured(off_centre=off)
        if off > self.toolbox.policy.of(GestureSettings).centred:
            return Failure.postcondition(
                "it is beside the picture's centre",
                off_centre=off,
                tolerance=self.toolbox.policy.of(GestureSettings).centred,
            )
        self._set_output("evidence", {"off_centre": off})
        return DONE
