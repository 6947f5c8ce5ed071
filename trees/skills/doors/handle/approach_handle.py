"""Bring the open hand to a handle, and stop where it touches something."""

from __future__ import annotations

import math

from py_trees.common import Status

from kinematics.model.palm_grip import way_to_bar
from kinematics.requests.grasp import Grasp
from kinematics.scene.opening_path import DrawerLine
from robots.control.hands.yield_order import YieldOrder
from robots.control.hands.yield_settings import YieldReport
from robots.control.motion_handle import MotionHandle
from trees.beliefs.openings.handles import HandleTarget
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE
from trees.nodes.ports import ports
from trees.nodes.yielding_leaf import YieldingLeaf
from trees.skills.doors.handle.held_handle import outwards, scene_of_hand
from trees.world_model import HandAtHandle


class ApproachHandle(YieldingLeaf):
    """Move the open hand straight on until the bar is between the fingers, or they touch what is behind it.

    How far a handle stands off is seen only to some centimetres, and behind it there is little more room than
    fingers need. So the path is checked beforehand, and on the way the hand gives way and stops where it
    touches something.
    """

    INPUT_PORTS = ports(handle=HandleTarget, grasp=Grasp)
    OUTPUT_PORTS = ports(approached=YieldReport)
    CONTRACT = Contract(
        precondition="the open hand is before the handle, at the beginning of the checked approach",
        postcondition="the hand is where the approach ends, or was stopped on the way by a gentle contact",
        deadline_s=20.0,
        moves="body",
        on_success="the open hand is about the bar, unless it was seen at a wrong place",
    )

    def start(self) -> MotionHandle | Failure:
        """Go on along the hand's own direction."""
        toolbox = self.toolbox
        target: HandleTarget = self.get_input("handle")
        grasp: Grasp = self.get_input("grasp")
        q = toolbox.motion.reference()
        gripper = toolbox.model.description.grippers[grasp.hand]
        here = toolbox.model.frame_pose(q, gripper.tcp_frame)
        own = here[:3, :3] @ way_to_bar(gripper)
        ahead = -outwards(toolbox.world.scene, target) if target.pushed else own
        left_m = float((grasp.world_T_tcp[:3, 3] - here[:3, 3]) @ ahead)
        if left_m <= 0.0:
            return Failure.execution("the hand is beyond the handle already", left_m=left_m)
        line = DrawerLine(here[:3, 3] + left_m * ahead, math.atan2(float(ahead[1]), float(ahead[0])))
        toolbox.world.at_handle = HandAtHandle(target, grasp)
        return self.lead(
            YieldOrder(
                grasp.hand,
                scene_of_hand(toolbox, target, grasp),
                (),
                line,
                left_m,
                0.0,
                stop_from=left_m,
                holding=False,
                manner="gentle",
            )
        )

    def finish(self) -> Status | Failure:
        """Tell what was felt."""
        report = self.led.report
        self._set_output("approached", report)
        self.measured(short_by_m=round(report.s, 4), peak_push_n=round(report.peak_pull_n, 1))
        self.feedback_message = f"{report.s * 1000:.0f} mm short, {report.peak_pull_n:.0f} N"
        return DONE
