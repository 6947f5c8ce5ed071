"""Tell the world model that the hand holds the object."""

from __future__ import annotations

from dataclasses import replace

from py_trees.common import Status

from kinematics.geometry import poses
from kinematics.model.palm_grip import held, is_steep
from kinematics.requests.grasp import Grasp
from kinematics.scene.support_of import support_of
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE, Leaf
from trees.nodes.ports import ports
from trees.port_values import Step, Target
from trees.world_model import FormerPlace


class Attach(Leaf):
    """Attach the target to the hand in the planning scene.

    The lift is written once more, with the scene in which the hand holds the target, for the checker to judge
    it there.
    """

    INPUT_PORTS = ports(grasp=Grasp, target=Target, lift=Step)
    OUTPUT_PORTS = ports(held_lift=Step)
    CONTRACT = Contract(
        precondition="the hand was measured to hold the target",
        postcondition="the target is an attached body of the scene; the lift is to be checked with it",
        deadline_s=1.0,
    )

    def step(self) -> Status | Failure:
        """Attach at the pose that the object has in the measured hand."""
        grasp, target = self.get_input("grasp"), self.get_input("target")
        lift: Step = self.get_input("lift")
        gripper = self.toolbox.model.description.grippers[grasp.hand]
        world_T_tcp = self.toolbox.model.frame_pose(self.toolbox.sensing.state().q, gripper.tcp_frame)
        tcp_T_object = poses.inverse(world_T_tcp) @ target.odom_T_object
        # the closing fingers have centred along the opening what is between them
        tcp_T_object[1, 3] = grasp.off_centre_m
        tcp_T_object = held(gripper, tcp_T_object)
        world = self.toolbox.world
        before = world.scene.objects[target.name]
        support = support_of(before, world.scene, self.toolbox.policy.support_gap_m)
        if is_steep(gripper, world_T_tcp):
            world.leans |= {target.name}
        else:
            world.leans -= {target.name}
        world.update(
            world.scene.with_attached(target.name, gripper.tcp_frame, tcp_T_object, gripper.touch_links)
        )
        if support is not None:
            world.note_taken(target.name, FormerPlace(support.name, before.world_T_object))
        held_lift = replace(lift, scene=world.scene, world_version=world.scene.version)
        self._set_output("held_lift", held_lift)
        return DONE
