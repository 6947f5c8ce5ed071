"""Tell where something was found."""

from __future__ import annotations

from collections.abc import Iterator

from py_trees.common import Status

from kinematics.support import support_of
from robots.articulated import ARTICULATED_KINDS
from trees.contract import Contract
from trees.destination import Place
from trees.events import Said
from trees.failures import Failure, Number
from trees.leaf import DONE, Leaf
from trees.odometry import feet_pose
from trees.ports import ports
from trees.report_words import direction
from trees.scene_update import kind_of


class TellFound(Leaf):
    """Say where what was looked for is, and how sure that is."""

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
        words = (
            f"{called} is {', '.join([*self._around(place), direction(*feet_pose(self.toolbox).sees(x, y))])}"
        )
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

    def _around(self, place: Place) -> Iterator[str]:
        """What it stands on, and in which room, where that is known: who asked may be elsewhere by now."""
        scene, gap_m = self.toolbox.world.scene, self.toolbox.policy.support_gap_m
        item = scene.objects.get(place.name)
        support = support_of(item, scene, gap_m) if item is not None and item.movable else None
        if support is not None and kind_of(support.name) not in ARTICULATED_KINDS:  # in those, mostly
            yield f"on the {kind_of(support.name)}"
        x_m, y_m = (float(value) for value in place.odom_T_place[:2, 3])
        for room, region in self.toolbox.places.items():
            if region.contains(x_m, y_m):
                yield f"in the {room}"
