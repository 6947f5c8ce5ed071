"""Tell where something was found: on what, in which room, and how far from the robot."""

from __future__ import annotations

from collections.abc import Iterator

from py_trees.common import Status

from kinematics.scene.support_of import support_of
from robots.scenes.articulated import ARTICULATED_KINDS
from trees.beliefs.grounding.destination import Place
from trees.beliefs.grounding.report_words import direction
from trees.beliefs.scene.scene_update import kind_of
from trees.events import Said
from trees.failures import Failure, Number
from trees.nodes.contract import Contract
from trees.nodes.leaf import DONE, Leaf
from trees.nodes.ports import ports
from trees.readings.odometry import feet_pose
from trees.toolbox import Toolbox


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


def where_it_is(name: str, x_m: float, y_m: float, toolbox: Toolbox) -> str:
    """Where a thing or a person is: "on the counter, in the kitchen, 1.20 m ahead".

    Args:
        name: In the planning scene.
        x_m, y_m: Its place in the odometry frame.
        toolbox: What knows where the robot stands.
    """
    ahead = direction(*feet_pose(toolbox).sees(x_m, y_m))
    return ", ".join([*_around(name, x_m, y_m, toolbox), ahead])


def _around(name: str, x_m: float, y_m: float, toolbox: Toolbox) -> Iterator[str]:
    """What it stands on, and in which room, where that is known: who asked may be elsewhere by now."""
    scene, gap_m = toolbox.world.scene, toolbox.policy.support_gap_m
    item = scene.objects.get(name)
    support = support_of(item, scene, gap_m) if item is not None and item.movable else None
    if support is not None and kind_of(support.name) not in ARTICULATED_KINDS:  # in those, mostly
        yield f"on the {kind_of(support.name)}"
    for room, region in toolbox.places.items():
        if region.contains(x_m, y_m):
            yield f"in the {room}"
