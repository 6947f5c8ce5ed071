"""Turn the head to a handle."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from kinematics.ik.gaze import gaze_joints
from robots.scenes.articulated import DOOR, DRAWER, HANDLE
from trees.beliefs.openings.handles import HandleTarget
from trees.nodes.ports import optional, ports
from trees.policy import Gaze
from trees.skills.looking.aiming_leaf import AimingLeaf
from trees.skills.looking.look_at import joints_of
from trees.toolbox import Toolbox

_AHEAD = Gaze("ahead", tilt_rad=0.6)
_BETWEEN = 0.5
"""Of the way from the handle to the middle of what it opens: both are to be seen."""


class LookAtHandle(AimingLeaf):
    """Turn the head so that a handle, and the door or drawer behind it, should be in the picture."""

    INPUT_PORTS = ports(handle=optional(HandleTarget))
    OUTPUT_PORTS = ports()

    def __init__(self, name: str, toolbox: Toolbox, between: float = _BETWEEN) -> None:
        """Make the leaf.

        Args:
            name: Its name.
            toolbox: What it may call.
            between: How far from the handle towards the middle of what it opens to look.
        """
        super().__init__(name, toolbox)
        self._between = between

    def joints(self) -> Mapping[str, float]:
        """The head joints' goal, rad; straight ahead when no handle is known at all."""
        target: HandleTarget | None = self.optional("handle")
        objects, model = self.toolbox.world.scene.objects, self.toolbox.model
        handle = HANDLE if target is None else target.handle
        if handle in objects:
            place = objects[handle].world_T_object[:3, 3]
        elif target is not None:
            place = target.path.at(target.opening).position_m
        else:
            return joints_of(_AHEAD, model.description)
        fronts = [name for name in (DOOR, DRAWER) if name in objects] if target is None else [target.part]
        if fronts and fronts[0] in objects:
            middle = objects[fronts[0]].world_T_object[:3, 3].copy()
            middle[2] = place[2]
            place = place + self._between * (middle - place)
        q = self.toolbox.motion.reference()
        found = dict(gaze_joints(model, q, place))
        camera, margin = model.description.camera, model.description.planning_margin_rad
        for joint in camera.neck or ():
            lower, upper = model.description.limits[joint].position
            if joint in found:
                found[joint] = float(np.clip(found[joint], lower + margin, upper - margin))
        return found
