"""Draw the hand back from a handle: when the work there is done, or where a cancelled task left it."""

from __future__ import annotations

import numpy as np
from py_trees.behaviour import Behaviour
from py_trees.common import Status
from py_trees.composites import Sequence

from kinematics.model.palm_grip import way_to_bar
from kinematics.requests.grasp import Grasp
from kinematics.requests.move import RetreatRequest
from trees.beliefs.openings.drawer_inside import without_drawn
from trees.beliefs.openings.handles import HandleTarget
from trees.failures import Failure
from trees.leaves.release import Release
from trees.nodes.best_effort import BestEffort
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE
from trees.nodes.planned_motion_leaf import PlannedMotionLeaf
from trees.nodes.ports import optional, ports
from trees.skills.doors.handle.held_handle import hand_concessions, outwards, tcp_m
from trees.toolbox import Toolbox

_BACK_M = 0.10
_CLEAR_M = 0.12
_NEAR_M = 0.08
"""A hand whose TCP is nearer to the bar is about it; where a door was opened wide, the hand that has drawn
back is still beside the door."""
_BESIDE_M = 0.25
_STEADY_M = 0.075
"""Of the CoM inside the edge: nobody leans out to get away from a door."""
_BACK_SHARES, _CLEAR_SHARES = (1.0, 0.7), (1.0, 0.6, 0.35)
_PALM_SHARES, _PALM_TURNS_RAD = (1.0, 0.7, 0.5), (0.0, 0.3, -0.3)
"""A palm stands square to where it goes: what its wrist cannot follow straight it does turned."""
_CLEAR_TURNS_RAD = (0.0, 0.5, -0.5, 1.0, -1.0)
"""A hand that is clear of the bar may turn: a wrist at its limit would take the whole body along."""


class StepBack(PlannedMotionLeaf):
    """Move the open hand straight back along its own approach, until it is clear of the handle.

    When this task has not come to a handle, it is the hand that an earlier task left at one.
    """

    INPUT_PORTS = ports(handle=optional(HandleTarget), grasp=optional(Grasp))
    OUTPUT_PORTS = ports()
    CONTRACT = Contract(
        precondition="the gripper is open",
        postcondition="the hand is clear of the handle, at rest",
        deadline_s=20.0,
        moves="body",
        on_success="the hand is before the handle",
    )

    def __init__(self, name: str, toolbox: Toolbox, clear: bool = False) -> None:
        """Make the leaf.

        Args:
            name: Its name.
            toolbox: What it may call.
            clear: Away from the front itself, after the hand was drawn back from the bar.
        """
        super().__init__(name, toolbox)
        self._clear = clear

    def goal(self) -> RetreatRequest | None:
        """A straight line against the TCP's x axis; None where the hand is not about the handle."""
        toolbox, left = self.toolbox, self.toolbox.world.at_handle
        target: HandleTarget | None = self.optional("handle")
        grasp: Grasp | None = self.optional("grasp")
        if left is not None and (grasp is None or target is None):
            target, grasp = left.target, left.grasp
        if grasp is None or target is None or target.handle not in toolbox.world.scene.objects:
            return None
        if target.pushed and (self._clear or left is None):
            return None
        gripper = toolbox.model.description.grippers[grasp.hand]
        q = toolbox.motion.reference()
        bar_m = toolbox.world.scene.objects[target.handle].world_T_object[:3, 3]
        away_m = float(np.linalg.norm(tcp_m(toolbox, grasp, q) - bar_m))
        if away_m > (_BESIDE_M if self._clear else _NEAR_M) and not target.pushed:
            return None
        back = -_BACK_M * toolbox.model.frame_pose(q, gripper.tcp_frame)[:3, :3] @ way_to_bar(gripper)
        shares: tuple[float, ...] = _BACK_SHARES
        turns_rad: tuple[float, ...] = (0.0,)
        if self._clear or target.pushed:
            back = _CLEAR_M * outwards(toolbox.world.scene, target)
            shares, turns_rad = _CLEAR_SHARES, _CLEAR_TURNS_RAD
        elif gripper.palm_side_m is not None:
            shares, turns_rad = _PALM_SHARES, _PALM_TURNS_RAD
        x, y, z = (float(value) for value in back)
        return RetreatRequest(
            q_start=q,
            stance=toolbox.motion.stance(),
            scene=without_drawn(toolbox.world.scene),
            hand=grasp.hand,
            world_offset_m=(x, y, z),
            steady_m=_STEADY_M,
            concessions=hand_concessions(toolbox, target, grasp, "retreat"),
            shares=shares,
            turns_rad=turns_rad,
        )

    def step(self) -> Status | Failure:
        """Draw back; from then on no hand is at the handle."""
        outcome = super().step()
        if outcome is DONE and not self._clear:
            self.toolbox.world.at_handle = None
        return outcome


def leave_handle(toolbox: Toolbox) -> Behaviour:
    """Open the hand and draw it straight back; any other way would take the door along."""
    children = [Release("let go", toolbox), BestEffort(StepBack("draw back", toolbox))]
    return Sequence("leave the handle", memory=True, children=children)
