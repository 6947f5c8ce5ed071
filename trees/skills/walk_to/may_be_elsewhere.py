"""Tell whether what a task is aimed at is worth looking for far from where it was said to be."""

from __future__ import annotations

from py_trees.common import Status

from trees.beliefs.grounding.destination import aim_of
from trees.beliefs.openings.handles import MEANT_BY
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE, Leaf
from trees.nodes.ports import ports
from trees.tasks import ObjectDescription


class MayBeElsewhere(Leaf):
    """Succeed if it is worth looking for the object far from where it was said to be.

    It is not for an object that is to be taken out of something with a door: that is seen from before the
    door, or it is not in there.
    """

    ASKS = True
    INPUT_PORTS = ports(task=object)
    OUTPUT_PORTS = ports()
    CONTRACT = Contract(
        precondition="it was looked for from here, to all sides",
        postcondition="what the task is aimed at was not said to be behind a door",
        deadline_s=1.0,
    )

    def step(self) -> Status | Failure:
        """Look at the words."""
        aim = aim_of(self.get_input("task"))
        if not isinstance(aim, ObjectDescription) or aim.relation is None:
            return DONE
        where = aim.relation
        if where.kind not in ("in", "on") or str(where.to) not in MEANT_BY:
            return DONE
        return Failure.infeasible(f"no {aim.kind or 'such thing'} was seen in the {where.to}")
