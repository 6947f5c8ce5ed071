"""Learn from a failed attempt which spot not to try again."""

from __future__ import annotations

from py_trees.common import Status
from py_trees.ports import PortInformation

from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE, Leaf
from trees.nodes.ports import optional, ports
from trees.port_values import Placement


class ExcludeSpot(Leaf):
    """Note after a failed attempt that its spot is not to be tried again."""

    INPUT_PORTS = ports(
        placement=optional(Placement), blocked=PortInformation(frozenset, default_value=frozenset())
    )
    OUTPUT_PORTS = ports(blocked_now=frozenset)
    CONTRACT = Contract(
        precondition="an attempt has failed",
        postcondition="the next plan uses another spot",
        deadline_s=1.0,
    )

    def step(self) -> Status | Failure:
        """Remember it."""
        blocked: frozenset[tuple[float, float]] = self.get_input("blocked")
        placement: Placement | None = self.optional("placement")
        if placement is not None:
            blocked = blocked | {placement.spot}
        self._set_output("blocked_now", blocked)
        self.feedback_message = f"{len(blocked)} spots excluded"
        return DONE
