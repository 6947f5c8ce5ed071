"""Tell where something was found."""

from __future__ import annotations

from py_trees.common import Status

from trees.beliefs.grounding.destination import Place
from trees.beliefs.scene.scene_update import kind_of
from trees.events import Said
from trees.failures import Failure, Number
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE, Leaf
from trees.nodes.ports import ports
from trees.skills.telling.whereabouts import where_it_is


class TellFound(Leaf):
    """Say where the thing or person is that was looked for, and how sure that is."""

    INPUT_PORTS = ports(place=Place)
    OUTPUT_PORTS = ports(evidence=dict)
    CONTRACT = Contract(
        precondition="it was seen",
        postcondition="where it is from where the robot stands was said; its place in the odometry frame "
        "and the confidence of the sighting are told with it",
        deadline_s=1.0,
    )

    def step(self) -> Status | Failure:
        """Say it."""
        place: Place = self.get_input("place")
        x, y, z = (float(value) for value in place.odom_T_place[:3, 3])
        called = place.name if place.category == "person" else f"the {kind_of(place.name)}"
        words = f"{called} is {where_it_is(place.name, x, y, self.toolbox)}"
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
