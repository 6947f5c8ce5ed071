"""Tell whether things may stand where no look has shown, on what a question is about."""

from __future__ import annotations

from py_trees.common import Status
from py_trees.ports import PortInformation

from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE
from trees.nodes.ports import ports
from trees.skills.telling.telling_leaf import TellingLeaf


class MuchIsHidden(TellingLeaf):
    """Succeed if a hidden part of the furniture in question is large enough for another thing."""

    ASKS = True
    INPUT_PORTS = ports(task=object, sightings=PortInformation(dict, default_value={}))
    OUTPUT_PORTS = ports()
    CONTRACT = Contract(
        precondition="it was looked at",
        postcondition="another look past what hides a part of it may show more",
        deadline_s=1.0,
    )

    def step(self) -> Status | Failure:
        """Count the places."""
        return DONE if self.much_is_hidden() else Failure.postcondition("nothing of it is hidden")
