"""Believe no longer that the target is where it was."""

from __future__ import annotations

from py_trees.common import Status

from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE, Leaf
from trees.nodes.ports import optional, ports
from trees.port_values import Target


class ForgetTarget(Leaf):
    """Take the target out of the world model, after a look that should have shown it and did not.

    Otherwise the search that follows would take what it finds for a second object beside the target.
    """

    INPUT_PORTS = ports(target=optional(Target))
    OUTPUT_PORTS = ports()
    CONTRACT = Contract(
        precondition="nobody knows where the target is",
        postcondition="the world model holds no target",
        deadline_s=1.0,
    )

    def step(self) -> Status | Failure:
        """Forget it, if it was ever seen."""
        target: Target | None = self.optional("target")
        world = self.toolbox.world
        if target is not None and target.name in world.scene.objects:
            world.update(world.scene.without_object(target.name))
        return DONE
