"""See where in the hand what it carries is by now."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from py_trees.common import Status

from kinematics.geometry import poses
from trees.beliefs.scene.held_object import HeldObject
from trees.beliefs.scene.recognition import nearest_sighting
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE
from trees.nodes.ports import ports
from trees.port_values import Target
from trees.skills.looking.look_leaf import LookLeaf, View, estimates_of
from trees.skills.place.settings import PlaceSettings


class SeeHeld(LookLeaf):
    """Look at the object in the hand, and correct its pose there when it has shifted.

    When it cannot be seen, it is taken to be where it was.
    """

    INPUT_PORTS = ports(held=HeldObject)
    OUTPUT_PORTS = ports(held_now=HeldObject, shifted=bool)
    CONTRACT = Contract(
        precondition="the object is an attached body, and the robot is at rest",
        postcondition="the attached body is where it was seen, or within the policy's tolerance of there, or "
        "was not seen; whether it was moved is written",
        deadline_s=2.0,
        on_success="the gripper goes on pressing",
        on_failure="the gripper goes on pressing",
        on_cancel="the gripper goes on pressing",
    )

    def step(self) -> Status | Failure:
        """Gather; who gets no pictures goes by what was believed."""
        if self.elapsed_s + self.toolbox.policy.lost_grip_s >= self.deadline_s:
            return self._unchanged("no pictures came")
        return super().step()

    def judge(self, views: list[View]) -> Status | Failure:
        """Compare with the attached body."""
        held: HeldObject = self.get_input("held")
        toolbox, policy = self.toolbox, self.toolbox.policy
        q = toolbox.sensing.state_at(views[-1].frame.stamp_s).q
        odom_T_tcp = toolbox.model.frame_pose(q, toolbox.model.description.tcp_frames[held.hand])
        expected = odom_T_tcp @ held.tcp_T_object
        like_it = Target(held.name, held.kind, held.color, held.shape, expected, 1.0)
        scene = toolbox.world.scene
        found = nearest_sighting(like_it, expected[:3, 3], estimates_of(views), scene, policy.same_object_m)
        if found is None or found[1] > policy.in_hand_tolerance_m:
            return self._unchanged("not seen")
        tcp_T_object = held.tcp_T_object.copy()
        tcp_T_object[:3, 3] = (poses.inverse(odom_T_tcp) @ found[0].odom_T_object)[:3, 3]
        tcp_T_object[1, 3] = held.tcp_T_object[1, 3]  # along the opening the fingers hold it where it is
        shift = odom_T_tcp[:3, :3] @ (tcp_T_object[:3, 3] - held.tcp_T_object[:3, 3])
        shift[2] = min(0.0, shift[2])  # nothing climbs in a hand; the sight errs
        tcp_T_object[:3, 3] = held.tcp_T_object[:3, 3] + odom_T_tcp[:3, :3].T @ shift
        shift_m = float(np.linalg.norm(shift))
        self.measured(shift_m=shift_m)
        if shift_m <= policy.of(PlaceSettings).shifted_m:
            return self._unchanged(f"{shift_m * 1000:.0f} mm from where it was")
        body = scene.attached[held.name]
        freed = scene.with_detached(held.name, expected)
        toolbox.world.update(
            freed.with_attached(held.name, body.frame, tcp_T_object, body.touch_links, body.mass_kg)
        )
        self._set_output("held_now", replace(held, tcp_T_object=tcp_T_object))
        self._set_output("shifted", True)
        self.feedback_message = f"it has shifted by {shift_m * 1000:.0f} mm"
        return DONE

    def _unchanged(self, why: str) -> Status:
        self._set_output("held_now", self.get_input("held"))
        self._set_output("shifted", False)
        self.feedback_message = why
        return DONE
