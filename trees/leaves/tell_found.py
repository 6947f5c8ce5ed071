"""Tell where something was found."""

from __future__ import annotations

from py_trees.common import Status

from trees.contract import Contract
from trees.destination import Place
from trees.events import Said
from trees.failures import Failure, Number
from trees.leaf import DONE, Leaf
from trees.ports import ports


class TellFound(Leaf):
    """Say where what was looked for is, and how sure that is."""

    INPUT_PORTS = ports(place=Place)
    OUTPUT_PORTS = ports(evidence=dict)
    CONTRACT = Contract(
        precondition="it was seen",
        postcondition="its place in the odometry frame was said, with the confidence of the sighting",
        deadline_s=1.0,
    )

    def step(self) -> Status | Failure:
        """Say it."""
        place: Place = self.get_input("place")
        x, y, z = (float(value) for value in place.odom_T_place[:3, 3])
        side = f"{abs(y):.2f} m to the {'left' if y > 0.0 else 'right'}"
        words = f"the {place.name} is {x:.2f} m ahead, {side}"
        if place.category == "person":
            words = words.removeprefix("the ")
        self.toolbox.events(Said(self.toolbox.clock.now_s(), words))
        evidence: dict[str, Number] = {
            "found": place.name,
            "x_m": x,
            "y_m": y,
            "z_m": z,
            "confidence": place.confidence,
        }
        self.measured(**evidence)
        self._set_output("evidence", {"said": words, **evidence})
        self.feedback_message = words
        return DONE
