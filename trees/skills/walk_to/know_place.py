"""Know where a place is: from the map, or because the robot began there."""

from __future__ import annotations

from py_trees.common import Status

from trees.beliefs.grounding.destination import START, Place, aim_of, place_of_region, start
from trees.failures import Failure
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE, Leaf
from trees.nodes.ports import ports


class KnowPlace(Leaf):
    """Find what the task is aimed at among the regions of the map, or as the place where the robot began."""

    INPUT_PORTS = ports(task=object)
    OUTPUT_PORTS = ports(place=Place)
    CONTRACT = Contract(
        precondition="none",
        postcondition="the region of that name, where the map has it, or the place where odometry began",
        deadline_s=1.0,
    )
    ASKS = True

    def step(self) -> Status | Failure:
        """Look it up."""
        aim, places = aim_of(self.get_input("task")), self.toolbox.places
        if aim == START and aim not in places:
            self._set_output("place", start())
            return DONE
        if not isinstance(aim, str) or aim not in places:
            known = ", ".join(sorted(places)) or "nothing"
            return Failure.postcondition(f"there is no {aim} on the map", known=known)
        self._set_output("place", place_of_region(aim, places[aim]))
        return DONE
