"""See where what a task is aimed at is."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from py_trees.common import Status

from robots.perception.object_estimate import ObjectEstimate
from trees.contract import Contract
from trees.destination import SLOTS, Place, aim_of, resolve
from trees.failures import Failure
from trees.leaf import DONE
from trees.look_around import LookAround
from trees.ports import ports
from trees.toolbox import Toolbox


class Locate(LookAround):
    """Look once, and find the object, piece of furniture or person that the task is aimed at.

    A search looks from many sides: that it is not seen from one of them is an answer.
    """

    ASKS = True
    INPUT_PORTS = ports(task=object)
    OUTPUT_PORTS = ports(place=Place)
    CONTRACT = Contract(
        precondition="the head is at rest",
        postcondition="exactly one thing that fits was seen; everything seen is in the world model",
        deadline_s=2.0,
    )

    def __init__(self, name: str, toolbox: Toolbox, slots: Sequence[str] = SLOTS) -> None:
        super().__init__(name, toolbox)
        self._slots = slots

    def found(self, seen: Mapping[str, ObjectEstimate]) -> Status | Failure:
        """Choose what is meant."""
        place = resolve(aim_of(self.get_input("task"), self._slots), seen, self.around())
        if isinstance(place, Failure):
            return place
        self._set_output("place", place)
        x, y, z = place.odom_T_place[:3, 3]
        self.feedback_message = f"{place.name} at {x:.2f}, {y:+.2f}, {z:.2f} m"
        return DONE
