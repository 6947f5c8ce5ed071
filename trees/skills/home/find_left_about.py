"""Find what a hand was left about by whoever commanded the robot before."""

from __future__ import annotations

from py_trees.common import Status

from kinematics.scene.support_of import support_of
from trees.beliefs.scene.held_object import HeldObject
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE, Leaf
from trees.nodes.ports import ports
from trees.skills.home.hand_about import objects_in_open_grasp

_STANDS_WITHIN_M = 0.01
"""Above what carries it: higher, and the hand has lifted it."""


class FindLeftAbout(Leaf):
    """Find an object that stands on something with the fingers of a hand around it.

    A program that takes over a robot does not know what its hands hold. A hand whose object stands can be
    opened, for nothing falls. One whose object is in the air stays closed.
    """

    INPUT_PORTS = ports()
    OUTPUT_PORTS = ports(held=HeldObject, touched=bool)
    CONTRACT = Contract(
        precondition="what is about the hands was looked at",
        postcondition="an object stands on something, and a hand is about it",
        deadline_s=1.0,
    )

    def step(self) -> Status | Failure:
        """Look through the hands."""
        scene = self.toolbox.world.scene
        for about in objects_in_open_grasp(self.toolbox):
            if support_of(scene.objects[about.name], scene, _STANDS_WITHIN_M) is not None:
                self._set_output("held", about)
                self._set_output("touched", True)
                self.feedback_message = f"the {about.hand} hand is about the {about.name}"
                return DONE
        return Failure.postcondition("no hand is about anything that stands")
