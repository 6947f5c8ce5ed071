"""Tell, before anything is picked up, when it is to go into a drawer that is shut."""

from __future__ import annotations

from collections.abc import Mapping

from py_trees.common import Status

from robots.perception.object_estimate import ObjectEstimate
from trees.contract import Contract
from trees.drawer_inside import inside_of_drawer
from trees.failures import Failure, FailureKind
from trees.handles import DRAWER, MEANT_BY
from trees.leaf import DONE
from trees.look_around import LookAround
from trees.ports import ports
from trees.tasks import ObjectDescription, PutInTask


class NotShut(LookAround):
    """Look whether the drawer that the task names is open; succeeds at once for what does not open.

    What is not seen from here is left to a later look.
    """

    INPUT_PORTS = ports(task=PutInTask)
    OUTPUT_PORTS = ports()
    CONTRACT = Contract(
        precondition="the head is at rest",
        postcondition="the task names no drawer that was seen to be shut",
        deadline_s=2.0,
    )

    def step(self) -> Status | Failure:
        """Look only when it matters."""
        to = self.get_input("task").to
        noun = to.kind if isinstance(to, ObjectDescription) else to
        return super().step() if MEANT_BY.get(str(noun)) == DRAWER else DONE

    def found(self, seen: Mapping[str, ObjectEstimate]) -> Status | Failure:
        """What was seen before counts as well."""
        del seen
        inside = inside_of_drawer(self.toolbox.world.scene)
        shut = isinstance(inside, Failure) and inside.kind is FailureKind.INFEASIBLE
        return inside if isinstance(inside, Failure) and shut else DONE
