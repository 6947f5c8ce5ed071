"""Turn the head."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from kinematics.gaze import gaze_joints
from kinematics.requests import MoveRequest
from trees.contract import Contract
from trees.planned_motion_leaf import PlannedMotionLeaf
from trees.ports import ports
from trees.steps import Target
from trees.toolbox import Toolbox


class LookAt(PlannedMotionLeaf):
    """Turn the head to a gaze; everything else stays where it is."""

    INPUT_PORTS = ports()
    OUTPUT_PORTS = ports()
    CONTRACT = Contract(
        precondition="none",
        postcondition="tilt and pan joint are at the gaze, and at rest",
        deadline_s=30.0,
        moves="body",
        on_success="the head holds the gaze",
    )

    def __init__(self, name: str, toolbox: Toolbox, gaze_rad: tuple[float, float]) -> None:
        super().__init__(name, toolbox)
        self._tilt_rad, self._pan_rad = gaze_rad

    def gaze(self) -> Mapping[str, float]:
        """The head joints' goal, rad, inside their limits."""
        model = self.toolbox.model
        camera, margin = model.description.camera, model.description.planning_margin_rad
        wanted = {camera.tilt_joint: self._tilt_rad, camera.pan_joint: self._pan_rad}
        return {
            joint: float(
                np.clip(
                    angle,
                    model.description.limits[joint].position[0] + margin,
                    model.description.limits[joint].position[1] - margin,
                )
            )
            for joint, angle in wanted.items()
        }

    def goal(self) -> MoveRequest | None:
        """A motion of the head alone, unless it looks there already."""
        toolbox = self.toolbox
        reference, gaze = toolbox.motion.reference(), self.gaze()
        off = [abs(reference[7 + toolbox.model.joint_index(joint)] - angle) for joint, angle in gaze.items()]
        if max(off) <= toolbox.policy.gaze_tolerance_rad:
            return None
        return MoveRequest(
            q_start=reference,
            stance=toolbox.motion.stance(),
            scene=toolbox.world.scene,
            joints=gaze,
            keep_others=True,
            seed=int(toolbox.rng.integers(2**31)),
        )


class LookAtTarget(LookAt):
    """Turn the head so that the target is in the middle of the picture, in the hand or where it was seen."""

    INPUT_PORTS = ports(target=Target)
    OUTPUT_PORTS = ports()

    def __init__(self, name: str, toolbox: Toolbox) -> None:
        super().__init__(name, toolbox, (0.0, 0.0))

    def gaze(self) -> Mapping[str, float]:
        """The head joints' goal, rad."""
        target: Target = self.get_input("target")
        model, q = self.toolbox.model, self.toolbox.motion.reference()
        body = self.toolbox.world.scene.attached.get(target.name)
        if body is None:
            return gaze_joints(model, q, target.odom_T_object[:3, 3])
        return gaze_joints(model, q, (model.frame_pose(q, body.frame) @ body.frame_T_object)[:3, 3])
