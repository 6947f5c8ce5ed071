"""Tell at once when what is to be closed is nothing that is pushed shut."""

from __future__ import annotations

from py_trees.common import Status

from robots.scenes.articulated import DOOR
from trees.beliefs.grounding.articles import with_article
from trees.beliefs.openings.handles import MEANT_BY
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE, Leaf
from trees.nodes.ports import ports
from trees.tasks import ObjectDescription


class NamesDoor(Leaf):
    """Fail when the task names a drawer, which is closed by its handle; succeed in all other cases."""

    INPUT_PORTS = ports(task=object)
    OUTPUT_PORTS = ports()
    CONTRACT = Contract(
        precondition="none",
        postcondition="the task names a door, or leaves open what it is about",
        deadline_s=1.0,
    )

    def step(self) -> Status | Failure:
        """Look at the noun."""
        wanted = self.get_input("task").object
        noun = wanted.kind if isinstance(wanted, ObjectDescription) else None
        if noun is not None and MEANT_BY.get(noun, DOOR) != DOOR:
            return Failure.infeasible(f"{with_article(noun)} is closed by its handle")
        return DONE
