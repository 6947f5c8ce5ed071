"""Whether the robot stands where a handle's whole way is within reach."""

from __future__ import annotations

import math

from py_trees.common import Status

from trees.beliefs.openings.handles import HandleTarget
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE, Leaf
from trees.nodes.ports import ports
from trees.readings.odometry import feet_pose
from trees.skills.doors.handle_standing import handle_standing_place


class StandsAtHandle(Leaf):
    """Compare where the robot stands with the place from which the handle can be moved.

    A robot that cannot walk succeeds wherever it stands.
    """

    INPUT_PORTS = ports(handle=HandleTarget)
    OUTPUT_PORTS = ports()
    CONTRACT = Contract(
        precondition="the handle was seen from where the robot stands",
        postcondition="the robot stands near the place that suits the handle, or cannot walk",
        deadline_s=1.0,
    )

    def step(self) -> Status | Failure:
        """Measure once."""
        toolbox, handle = self.toolbox, self.get_input("handle")
        if toolbox.walking is None or toolbox.model.description.walking is None:
            return DONE
        body = feet_pose(toolbox)
        left = body.to(handle_standing_place(handle, body, toolbox.model.description))
        where = toolbox.model.description.handles
        off_m, off_rad = math.hypot(left.x_m, left.y_m), abs(left.yaw_rad)
        self.measured(off_m=off_m, off_rad=off_rad)
        if off_m > where.near_m or off_rad > where.near_rad:
            return Failure.postcondition(
                f"it stands {off_m:.2f} m and {math.degrees(off_rad):.0f} degrees beside the place for that",
                off_m=off_m,
                off_rad=off_rad,
            )
        return DONE


class StandsThereAlready(StandsAtHandle):
    """As ``StandsAtHandle``, before a walk: that the robot stands elsewhere is an answer, not a failure."""

    ASKS = True
