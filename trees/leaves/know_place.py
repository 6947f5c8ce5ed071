"""Know from the map where a place is."""

from __future__ import annotations

from py_trees.common import Status

from kinematics.shapes import Box
from kinematics.walking.planar import PlanarPose
from trees.contract import Contract
from trees.destination import Place, aim_of
from trees.failures import Failure
from trees.leaf import DONE, Leaf
from trees.ports import ports

_HEIGHT_M = 2.0


class KnowPlace(Leaf):
    """Find what the task is aimed at among the named regions of the map; nothing is looked at."""

    INPUT_PORTS = ports(task=object)
    OUTPUT_PORTS = ports(place=Place)
    CONTRACT = Contract(
        precondition="none",
        postcondition="the region of that name, where the map has it",
        deadline_s=1.0,
    )
    ASKS = True

    def step(self) -> Status | Failure:
        """Look it up."""
        aim, places = aim_of(self.get_input("task")), self.toolbox.places
        if not isinstance(aim, str) or aim not in places:
            known = ", ".join(sorted(places)) or "nothing"
            return Failure.postcondition(f"there is no {aim} on the map", known=known)
        region = places[aim]
        pose = PlanarPose(*region.position_m, region.yaw_rad).transform(0.5 * _HEIGHT_M)
        box = Box((*region.size_m, _HEIGHT_M))
        self._set_output("place", Place(aim, "region", box, pose, 1.0))
        return DONE
