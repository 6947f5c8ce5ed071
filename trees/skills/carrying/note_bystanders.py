"""Note where everything else stands before the hand goes there."""

from __future__ import annotations

from py_trees.common import Status

from trees.beliefs.scene.bystanders import bystanders
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE, Leaf
from trees.nodes.ports import ports


class NoteBystanders(Leaf):
    """Write down where all movable things stand that no hand holds.

    A later leaf compares, and so finds out whether the hand has pushed one of them.
    """

    INPUT_PORTS = ports()
    OUTPUT_PORTS = ports(stood=dict)
    CONTRACT = Contract(
        precondition="a look was taken",
        postcondition="the places are those of the world model",
        deadline_s=1.0,
    )

    def step(self) -> Status | Failure:
        """Note them."""
        stood = bystanders(self.toolbox.world.scene)
        self._set_output("stood", stood)
        self.feedback_message = f"{len(stood)} things stand about"
        return DONE
