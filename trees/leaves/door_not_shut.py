"""Tell, before anything is picked up, when it is to go behind a door that is shut."""

from __future__ import annotations

from collections.abc import Mapping

from py_trees.common import Status

from robots.perception.object_estimate import ObjectEstimate
from trees.contract import Contract
from trees.failures import Failure, FailureKind
from trees.fridge_inside import inside_of_fridge
from trees.leaf import DONE
from trees.look_around import LookAround
from trees.ports import ports


class DoorNotShut(LookAround):
    """Look whether the door is open; what is not seen from here is left to a later look."""

    INPUT_PORTS = ports()
    OUTPUT_PORTS = ports()
    CONTRACT = Contract(
        precondition="the head is at rest",
        postcondition="no door is believed to be shut, or less open than an arm needs",
        deadline_s=2.0,
    )
    LOOKING_ON = True

    def found(self, seen: Mapping[str, ObjectEstimate]) -> Status | Failure:
        """What was seen before counts as well."""
        del seen
        inside = inside_of_fridge(self.toolbox.world.scene)
        shut = isinstance(inside, Failure) and inside.kind is FailureKind.INFEASIBLE
        return inside if isinstance(inside, Failure) and shut else DONE
