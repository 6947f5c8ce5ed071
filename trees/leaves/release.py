"""Open the hand after a failed attempt, unless something would fall."""

from __future__ import annotations

from collections.abc import Mapping

from py_trees.common import Status

from kinematics.requests.grasp import Grasp
from robots.control.motion_handle import MotionHandle
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE
from trees.nodes.motion_leaf import MotionLeaf
from trees.nodes.ports import optional, ports
from trees.toolbox import Toolbox

# An object let go nearer than this to where it stood still stands.
_SAFE_DROP_M = 0.015
_LETS_GO_M = 0.02
"""So much wider than they are about a bar, however they hold it, fingers are that have let go of it."""


class Release(MotionLeaf):
    """Open the hand of the last grasp, and take what it held out of the planning scene.

    When this task has not grasped anything, it opens the hand that an earlier task left at a handle. A hand
    that still holds something in the air is not opened, since that would fall: the leaf fails and says so.
    """

    INPUT_PORTS = ports(grasp=optional(Grasp))
    OUTPUT_PORTS = ports()
    CONTRACT = Contract(
        precondition="none",
        postcondition="the hand is open and nothing is attached to it",
        deadline_s=4.0,
        moves="gripper",
        on_success="the gripper is open",
        on_failure="the gripper keeps what it holds",
        on_cancel="the gripper holds its present opening",
    )

    def __init__(
        self, name: str, toolbox: Toolbox, wiring: Mapping[str, str] | None = None, *, at_bar: bool = False
    ) -> None:
        """Make the leaf.

        Args:
            name: Its name.
            toolbox: What it may call.
            wiring: Other names of its ports.
            at_bar: Whether fingers are about a bar that has something beside it: they only let go of it.
        """
        super().__init__(name, toolbox, wiring)
        self._at_bar = at_bar

    def start(self) -> MotionHandle | Failure | None:
        """Open, keep, or do nothing when no hand was used yet."""
        grasp = self._grasp()
        if grasp is None:
            return None
        gripper, attached = self.toolbox.grippers[grasp.hand], self._attached(grasp)
        if attached and gripper.reading().holding and self._height_m(grasp) > _SAFE_DROP_M:
            return Failure.postcondition(
                f"the {grasp.hand} hand still holds the {attached[0]} in the air; it is kept",
                opening_m=gripper.reading().opening_m,
            )
        opening_m = grasp.opening_m
        if opening_m is not None and self._at_bar:
            opening_m = max(grasp.diameter_m, gripper.reading().opening_m) + _LETS_GO_M
        return gripper.open(opening_m)

    def finish(self) -> Status | Failure:
        """What was attached is no longer: the next look says where it is."""
        world, grasp = self.toolbox.world, self._grasp()
        for name in [] if grasp is None else self._attached(grasp):
            body = world.scene.attached[name]
            scene = world.scene.with_detached(name, body.body.world_T_object)
            world.update(scene.without_object(name))
        return DONE

    def _grasp(self) -> Grasp | None:
        left = self.toolbox.world.at_handle
        grasp: Grasp | None = self.optional("grasp")
        return left.grasp if grasp is None and left is not None else grasp

    def _attached(self, grasp: Grasp) -> list[str]:
        frame = self.toolbox.model.description.grippers[grasp.hand].tcp_frame
        return [name for name, body in self.toolbox.world.scene.attached.items() if body.frame == frame]

    def _height_m(self, grasp: Grasp) -> float:
        frame = self.toolbox.model.description.grippers[grasp.hand].tcp_frame
        tcp = self.toolbox.model.frame_pose(self.toolbox.motion.reference(), frame)
        return float(tcp[2, 3] - grasp.world_T_tcp[2, 3])
