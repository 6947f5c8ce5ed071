"""Find out which places that hands are to pass over no look has shown."""

from __future__ import annotations

from py_trees.common import Status

from kinematics.requests.grasp import Grasp
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE, Leaf
from trees.nodes.ports import ports
from trees.port_values import Step, Target
from trees.skills.looking.hand_ways import UnseenPlaces, unseen_below, unseen_on_way


class FindUnseen(Leaf):
    """Find the places on tops that any moving hand will pass over and that no look has shown."""

    INPUT_PORTS = ports(reach=Step)
    OUTPUT_PORTS = ports(unseen=UnseenPlaces)
    CONTRACT = Contract(
        precondition="the way was planned for the present scene",
        postcondition="the places are told; none when all was looked at",
        deadline_s=1.0,
    )

    def places(self) -> UnseenPlaces:
        """The places."""
        return unseen_below(self.toolbox, self.get_input("reach").trajectory)

    def step(self) -> Status:
        """Reckon once."""
        self._set_output("unseen", self.places())
        return DONE


class FindUnseenOnWay(FindUnseen):
    """The same, for the hand that grasps alone, and on the furniture that its target stands on."""

    INPUT_PORTS = ports(target=Target, grasp=Grasp, reach=Step)

    def places(self) -> UnseenPlaces:
        """The places."""
        target, hand = self.get_input("target"), self.get_input("grasp").hand
        return unseen_on_way(self.toolbox, target, self.get_input("reach"), hand)
